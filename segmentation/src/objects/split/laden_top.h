/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pcl::indoor {

/** \brief The heights along up between which the top of a table lies, metres. */
struct TopLevel {
  float lower = 0, upper = 0;
};

/** \brief Where a segment has the top of a table on which something stands: the level
 * that covers most of the ground, 0.08 m^2 or more, 0.3 to 1.5 m both ways across up;
 * what lies above it is less than 0.5 m high.
 * \param[in] points of the segment, metres
 * \return none if there is no such level
 */
std::optional<TopLevel>
ladenTop(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& up);

} // namespace pcl::indoor
