/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** \brief Fit a plane to the neighbours near the plane through the origin with a given,
 * inexact normal. Near are those whose height over that plane lies in the shortest
 * interval that holds 0 and a third of all heights.
 * \param[in] normal unit length
 * \param[in] largest_turn radians
 * \param[out] heights scratch
 * \return the normal of the fitted plane; the given one if that differs by more than
 * the largest turn, or if there is none
 */
Eigen::Vector3f
refitPlane(const std::vector<Eigen::Vector3f>& neighbors,
           const Eigen::Vector3f& normal,
           float largest_turn,
           std::vector<float>& heights);

/** \brief Compute the surface variation, Eq. (2.8), of positions.
 * \return false if they do not span a plane: on a line, or in one place
 */
bool
surfaceVariation(const std::vector<Eigen::Vector3f>& positions, float& variation);

} // namespace pcl::indoor
