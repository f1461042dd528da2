/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/building.h>

#include <vector>

namespace pcl::indoor {

/** \brief Somebody who stands or walks in a building: a body and a head. */
struct StandingPerson {
  Eigen::Vector3d feet;   ///< metres
  std::uint32_t room = 0; ///< number of the room; in a doorway, of the nearer one
};

/** \brief A person at a place, and the room that it is in. */
StandingPerson
personAt(const Building& building, const Eigen::Vector3d& feet);

/** \brief Distance along a ray to a person, metres, or infinity.
 * \param[in] direction of unit length */
double
distanceTo(const StandingPerson& person,
           const Eigen::Vector3d& origin,
           const Eigen::Vector3d& direction);

} // namespace pcl::indoor
