/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>

namespace pcl::indoor::tool {

/** \brief How a scan differs from the surface of an object. */
struct Disturbance {
  double noise_percent =
      0.0; ///< standard deviation, in per cent of the object's extent
  double hidden_percent = 0.0; ///< share of the points that a single view does not see
};

/** \brief Move every point by Gaussian noise, the same in all directions.
 *
 * Normals are not touched; they have to be estimated anew.
 */
void
addNoise(PointCloud<PointNormal>& cloud, double percent, std::uint32_t seed);

/** \brief Remove the points that a camera far away, in a random direction, sees least.
 *
 * The points are drawn into a depth image whose pixels are as wide as twice the
 * distance of samples; a point is hidden by as much as it lies behind the nearest one
 * in its pixel. The most hidden ones go, of equal ones the farther ones.
 */
void
hideFromView(PointCloud<PointNormal>& cloud, double percent, std::uint32_t seed);

/** \brief Both, the view first; after noise normals are estimated anew. */
void
disturb(PointCloud<PointNormal>& cloud,
        const Disturbance& disturbance,
        int neighbor_count,
        std::uint32_t seed);

} // namespace pcl::indoor::tool
