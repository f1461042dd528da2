/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "normals/free_space_grid.h"

#include <pcl/features/normal_orientation.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** \brief Find places in the free space between the surfaces, far from them and from
 * each other, the widest first: where a scanner may have stood. Free is a place that
 * surfaces enclose from at least five of the six axis directions; if there is none, the
 * middle of the grid is returned.
 * \param[in] options legal ones
 * \return at least one place
 */
std::vector<Eigen::Vector3f>
viewpointsIn(const FreeSpaceGrid& grid, const FreeSpaceOptions& options);

} // namespace pcl::indoor
