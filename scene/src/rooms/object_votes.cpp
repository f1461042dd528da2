/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/object_votes.h"

#include <pcl/segmentation/objects/room_structure.h>

#include <algorithm>
#include <cstddef>

namespace pcl::indoor::tool {
namespace {

constexpr float share_of_structure = 0.6f; // more than half costs fewer things

} // namespace

ObjectVotes
votesOf(const RoomObjects& objects)
{
  ObjectVotes votes;
  const auto& object_of_point = objects.object_of_point;
  if (object_of_point.empty())
    return votes;
  const auto& voxels = objects.votes;
  votes.of_object.resize(
      *std::max_element(object_of_point.begin(), object_of_point.end()),
      std::vector<float>(voxels.class_count, 0.0f));
  std::vector<float> counts(votes.of_object.size(), 0.0f);
  for (std::size_t i = 0; i < object_of_point.size(); ++i) {
    if (object_of_point[i] == 0)
      continue;
    const auto object = object_of_point[i] - 1;
    const float* const probabilities = voxels.of(i);
    for (std::size_t c = 0; c < voxels.class_count; ++c)
      votes.of_object[object][c] += probabilities[c];
    ++counts[object];
  }
  for (std::size_t object = 0; object < counts.size(); ++object)
    for (auto& vote : votes.of_object[object])
      vote /= std::max(counts[object], 1.0f);
  return votes;
}

void
nameStructure(const ObjectVotes& votes, RoomObjects& objects)
{
  std::vector<std::uint32_t> kinds(votes.of_object.size(), 0);
  for (std::size_t object = 0; object < kinds.size(); ++object) {
    const auto first = votes.of_object[object].begin();
    const auto end = first + building_classes;
    if (first[0] + first[1] + first[2] > share_of_structure)
      kinds[object] = static_cast<std::uint32_t>(std::max_element(first, end) - first) +
                      static_cast<std::uint32_t>(StructureKind::Floor);
  }
  for (std::size_t i = 0; i < objects.object_of_point.size(); ++i)
    if (const auto object = objects.object_of_point[i];
        object > 0 && objects.structure_of_point[i] == 0)
      objects.structure_of_point[i] = kinds[object - 1];
}

} // namespace pcl::indoor::tool
