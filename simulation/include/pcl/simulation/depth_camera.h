/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/simulation/building.h>
#include <pcl/simulation/point_xyz_scene.h>
#include <pcl/simulation/trajectory.h>

#include <pcl/point_cloud.h>

#include <Eigen/Core>

#include <cstdint>

namespace pcl::indoor {

/** \brief Properties of a camera that measures depth by a projected pattern; the
 * defaults are those of a Kinect. */
struct DepthCameraOptions {
  int width = 640, height = 480; ///< pixels (>= 1)
  double focal_length = 525;     ///< pixels (> 0)
  double baseline = 0.075;       ///< from the camera to the projector, metres (> 0)
  double noise = 0.08;           ///< standard deviation of a disparity, pixels (>= 0)
  double step = 0.125;           ///< of the disparities, pixels (> 0)
  double min_range = 0.5;        ///< nearest depth, metres (>= 0)
  double max_range = 5.0;        ///< farthest depth, metres (> min_range)
  double least_cosine = 0.1;     ///< of the angle at which surfaces are seen (0 ... 1)
  int patch = 4;         ///< pixels from one independent error to the next (>= 1)
  double distortion = 0; ///< standard deviation of an error of the disparity that all
                         ///< views have, smooth over the image, pixels (>= 0)
  double edge_noise = 0; ///< standard deviation of where a pixel looks, pixels (>= 0)
  double mixed = 0; ///< share of the pixels at edges that lie between the two surfaces
                    ///< where these are at most 0.5 m apart (0 ... 1)
  double dark = 0;  ///< share of parts that return too little light (0 ... 1)
  std::uint32_t seed = 1; ///< same seed, same view
};

/** \brief Where a camera is, and what is in the middle of its view; metres. */
struct CameraPose {
  Eigen::Vector3d position, target;
};

/** \brief Draw a view as somebody who walks through the building may have it.
 *
 * From one of the positions of the walk to the middle of an object that is seen from
 * there, 1 to 4 m away.
 * \throws BadArgumentException if an option is out of its range, or no position sees an
 * object
 */
PCL_INDOOR_EXPORTS CameraPose
drawCameraPose(const Building& building,
               const TrajectoryOptions& walk,
               std::uint32_t seed);

/** \brief See a building with a depth camera.
 *
 * A pixel has no depth where the surface is out of range, seen at a grazing angle, of
 * glass, or not lit by the projector, which is on the right of the camera. Noise is of
 * the disparity, so that of the depth grows with its square, and alike for pixels a few
 * apart, as patches of the pattern are compared.
 * \return organised, in the frame of the camera: x to the right, y down, z forwards;
 * NaN and labels 0 where there is no depth
 * \throws BadArgumentException if an option is
 * out of its range, or the target is where the camera is
 */
PCL_INDOOR_EXPORTS PointCloud<PointXYZScene>
viewBuilding(const Building& building,
             const CameraPose& pose,
             const DepthCameraOptions& options);

} // namespace pcl::indoor
