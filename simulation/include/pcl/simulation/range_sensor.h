/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/simulation/building.h>
#include <pcl/simulation/point_xyz_scene.h>

#include <functional>
#include <vector>

namespace pcl::indoor {

/** \brief How surfaces answer the rays of a sensor, and what it measures. */
struct EchoOptions {
  double min_range = 0.3;  ///< metres; nearer surfaces give no echo (>= 0)
  double max_range = 30.0; ///< metres; farther surfaces give no echo (> min_range)
  double noise = 0.008;    ///< standard deviation of a range, metres (>= 0)
  double beam = 0;         ///< standard deviation of the directions in a beam, radians
                           ///< (0 ... 0.1); above 0 there are mixed pixels
  double dropout = 0.02;   ///< share of echoes lost at right angles (0 ... 1)
  double grazing_exponent = 6.0; ///< larger: fewer echoes lost at grazing angles (> 0)
  double glass_echo = 0.05;      ///< share of rays that the glass itself returns
  double glass_ghost = 0.05;     ///< share of rays that glass mirrors
  std::uint32_t seed = 1;        ///< same seed, same scan
  int threads = 0;               ///< 0 = automatic; does not change the result
  /** Called now and then with poses done and poses in all; never by two threads at
   * once. */
  std::function<void(std::size_t, std::size_t)> progress;
};

/** \brief Properties of a range sensor that is put up at some positions. */
struct RangeSensorOptions : EchoOptions {
  int rays_per_pose = 30000; ///< evenly over the sphere (>= 1)
  double drift = 0.01;       ///< standard deviation of a pose's error, metres (>= 0)
};

/** \brief A scan and how many rays made it. */
struct SimulatedScan {
  std::vector<PointXYZScene> points; ///< pose by pose
  std::vector<std::uint32_t> poses;  ///< for each point, which pose saw it
  std::size_t ray_count = 0;
};

/** \brief Probability that a surface returns an echo.
 * \param[in] cosine of the angle between ray and normal; its sign does not matter
 * \return (1 - dropout) * (1 - (1 - |cosine|)^grazing_exponent)
 */
PCL_INDOOR_EXPORTS double
echoProbability(double cosine, const EchoOptions& options);

/** \brief Scan a building from some positions.
 *
 * Rays leave each position evenly over the sphere. An echo is lost with a probability
 * that grows towards grazing angles; a range gets Gaussian noise along its ray; all
 * points of one position share an error of position and heading, so that walls appear
 * double. A beam of some width that meets an edge may hit two surfaces; if they are
 * less than 0.5 m apart, the point lies anywhere between the nearer to its middle and
 * half way to the other (a mixed pixel). Where a ray meets glass, a few return at once,
 * a few go on mirrored and are recorded on the straight ray behind the glass (category
 * "ghost", room 0), the others pass or, through an outer window, are lost. A point
 * carries the labels of the surface. Time grows with poses * rays_per_pose.
 * \throws BadArgumentException if an option is out of its range
 */
PCL_INDOOR_EXPORTS SimulatedScan
scanBuilding(const Building& building,
             const std::vector<Eigen::Vector3d>& positions,
             const RangeSensorOptions& options);

/** \brief Keep the first point of every cube of a regular grid, in the given order.
 * \param[in,out] scan thinned in place
 * \param[in] leaf_size edge of a cube, metres; 0 keeps all points
 * \throws BadArgumentException if leaf_size is negative or below 1 mm
 */
PCL_INDOOR_EXPORTS void
thinScan(SimulatedScan& scan, double leaf_size);

} // namespace pcl::indoor
