/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace indoor {

/** \brief Mean distance of the points to their nearest other points: the resolution
 * that the radius rule of Eq. (2.9), R = 2.5 times it, refers to. \param[in] points
 * finite points, metres, local frame \return metres; 0 for less than two points
 */
double
meanResolution(const std::vector<Eigen::Vector3f>& points);

} // namespace indoor
} // namespace pcl
