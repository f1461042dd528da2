/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "wall_frames.h"

#include "segment_parts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace {

using pcl::indoor::SegmentMembers;
using pcl::indoor::StructurePlane;
using Box = Eigen::AlignedBox3f;

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
reachesBehind(const StructurePlane& wall,
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

std::vector<std::uint8_t>
flagStructureAndFrames(const std::vector<Eigen::Vector3f>& points,
                       const SurfaceVoxels& voxels,
                       const std::vector<StructurePlane>& planes,
                       const std::vector<std::uint32_t>& plane_of_voxel,
                       double voxel_size,
                       const Eigen::Vector3f& up,
                       const std::vector<std::uint32_t>& segment_of_point)
{
  std::vector<std::uint8_t> flags(points.size(), 0);
  if (points.empty() || planes.empty())
    return flags;
  std::vector<Box> around(planes.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const auto plane = plane_of_voxel[voxels.cells.cell_of_point[i]]; plane != 0) {
      flags[i] = 1;
      around[plane - 1].extend(points[i]);
    }
  const Eigen::Vector3f margin =
      Eigen::Vector3f::Constant(static_cast<float>(max_depth));
  for (auto& box : around)
    box = Box(box.min() - margin, box.max() + margin);
  for (const auto& members : membersOfSegments(flags, segment_of_point)) {
    Box segment;
    for (const auto i : members)
      segment.extend(points[i]);
    bool is_frame = false;
    for (std::size_t p = 0; p < planes.size() && !members.empty(); ++p)
      is_frame =
          is_frame || (around[p].intersects(segment) &&
                       std::abs(planes[p].normal.dot(up.cast<double>())) < max_tilt &&
                       isThinAlong(planes[p], points, members) &&
                       reachesBehind(planes[p], points, members, voxel_size));
    for (const auto i : members)
      flags[i] = static_cast<std::uint8_t>(is_frame);
  }
  return flags;
}

} // namespace indoor
} // namespace pcl
