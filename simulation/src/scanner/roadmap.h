/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/building.h>
#include <pcl/simulation/carried_path.h>
#include <pcl/simulation/random_draw.h>

#include <vector>

namespace pcl::indoor {

/** \brief A place that a carried sensor may pass. */
struct RoadNode {
  Eigen::Vector3d at;      ///< of the sensor, metres
  Eigen::Vector2d drawn;   ///< as drawn, before the building leans
  double floor = 0.0;      ///< height that the carrier stands on, metres
  double free = 0.0;       ///< metres to the nearest wall or piece of furniture
  std::uint32_t room = 0;  ///< number; 0: in a doorway
  std::vector<int> joined; ///< numbers of the nodes that can be walked to straight
};

/** \brief Whether nothing is between two places, nor a little beside the way. */
bool
isClear(const RayTracer& tracer,
        const Eigen::Vector3d& from,
        const Eigen::Vector3d& to);

/** \brief Places of one storey and which of them can be walked between. */
using Roadmap = std::vector<RoadNode>;

/** \brief The places in rooms and doorways of a storey.
 * \param[in] tracer of the building: nothing is on the way between joined places
 */
Roadmap
buildRoadmap(const Building& building,
             std::uint32_t storey,
             double height,
             const RayTracer& tracer);

/** \brief The part that is joined and has the most places in rooms. */
Roadmap
largestPart(const Roadmap& roadmap);

/** \brief What is left where only a share of the rooms is entered, rounded up. */
Roadmap
enteredPart(const Roadmap& roadmap, double share, RandomDraw draw);

/** \brief Places that a walk should come to, about a spacing apart in each room. */
std::vector<int>
stopsOn(const Roadmap& roadmap, const TrajectoryOptions& options);

/** \brief The way from a place to the nearest of some others.
 * \param[in] wanted for each place, whether it is one of those
 * \return numbers of the places from \a from on; none if there is no way
 */
std::vector<int>
wayToNearest(const Roadmap& roadmap, int from, const std::vector<char>& wanted);

} // namespace pcl::indoor
