/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/map/building_steps.h"
#include "rooms/storeys/storey_space.h"

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace indoor {

/** \brief Add the openings of the last storey of a building, that of \a space.
 * \param[in] points those of the building
 */
void
addOpenings(const std::vector<Eigen::Vector3f>& points,
            const StoreySpace& space,
            DetailedBuilding& building);

/** \brief Add the footprints of all rooms, and measure their heights; areas and volumes
 * follow.
 * \param[in] points those of the building; their labels are known
 */
void
addFootprints(const std::vector<Eigen::Vector3f>& points, DetailedBuilding& building);

} // namespace indoor
} // namespace pcl
