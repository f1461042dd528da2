/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/simulation/building.h>

#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief Say in JSON what the numbers in a scan mean.
 *
 * Keys: categories (the name of each number), rooms (number, name, storey, polygon,
 * floor, area), objects (number, room, category, parts, position, size, rotation in
 * degrees) and trajectory (the positions of the sensor). docs/guide/simulation.md has
 * them all.
 */
PCL_INDOOR_EXPORTS std::string
describeScene(const Building& building, const std::vector<Eigen::Vector3d>& trajectory);

} // namespace pcl::indoor
