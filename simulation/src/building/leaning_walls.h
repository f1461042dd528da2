/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/plan.h>

namespace pcl::indoor {

/** \brief Metres sideways per metre up of the whole building. */
Eigen::Vector2d
driftOf(const Plan& plan);

/** \brief How the corners of a room move with the height, beside the building's lean.
 * \return metres sideways per metre up, for each vertex of the room's polygon; zero
 * where neither wall is one of \a plan's leaning walls
 * \throws PlanError if a leaning wall covers only a part of a wall, or if two walls
 * that run on straight lean apart
 */
std::vector<Eigen::Vector2d>
cornerDrifts(const Plan& plan, const RoomPlan& room, const std::string& source);

/** \brief Refuse leaning walls that lie on no wall of any room. */
void
requireLeaningWallsUsed(const Plan& plan, const std::string& source);

} // namespace pcl::indoor
