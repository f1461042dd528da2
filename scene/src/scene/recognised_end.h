/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor::tool {

/** \brief With which end up the bundled voxel network recognises more objects.
 *
 * Looks at the squares of 5 m that show most surface: takes one to three seconds.
 * \param[in] points metres, the vertical along z
 * \return 1: as they are; -1: the other way up; 0: there is little to recognise, hardly
 * more than the other way up, the points are more than some 12 cm apart, or the file of
 * the network is not installed
 */
int
recognisedEnd(const std::vector<Eigen::Vector3f>& points);

} // namespace pcl::indoor::tool
