/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <cstdint>

namespace pcl::indoor::tool {

/** \brief How a scan differs from the surface of an object. */
struct Disturbance {
  double noise_percent =
      0.0; ///< standard deviation, in per cent of the object's extent
  double hidden_percent = 0.0; ///< share of the points that a single view does not see
  bool estimates_normals = false; ///< anew even where no point was moved
  double normal_radius = 4.0; ///< of a normal's neighbourhood, in deviations of noise
  bool keeps_normals = false; ///< even where points were moved; for who looks at none
  bool before_camera = false; ///< placed before a camera, not as its file has it
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

/** \brief Place an object as a camera has it that is at the origin and looks along z.
 *
 * The camera sees it from the direction that hideFromView() takes for the same seed,
 * rolled at random, and is three extents away from the middle of the points. Nothing
 * that depends on the pose of the object in its file, such as which side is up, is then
 * told by the coordinates.
 */
void
placeBeforeCamera(PointCloud<PointNormal>& cloud, std::uint32_t seed);

/** \brief Neighbours of a normal under noise: those within the disturbance's radius.
 *
 * A plane through points that lie closer than the noise moves them has a direction by
 * chance. A unit object has a surface of about 3; of point_count samples that many lie
 * within normal_radius deviations.
 * \return at least least_count, at most point_count where that is more
 */
int
neighborsUnderNoise(const Disturbance& disturbance,
                    std::size_t point_count,
                    int least_count);

/** \brief The view first, then noise, and the place before the camera; after noise, or
 * if asked for, normals are estimated anew, unless they are kept, from
 * neighborsUnderNoise(), at least neighbor_count. */
PCL_INDOOR_EXPORTS void
disturb(PointCloud<PointNormal>& cloud,
        const Disturbance& disturbance,
        int neighbor_count,
        std::uint32_t seed);

} // namespace pcl::indoor::tool
