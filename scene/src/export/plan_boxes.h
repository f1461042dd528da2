/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/opening_place.h"
#include "export/saved_scene.h"

namespace pcl::indoor::tool {

/** \brief A box from above, counter-clockwise. */
PlanRing
boxFromAbove(const UprightBox& box);

/** \brief What walls are drawn with of which one side was seen, metres. */
constexpr double unknown_thickness = 0.1;

/** \brief A wall from above, counter-clockwise. */
PlanRing
wallBox(const SavedWall& wall);

/** \brief The way through an opening from above, counter-clockwise, from room to room.
 * \param[in] more that it reaches into the rooms, metres */
PlanRing
openingBox(const OpeningPlace& place, double width, double more);

} // namespace pcl::indoor::tool
