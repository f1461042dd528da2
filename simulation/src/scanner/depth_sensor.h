/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/depth_camera.h>

#include <vector>

namespace pcl::indoor {

/** \brief What a pixel of a depth camera measures, and of what. */
struct DepthPixel {
  double depth = 0.0; ///< along the axis of the camera, metres; 0: none
  int triangle = -1;  ///< of the building; -1: none
};

/** \brief Where a camera is and how it is turned. */
struct CameraFrame {
  Eigen::Vector3d position;
  Eigen::Matrix3d axes; ///< right, down and forwards, as columns
};

/** \brief A frame that looks at the target of a pose, upright.
 * \throws BadArgumentException if the target is where the camera is */
CameraFrame
frameOf(const CameraPose& pose);

/** \brief The ray through the middle of a pixel, in the frame of the camera: depth 1.
 */
inline Eigen::Vector3d
rayThrough(double u, double v, const DepthCameraOptions& options)
{
  return {(u - 0.5 * (options.width - 1)) / options.focal_length,
          (v - 0.5 * (options.height - 1)) / options.focal_length,
          1};
}

/** \brief A depth camera in a building: what viewBuilding() does, view by view. Seeing
 * does not change the object: any number of threads may see. */
class DepthSensor {
public:
  /** \throws BadArgumentException if an option is out of its range */
  DepthSensor(const Building& building, const DepthCameraOptions& options);

  /** \brief See.
   * \param[in] seed of the noise of this view
   * \return options.width * options.height pixels, row by row */
  std::vector<DepthPixel>
  see(const CameraFrame& frame, std::uint32_t seed) const;

  const RayTracer&
  tracer() const
  {
    return tracer_;
  }

private:
  class View;

  const Building& building_;
  DepthCameraOptions options_;
  RayTracer tracer_;
  std::vector<char> is_blind_; ///< of each triangle: glass or dark
};

} // namespace pcl::indoor
