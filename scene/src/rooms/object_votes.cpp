/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/object_votes.h"

#include <algorithm>
#include <cstddef>

namespace pcl::indoor::tool {
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

} // namespace pcl::indoor::tool
