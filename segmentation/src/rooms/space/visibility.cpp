/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/visibility.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace pcl::indoor {
namespace {

/** The crossings of one axis' voxel borders along a line, in a time common to all axes:
 * twice the product of the three extents is the time at the end.
 */
struct AxisCrossings {
  std::int64_t next;     // time of the next crossing
  std::int64_t interval; // between crossings
  std::ptrdiff_t stride; // in memory, with the sign of the direction
};

AxisCrossings
crossings(int extent, std::int64_t product, std::ptrdiff_t stride)
{
  if (extent == 0)
    return {std::numeric_limits<std::int64_t>::max(), 0, 0};
  const std::int64_t half = product / std::abs(extent);
  return {half, 2 * half, extent > 0 ? stride : -stride};
}

} // namespace

bool
lineOfSight(const VoxelMap<std::uint8_t>& occupancy,
            const Eigen::Vector3i& a,
            const Eigen::Vector3i& b)
{
  const Eigen::Vector3i extent = b - a;
  std::int64_t product = 1;
  for (int axis = 0; axis < 3; ++axis)
    product *= std::max(std::abs(extent[axis]), 1);
  const auto row = static_cast<std::ptrdiff_t>(occupancy.shape.nz);
  AxisCrossings x = crossings(extent.x(), product, row * occupancy.shape.ny);
  AxisCrossings y = crossings(extent.y(), product, row);
  AxisCrossings z = crossings(extent.z(), product, 1);
  const std::uint8_t* voxel =
      occupancy.values.data() + occupancy.shape.index(a.x(), a.y(), a.z());
  const std::uint8_t* end =
      occupancy.values.data() + occupancy.shape.index(b.x(), b.y(), b.z());
  while (voxel != end) {
    const std::int64_t time = std::min({x.next, y.next, z.next});
    // through an edge or a corner: straight into the voxel beyond
    for (AxisCrossings* axis : {&x, &y, &z})
      if (axis->next == time) {
        axis->next += axis->interval;
        voxel += axis->stride;
      }
    if (voxel != end && *voxel)
      return false;
  }
  return true;
}

} // namespace pcl::indoor
