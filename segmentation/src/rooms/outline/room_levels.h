/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/map/building_steps.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** \brief Heights of a room's floor and ceiling, metres. */
struct RoomLevels {
  double floor = 0.0;      ///< the lowest of its large level surfaces
  double ceiling = 0.0;    ///< mean over its area: of a sloped one, that of its middle
  double floor_seen = 0.0; ///< share of its area in which the floor was seen
  double ceiling_seen = 0.0; ///< share of its area in which the ceiling was seen
};

/** \brief Measure floors and ceilings by the points, finer than voxels are.
 * \param[in] points those of the building; their labels are known
 * \return per label of a room; index 0 is unused
 */
std::vector<RoomLevels>
roomLevels(const std::vector<Eigen::Vector3f>& points,
           const DetailedBuilding& building);

} // namespace pcl::indoor
