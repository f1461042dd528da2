/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/simulation/building.h>

namespace pcl::indoor {

struct TrajectoryOptions {
  double spacing = 2.0;       ///< between neighbouring poses, metres (> 0)
  double sensor_height = 1.5; ///< above the floor, metres (> 0)
  double clearance = 0.4;     ///< from walls and furniture, metres (>= 0)
};

/** \brief Choose sensor positions all through the free space of a building.
 *
 * Each room gets positions about \a spacing apart that keep their clearance, at least
 * one per room (the freest place where nothing keeps it), and each passable doorway
 * gets one. They are put in the order of a walk: storey by storey, always to the
 * nearest one that is left. Deterministic.
 * \throws BadArgumentException if an option is out of its range
 */
PCL_INDOOR_EXPORTS std::vector<Eigen::Vector3d>
planTrajectory(const Building& building, const TrajectoryOptions& options);

} // namespace pcl::indoor
