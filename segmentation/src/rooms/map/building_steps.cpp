/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/map/building_steps.h"

#include <memory>
#include <utility>

namespace pcl::indoor {

BuildingRooms
published(DetailedBuilding building)
{
  if (building.room_maps.empty())
    return {};
  const OccupancyGrid& occupancy = building.occupancy;
  building.grid.yaw = occupancy.yaw;
  building.grid.origin = occupancy.grid.origin;
  building.grid.voxel_size = occupancy.grid.voxel_size;
  building.heights = building.storeys.heights;
  for (std::size_t i = 0; i < occupancy.cells.size(); ++i)
    if (occupancy.cells[i] < 0)
      building.outside.push_back(i);
  for (RoomMap& map : building.room_maps)
    building.maps.push_back(std::move(static_cast<MappedRooms&>(map)));
  building.steps = std::make_shared<const BuildingSteps>(
      std::move(static_cast<BuildingSteps&>(building)));
  return std::move(building);
}

const BuildingSteps&
stepsOf(const BuildingRooms& building)
{
  static const BuildingSteps none;
  return building.steps ? *building.steps : none;
}

} // namespace pcl::indoor
