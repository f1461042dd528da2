/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "rooms/map/room_map.h"
#include "rooms/space/interior_space.h"
#include "rooms/space/occupancy_grid.h"
#include "rooms/storeys/storeys.h"

#include <pcl/segmentation/building_rooms.h>

#include <vector>

namespace pcl::indoor {

/** \brief What led to the rooms of a building. */
struct BuildingSteps {
  OccupancyGrid occupancy;
  InteriorSpace interior;
  Storeys storeys;
  std::vector<RoomMap>
      room_maps; ///< per storey; what is in its MappedRooms is moved on
};

/** \brief A building whose rooms are being found: its own maps, and its pointer to the
 * steps, are empty. */
struct DetailedBuilding : BuildingRooms, BuildingSteps {};

/** \brief Hand over a building whose rooms were found; nothing at all if they were not.
 */
BuildingRooms
published(DetailedBuilding building);

/** \brief The steps to the rooms of a building; empty ones if there are none. */
const BuildingSteps&
stepsOf(const BuildingRooms& building);

} // namespace pcl::indoor
