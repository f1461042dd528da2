/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/svg_drawing.h"

#include <pcl/indoor/exports.h>
#include <pcl/segmentation/building_rooms.h>

namespace pcl::indoor::tool {

/** \brief The rooms of all storeys, each in its colour and with its number; walls are
 * dark, openings white discs. Storeys lie below each other, the highest on top, all cut
 * to the same part of the map.
 */
PCL_INDOOR_EXPORTS SvgDrawing
drawRooms(const BuildingRooms& building);

/** \brief The field that the rooms were found in, dark at the walls and light where a
 * room is widest. */
PCL_INDOOR_EXPORTS SvgDrawing
drawPotentialField(const BuildingRooms& building);

} // namespace pcl::indoor::tool
