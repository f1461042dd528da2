/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/simulation/depth_camera.h>
#include <pcl/simulation/range_sensor.h> // for SimulatedScan

#include <functional>

namespace pcl::indoor {

/** \brief How rooms are captured by a depth camera in somebody's hand. */
struct PCL_INDOOR_EXPORTS HandCameraOptions {
  DepthCameraOptions camera; ///< its noise and seed count for nothing
  double noise = 0.001;     ///< standard deviation of a depth of 1 m, metres (>= 0); it
                            ///< grows with the square of the depth
  double spacing = 0.9;     ///< between places where they stop, metres (> 0)
  double height = 1.45;     ///< of the camera above the floor, up to 0.25 m more or
                            ///< less, metres (> 0.25)
  double drift = 0.015;     ///< standard deviation of the position in the map, metres
                            ///< (>= 0); the direction's moves what is 2 m away as far
  double voxel_size = 0.02; ///< edge of a voxel that views are fused in, metres
                            ///< (0.005 ... 0.2)
  std::size_t most_points =
      50000;              ///< of a room; of more vertices these are drawn (>= 1)
  std::uint32_t seed = 1; ///< same seed, same scan
  int threads = 0;        ///< 0 = automatic; does not change the result
  /** Called with views done and views in all of the room; never by two threads at once.
   */
  std::function<void(std::size_t, std::size_t)> progress;

  HandCameraOptions();
};

/** \brief Capture a room as people do with a depth camera in their hand.
 *
 * They stop all through the free space, look around by half a turn to a whole one,
 * mostly downwards, and walk on. Each view has the errors of DepthCameraOptions; its
 * place in the map has an error that lasts for some views. Views are fused to a
 * truncated signed distance, and the points are vertices of its surface, as of a mesh
 * by marching cubes. A vertex has the labels that most of what it was fused of has.
 * Corners that no view saw are missing, and so are most ceilings. What is seen through
 * open doors is there, too.
 *
 * \param[in] room its number
 * \return all of pose 0; ray_count counts pixels. Empty if nobody can stand in the room
 *
 * \throws BadArgumentException if an option is out of its range, there is no such room,
 * or the voxels would need more than 2 GB
 */
PCL_INDOOR_EXPORTS SimulatedScan
captureRoom(const Building& building,
            std::uint32_t room,
            const HandCameraOptions& options);

} // namespace pcl::indoor
