/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "scanner/depth_sensor.h"

#include <pcl/simulation/random_draw.h>

#include <vector>

namespace pcl::indoor {

/** \brief How somebody carries a camera through a room. */
struct CameraPathOptions {
  double spacing = 0.9; ///< between places where they stop, metres (> 0)
  double lowest = 1.2;  ///< height of the camera above the floor, metres (> 0)
  double highest = 1.7; ///< metres (>= lowest)
};

/** \brief The views of somebody who stops all through the free space of a room, looks
 * around at each place by a part of a turn, up and down as they turn, and walks on.
 * \param[in] room its number
 * \return none if the room has no free place */
std::vector<CameraFrame>
cameraPath(const Building& building,
           std::uint32_t room,
           const RayTracer& tracer,
           const CameraPathOptions& options,
           RandomDraw draw);

/** \brief Where the frames are taken to be: errors that pass along the path.
 * \param[in] drift standard deviation of a position, and of what is 2 m before the
 * camera by the error of its direction, metres */
std::vector<CameraFrame>
registeredFrames(const std::vector<CameraFrame>& frames, double drift, RandomDraw draw);

} // namespace pcl::indoor
