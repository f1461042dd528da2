/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/wall_casings.h"

#include "objects/structure/point_groups.h"

#include <algorithm>
#include <cmath>

namespace {

using pcl::indoor::SegmentMembers;
using pcl::indoor::StructurePlane;

/** Share of a casing's points that may be farther off, and that lie behind the wall. */
constexpr double few = 0.05;

bool
reachesBehind(const StructurePlane& wall,
              const std::vector<Eigen::Vector3f>& points,
              const SegmentMembers& members,
              double voxel_size)
{
  const auto behind =
      std::count_if(members.begin(), members.end(), [&](std::uint32_t i) {
        return wall.heightOf(points[i].cast<double>()) < -voxel_size;
      });
  return static_cast<double>(behind) >= few * static_cast<double>(members.size());
}

} // namespace

namespace pcl::indoor {

bool
isThinAlong(const StructurePlane& plane,
            const std::vector<Eigen::Vector3f>& points,
            const std::vector<std::uint32_t>& members)
{
  const double allowed = few * static_cast<double>(members.size());
  double far = 0;
  return std::all_of(members.begin(), members.end(), [&](std::uint32_t i) {
    far += std::abs(plane.heightOf(points[i].cast<double>())) > casing_depth;
    return far <= allowed;
  });
}

std::vector<std::uint8_t>
flagStructureAndCasings(const ObjectScene& scene,
                        const std::vector<std::uint32_t>& segment_of_point)
{
  std::vector<std::uint8_t> flags(scene.points.size(), 0);
  if (scene.points.empty() || scene.planes.empty())
    return flags;
  const auto groups = groupPoints(scene, segment_of_point);
  const auto flag = [&flags](const SegmentMembers& members) {
    for (const auto i : members)
      flags[i] = 1;
  };
  for (std::size_t p = 0; p < scene.planes.size(); ++p) {
    const auto& plane = scene.planes[p];
    flag(groups.planes.members[p]);
    if (!areAcross(plane.normal, scene.up.cast<double>()))
      continue;
    const auto reach = widened(groups.planes.boxes[p], casing_depth);
    for (std::size_t s = 0; s < groups.objects.members.size(); ++s) {
      const auto& members = groups.objects.members[s];
      if (reach.intersects(groups.objects.boxes[s]) &&
          isThinAlong(plane, scene.points, members) &&
          reachesBehind(plane, scene.points, members, scene.voxel_size))
        flag(members);
    }
  }
  return flags;
}

} // namespace pcl::indoor
