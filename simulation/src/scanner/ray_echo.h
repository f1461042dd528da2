/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/random_draw.h>
#include <pcl/simulation/range_sensor.h>

#include <vector>

namespace pcl::indoor {

/** \brief At this distance, metres, an error of heading moves points as far as that of
 * the position does. */
constexpr double typical_range = 5.0;

/** \brief A building, ready for rays. */
struct RayScene {
  const Building& building;
  RayTracer tracer;
  std::vector<Eigen::Vector3f> normals; ///< of the triangles, unit length
  std::uint32_t ghost;                  ///< number of the category

  explicit RayScene(const Building& building);
};

/** \brief What a ray brings back: the way it went, and the triangle that sent it back.
 */
struct Echo {
  float range = 0.0f; ///< metres
  int triangle = -1;  ///< -1: nothing
  bool mirrored = false;
  bool unhindered = false; ///< nothing was in the way as far as the ray was followed
};

/** \brief Send out a beam of some width, of which a share hits what is beside its
 * middle.
 * \param[in] direction of unit length
 * \param[in] reach no farther than this, and not beyond the sensor's range, metres
 */
Echo
followBeam(const RayScene& scene,
           const Eigen::Vector3f& origin,
           const Eigen::Vector3f& direction,
           float reach,
           const EchoOptions& options,
           RandomDraw& draw);

/** \brief Put a point somewhere, metres. */
void
place(PointXYZScene& point, const Eigen::Vector3d& at);

/** \brief The point of an echo, with the labels of its surface. */
PointXYZScene
labelledPoint(const RayScene& scene, const Echo& echo, const Eigen::Vector3d& at);

/** \throws BadArgumentException if an option is out of its range */
void
requireLegal(const EchoOptions& options);

/** \brief What one pose of a sensor sees: its number, and its own random numbers. */
using PoseScan =
    std::function<std::vector<PointXYZScene>(std::size_t pose, RandomDraw draw)>;

/** \brief Scan from all poses, in parallel; the result is in the order of the poses. */
SimulatedScan
scanFromPoses(std::size_t poses,
              std::size_t rays_per_pose,
              const EchoOptions& options,
              const PoseScan& scan_from);

} // namespace pcl::indoor
