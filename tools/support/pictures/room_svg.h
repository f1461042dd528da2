/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/building_rooms.h>

#include <string>

namespace pcl::indoor::tool {

/** \brief The plan of all storeys as an SVG drawing: each room's footprint filled in
 * its colour, with its number and area; openings with their width; a scale bar. One
 * group per storey, id "storey-0" and so on, the highest on top.
 */
std::string
roomsSvg(const BuildingRooms& building);

} // namespace pcl::indoor::tool
