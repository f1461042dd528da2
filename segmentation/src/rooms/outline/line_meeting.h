/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "internal/cross.h"

#include <Eigen/Core>

namespace pcl::indoor {

/** \brief Where two lines meet that are not parallel: each is a point and a direction.
 */
inline Eigen::Vector2d
lineMeeting(const Eigen::Vector2d& a,
            const Eigen::Vector2d& along_a,
            const Eigen::Vector2d& b,
            const Eigen::Vector2d& along_b)
{
  return a + crossOf(b - a, along_b) / crossOf(along_a, along_b) * along_a;
}

} // namespace pcl::indoor
