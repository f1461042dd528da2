/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/indoor/voxel_bits.h>
#include <pcl/segmentation/building_rooms.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

struct OccupancyGridOptions {
  double voxel_size = 0.2; ///< edge length of a voxel, metres (> 0)
  double yaw = 0.0;        ///< angle of the grid's x axis in the frame of the points,
                           ///< radians, counter-clockwise about z (finite)
  int threads = 0;         ///< number of threads (>= 0; 0 = automatic)
};

/** \brief An occupancy grid and the place of every point in it. */
struct OccupancyGrid : TurnedFrame {
  VoxelBits grid;                  ///< the voxels that hold a point; in the turned
                                   ///< frame
  std::vector<std::int32_t> cells; ///< grid.shape.index(...) of each point's voxel; -1
                                   ///< for points outside the kept extent
};

/** \brief Mark the voxels that hold a point (Sec. 3.2.1.1).
 *
 * The extent of the grid is found first, on coarse blocks: connected parts of the
 * cloud are taken in, largest first, as long as they do not enlarge the box out of
 * proportion, see blockExtent(); around it one layer of voxels is free on every side. A
 * few points hundreds of metres away (seen through or mirrored by glass) thus cost
 * nothing. Time and memory are linear in points, occupied blocks and voxels. The result
 * depends neither on the number of threads nor on the order of the points.
 *
 * \param[in] points finite points near the origin (a float keeps 0.01 mm at 100 m)
 * \param[in] options see OccupancyGridOptions
 * \return the grid; an empty one if there are no points
 * \throws pcl::BadArgumentException if an option is out of range, or if the grid would
 * have 2^31 voxels or more
 */
PCL_INDOOR_EXPORTS OccupancyGrid
occupancyGrid(const std::vector<Eigen::Vector3f>& points,
              const OccupancyGridOptions& options = {});

} // namespace pcl::indoor
