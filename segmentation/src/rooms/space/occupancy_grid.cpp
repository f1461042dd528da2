/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/occupancy_grid.h"

#include "rooms/space/block_extent.h"

#include <pcl/indoor/threads.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::indoor {

namespace {

/** \brief Turns points by -yaw about z: into a frame whose x axis points along yaw. */
class Turn {
public:
  explicit Turn(double yaw)
  : cosine_(std::cos(yaw))
  , sine_(std::sin(yaw))
  {}

  template <typename Vector>
  Eigen::Vector3d
  operator()(const Vector& point) const
  {
    const double x = point.x();
    const double y = point.y();
    return {cosine_ * x + sine_ * y, cosine_ * y - sine_ * x, point.z()};
  }

private:
  double cosine_;
  double sine_;
};

void
requireValid(const OccupancyGridOptions& options)
{
  if (!(options.voxel_size > 0.0) || !std::isfinite(options.voxel_size))
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "The voxel size must be positive, not " << options.voxel_size
                                                                << " m.");
  if (!std::isfinite(options.yaw))
    PCL_THROW_EXCEPTION(BadArgumentException, "The yaw must be finite.");
}

/** \brief The box, in the turned frame, of the points in a box of the frame as it is.
 */
Box
tightBox(const std::vector<Eigen::Vector3f>& points,
         const Turn& turn,
         const Box& outer,
         int threads)
{
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  Box box;
#pragma omp parallel num_threads(threads)
  {
    Box own;
#pragma omp for schedule(static) nowait
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      if (outer.contains(points[i]))
        own.add(turn(points[i]));
    }
#pragma omp critical
    {
      if (own.valid()) {
        box.add(own.low);
        box.add(own.high);
      }
    }
  }
  return box;
}

/** \brief The empty grid around a box. */
VoxelBits
gridAround(const Box& box, double voxel_size)
{
  constexpr int margin = 1; // free voxels on every side
  VoxelBits grid;
  grid.voxel_size = voxel_size;
  // Half a voxel more below, so that the lowest plane of the cloud (noisy itself) does
  // not lie on the border of two layers.
  grid.origin = box.low - Eigen::Vector3d::Constant((margin + 0.5) * voxel_size);
  const Eigen::Vector3d sizes =
      ((box.high - grid.origin) / voxel_size).array().floor() + 1.0 + margin;
  if (!(sizes.prod() < static_cast<double>(std::numeric_limits<std::int32_t>::max())))
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "A grid of " << sizes.x() << " x " << sizes.y() << " x "
                                     << sizes.z() << " voxels of " << voxel_size
                                     << " m is too large.");
  grid.reset({static_cast<int>(sizes.x()),
              static_cast<int>(sizes.y()),
              static_cast<int>(sizes.z())});
  return grid;
}

void
fill(const std::vector<Eigen::Vector3f>& points,
     const Turn& turn,
     const Box& box,
     int threads,
     OccupancyGrid& result)
{
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  const GridShape shape = result.grid.shape;
  const Eigen::Vector3d origin = result.grid.origin;
  const double scale = result.grid.voxel_size;
  result.cells.resize(points.size());
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const Eigen::Vector3d p = turn(points[i]);
    if (!box.contains(p)) {
      result.cells[i] = -1;
      continue;
    }
    // Inside the box the quotients are not negative: the cast is the floor.
    const Eigen::Vector3d scaled = (p - origin) / scale;
    const Eigen::Vector3i voxel = scaled.cast<int>();
    result.cells[i] =
        static_cast<std::int32_t>(shape.index(voxel.x(), voxel.y(), voxel.z()));
    result.grid.set(voxel.x(), voxel.y(), voxel.z());
  }
}

} // namespace

Eigen::Matrix2d
TurnedFrame::turn() const
{
  const Turn turn(yaw);
  Eigen::Matrix2d matrix;
  matrix << turn(Eigen::Vector3d::UnitX()).head<2>(),
      turn(Eigen::Vector3d::UnitY()).head<2>();
  return matrix;
}

Eigen::Vector3d
TurnedFrame::toGrid(const Eigen::Vector3d& point) const
{
  return yaw == 0.0 ? point : Turn(yaw)(point);
}

Eigen::Vector3d
TurnedFrame::toBuilding(const Eigen::Vector3d& point) const
{
  return yaw == 0.0 ? point : Turn(-yaw)(point);
}

OccupancyGrid
occupancyGrid(const std::vector<Eigen::Vector3f>& points,
              const OccupancyGridOptions& options)
{
  requireValid(options);
  const int threads = threadCount(options.threads);
  OccupancyGrid result;
  result.yaw = options.yaw;
  result.grid.voxel_size = options.voxel_size;
  if (points.empty())
    return result;
  const Turn turn(options.yaw);
  const Box box = tightBox(points, turn, blockExtent(points, threads), threads);
  result.grid = gridAround(box, options.voxel_size);
  fill(points, turn, box, threads, result);
  return result;
}

} // namespace pcl::indoor
