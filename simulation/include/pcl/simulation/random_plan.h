/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/simulation/plan.h>

#include <optional>
#include <string>

#include <cstdint>

namespace pcl::indoor {

/** \brief What a random plan is a plan of. */
enum class PlanKind {
  Home,   ///< 4 to 8 rooms per storey: living room, kitchen, bathroom, bedrooms, hall
  Office, ///< a corridor with offices, meeting room, kitchenette and storage
  Table   ///< one room with a table in its middle, above the origin, objects on it
};

/** \brief What a random plan has besides its furniture. */
enum class PlanFilling {
  Plain,     ///< a few small objects
  Cluttered, ///< desks pushed together, small objects on all that has a level top
  LivedIn    ///< furniture of all shapes, and belongings where people leave them
};

/** \brief Draw a furnished building, or a table with small objects on it.
 *
 * Rooms are rectangles that cut a rectangular or L-shaped outline into pieces; a tree
 * of doors, some of them closed, joins them all. Furniture stands as people put it for
 * the kind of each room. Pieces may touch each other and the walls; their bounding
 * boxes share space only where chairs stand under tables or objects lie in pieces. Some
 * buildings are turned.
 * \param[in] seed the same seed gives the same plan, another one another plan
 * \param[in] kind of the building
 * \param[in] filling Cluttered: desks are pushed together, many small objects lie on
 * the floor and on all that has a level top, and all else is as in a plain plan; a
 * table has more objects. LivedIn: the rooms are those of the plain plan; each piece
 * is drawn from all shapes of its class; pillows, blankets, clothes, bags, books, toys,
 * towels and kitchenware lie in, on, under and over furniture, on the floor and at the
 * walls
 * \return a plan that buildBuilding() accepts
 */
PCL_INDOOR_EXPORTS Plan
randomPlan(std::uint32_t seed, PlanKind kind, PlanFilling filling = PlanFilling::Plain);

/** \brief Read what names a random plan: random:home:SEED, random:office:SEED or
 * random:table:SEED, followed by :cluttered or :lived_in for its filling.
 * \param[in] name a plan's name, for example random:home:7
 * \return the plan; none if the name does not begin with random:
 * \throws PlanError if the kind is none of these or the seed is no number from 0 to
 * 4294967295
 */
PCL_INDOOR_EXPORTS std::optional<Plan>
randomPlanNamed(const std::string& name);

} // namespace pcl::indoor
