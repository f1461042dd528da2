/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/space/occupancy_grid.h"

#include <vector>

namespace pcl::indoor {

/** \brief Find the slabs of which neither the ceiling below nor the floor above was
 * seen.
 *
 * Where a lidar looks neither up nor down, each storey shows a band of its walls.
 * Between two such bands there are layers in which hardly anything was seen anywhere.
 * Linear in the number of points.
 * \param[in] building occupancy grid; its points count, not what closes their surfaces
 * \return the middle of each, in voxels, lowest first
 */
std::vector<double>
unseenSlabs(const OccupancyGrid& building);

} // namespace pcl::indoor
