/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "rooms/map/building_steps.h"
#include "rooms/storeys/storey_space.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl::indoor {

/** \brief The two steps in which our way and the thesis's differ: dividing a storey's
 * map into rooms, and labelling its points. */
struct RoomWay {
  /** the rooms of a storey on its map; called for several storeys at a time */
  std::function<RoomMap(const StoreySpace& space)> map;
  /** labels the points of a storey by building.room_of, when all storeys have maps;
   * storey_of is per point */
  std::function<void(const std::vector<Eigen::Vector3f>& points,
                     const std::vector<std::uint8_t>& storey_of,
                     std::size_t storey,
                     DetailedBuilding& building)>
      label;
};

/** \brief segmentBuilding() by a way of its own.
 * \param[in] options that are legal
 * \throws pcl::BadArgumentException if there are not as many stations as points
 */
BuildingRooms
segmentBuildingBy(const RoomWay& way,
                  const std::vector<Eigen::Vector3f>& points,
                  const BuildingRoomsOptions& options,
                  const ProgressCallback& progress,
                  const ScanStations& stations);

/** \brief Label the points of a storey by the map, and at walls by the side they are
 * on. */
void
labelBySides(const std::vector<Eigen::Vector3f>& points,
             const BuildingRoomsOptions& options,
             const std::vector<std::uint8_t>& storey_of,
             std::size_t storey,
             DetailedBuilding& building);

} // namespace pcl::indoor
