/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace indoor {

/** \brief How points were taken. */
enum class Capture {
  Scan,      ///< in any way; which direction is up is known
  TableView, ///< by one camera that looks along z, at about 1 m: things on a table
  RoomView   ///< by one camera that looks along z, with y down, from farther off
};

/** \brief Tell how the points of an organised cloud were taken.
 *
 * A camera has 99 % of them in front of it, within 75 degrees of z. It sees a room if
 * what it looks at, within 10 degrees of z, is more than 1.4 m away (half of it).
 * \param[in] points finite, metres
 * \param[in] camera where it would stand
 */
Capture
captureOf(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& camera);

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

} // namespace indoor
} // namespace pcl
