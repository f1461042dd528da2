/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "wall_frames.h"

#include "segment_parts.h"

#include <algorithm>
#include <cmath>

namespace {

using pcl::indoor::SegmentMembers;
using pcl::indoor::StructurePlane;

constexpr double max_depth = 0.2;     // metres, on either side of the wall
constexpr double max_outliers = 0.05; // share of a frame's points that are farther off
constexpr double min_behind = 0.05;   // share of a frame's points behind the wall
constexpr double max_tilt = 0.3;      // of a wall, sine

double
heightOf(const StructurePlane& plane, const Eigen::Vector3f& point)
{
  return plane.normal.dot(point.cast<double>()) - plane.offset;
}

bool
goesThrough(const StructurePlane& wall,
            const std::vector<Eigen::Vector3f>& points,
            const SegmentMembers& members,
            double voxel_size)
{
  const auto behind = std::count_if(members.begin(), members.end(), [&](auto i) {
    return heightOf(wall, points[i]) < -voxel_size;
  });
  return static_cast<double>(behind) >=
         min_behind * static_cast<double>(members.size());
}

} // namespace

namespace pcl {
namespace indoor {

bool
isThinAlong(const StructurePlane& plane,
            const std::vector<Eigen::Vector3f>& points,
            const std::vector<std::uint32_t>& members)
{
  const double allowed = max_outliers * static_cast<double>(members.size());
  double far = 0;
  return std::all_of(members.begin(), members.end(), [&](auto i) {
    far += std::abs(heightOf(plane, points[i])) > max_depth;
    return far <= allowed;
  });
}

void
leaveOutWallFrames(const std::vector<Eigen::Vector3f>& points,
                   const std::vector<StructurePlane>& planes,
                   const Eigen::Vector3f& up,
                   double voxel_size,
                   const std::vector<std::uint32_t>& segment_of_point,
                   std::vector<std::uint8_t>& left_out)
{
  if (points.empty())
    return;
  for (const auto& members : membersOfSegments(left_out, segment_of_point)) {
    const bool is_frame =
        !members.empty() &&
        std::any_of(planes.begin(), planes.end(), [&](const auto& plane) {
          return std::abs(plane.normal.dot(up.cast<double>())) < max_tilt &&
                 isThinAlong(plane, points, members) &&
                 goesThrough(plane, points, members, voxel_size);
        });
    for (const auto i : members)
      left_out[i] |= static_cast<std::uint8_t>(is_frame);
  }
}

} // namespace indoor
} // namespace pcl
