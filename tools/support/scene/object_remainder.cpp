/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/object_remainder.h"

#include <pcl/segmentation/objects/room_structure.h> // for StructureKind

#include <utility>

namespace pcl::indoor::tool {

void
separateRemainder(RoomObjects& objects, std::size_t fewest)
{
  constexpr auto remainder = static_cast<std::uint32_t>(StructureKind::Remainder);
  auto& object_of_point = objects.object_of_point;
  auto& structure_of_point = objects.structure_of_point;
  std::vector<std::size_t> counts(objects.surfaces.size() + 1, 0);
  for (std::size_t i = 0; i < object_of_point.size(); ++i)
    if (structure_of_point[i] != remainder)
      ++counts[object_of_point[i]];

  std::vector<std::uint32_t> numbers(counts.size(), 0);
  std::vector<ObjectSurface> surfaces;
  for (std::size_t object = 1; object < counts.size(); ++object)
    if (counts[object] >= fewest) {
      surfaces.push_back(std::move(objects.surfaces[object - 1]));
      numbers[object] = static_cast<std::uint32_t>(surfaces.size());
    }
  objects.surfaces = std::move(surfaces);
  for (std::size_t i = 0; i < object_of_point.size(); ++i) {
    const auto number = numbers[object_of_point[i]];
    if (object_of_point[i] > 0 && number == 0)
      structure_of_point[i] = remainder;
    object_of_point[i] = number;
  }
}

} // namespace pcl::indoor::tool
