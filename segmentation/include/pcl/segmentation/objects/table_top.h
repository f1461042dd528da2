/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace indoor {

/** \brief Whether a scan is no larger than what stands on a table: 98 % of the points
 * lie within 0.7 m of height, less than a chair's with its back, and within 1.5 m both
 * ways across it; and they are dense enough for smaller voxels than a room's, see
 * raisedToResolution().
 *
 * What is joined to whole furniture in rooms joins such things to one;
 * singleViewOptions() keep them apart, from whichever sides they were seen.
 * \param[in] points finite, metres, local frame; fewer than 1,000 do not tell
 * \param[in] up unit length
 */
bool
isTableTop(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& up);

} // namespace indoor
} // namespace pcl
