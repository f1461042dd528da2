/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/map/building_steps.h"
#include "rooms/storeys/storey_space.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** \brief Add the openings of the last storey of a building, that of \a space.
 * \param[in] points those of the building
 * \param[in] threads 0 = automatic
 */
void
addOpenings(const std::vector<Eigen::Vector3f>& points,
            const StoreySpace& space,
            int threads,
            DetailedBuilding& building);

/** \brief Add the footprints of all rooms, and measure their heights; areas and volumes
 * follow.
 * \param[in] points those of the building; their labels are known
 * \param[in] threads 0 = automatic
 */
void
addFootprints(const std::vector<Eigen::Vector3f>& points,
              int threads,
              DetailedBuilding& building);

} // namespace pcl::indoor
