/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/object_segmentation.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

constexpr double widest_view = 75;             ///< degrees from the axis of a camera
constexpr float least_camera_distance = 1e-3f; ///< metres

/** \brief Tell how points were taken, if by a camera that looks along z.
 *
 * A camera has 99 % of them in front of it, within widest_view of z. It sees a table if
 * half of what it looks at, within 10 degrees of z, is at most 1.4 m away; or at most
 * 2 m, where most of that is too small for the voxels of a room: their surface
 * variation is above 0.03 in 55 % of voxels of 3 cm within 15 degrees. Else it sees a
 * room.
 * \param[in] points finite, metres
 * \param[in] camera where it would stand
 */
Capture
captureOf(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& camera);

/** \brief Tell whether points are those of a camera's pixels, in any order, all or some
 * of them: x / z and y / z of 1,000 of them are multiples of one step.
 * \param[in] points finite, metres; fewer than 1,000 do not tell
 * \param[in] camera where it would stand
 */
bool
arePixels(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& camera);

/** \brief The median of z of what a camera looks at, within 10 degrees of z; NaN if
 * there is nothing. */
float
distanceInMiddle(const std::vector<Eigen::Vector3f>& points,
                 const Eigen::Vector3f& camera);

/** \brief Find which direction is up in the view of a camera, whose y points down
 * within 45 degrees.
 *
 * Floors and walls tell: the direction is turned, five times, to where the normals
 * within 45 degrees of it are most parallel to it and all others most across, and five
 * times so with those within 15 degrees (S. Gupta et al., "Perceptual Organization and
 * Recognition of Indoor Scenes from RGB-D Images", CVPR 2013).
 * \param[in] normals unit length, or of no length, which do not count
 * \return unit length; -y if there are no normals
 */
Eigen::Vector3f
upOfView(const std::vector<Eigen::Vector3f>& normals);

} // namespace pcl::indoor
