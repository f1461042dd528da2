/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** \brief Three orthogonal directions of planes. */
struct ManhattanFrame {
  /** A rotation; its columns are the directions. */
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  /** Per column: share of the weight near the axis (0 ... 1). */
  Eigen::Vector3d axis_support = Eigen::Vector3d::Zero();
  /** Share that this frame has and no stronger frame. */
  double support = 0.0;
};

/** \brief The Manhattan frames of a mixture, by surface normals (Sec. 2.1.6.5).
 *
 * The number of frames is inferred. The thesis refers to a Markov chain that splits and
 * merges frames at random; here the same mixture is fitted without chance: modes of the
 * normals' density on the sphere are joined to frames, strongest first, as long as
 * they explain enough, and then all frames are refined in turns of assignment (each
 * normal to the axes near it) and rotation (the closest one to the assigned normals, by
 * a singular value decomposition). The answer is the same every time and hardly
 * slower than reading the input: it is found on a histogram of the sphere.
 *
 * \param[in] normals unit normals; the sign does not matter; non-finite ones do not
 * count
 * \param[in] weights one per normal, not negative; or empty for equal weights
 * \return the frames by descending support
 * \throws pcl::BadArgumentException if the sizes differ, or a weight is negative or
 * not finite
 */
std::vector<ManhattanFrame>
manhattanFrames(const std::vector<Eigen::Vector3d>& normals,
                const std::vector<double>& weights = {});

/** \brief Directions that differ less are one, radians. */
constexpr double same_direction = 0.05;

/** \brief A horizontal direction; its sense has no meaning. */
struct HorizontalDirection {
  Eigen::Vector2d direction; ///< unit vector with an angle of (-90, 90] degrees
  double support = 0.0;      ///< share of the weight of all normals near it
};

/** \brief The horizontal axes of frames, strongest first.
 *
 * Axes that are the same_direction count once. Each direction is followed
 * by the one at right angles to it if that belongs to the same frame and is known, too.
 *
 * \param[in] frames result of manhattanFrames()
 * \return at least two directions: if no frame has a horizontal axis, x and y with
 * support 0
 */
std::vector<HorizontalDirection>
horizontalDirections(const std::vector<ManhattanFrame>& frames);

} // namespace pcl::indoor
