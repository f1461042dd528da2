/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/collected_objects.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace pcl::indoor::tool {

CollectedObjects
collectObjects(const PointCloud<PointXYZ>& points,
               const std::vector<std::uint32_t>& room_of_point,
               const std::vector<std::uint32_t>& given,
               RoomWork work,
               int threads,
               const PointsDone& report)
{
  const std::size_t room_count =
      room_of_point.empty()
          ? 0
          : *std::max_element(room_of_point.begin(), room_of_point.end());
  const auto rooms = pointsOfRooms(points, room_of_point, room_count);
  RoomSource source;
  for (const auto& room : rooms)
    source.sizes.push_back(room.size());
  source.points = [&](std::size_t room) {
    RoomPoints own;
    for (const auto index : rooms[room]) {
      own.positions.emplace_back(points[index].getVector3fMap());
      if (!given.empty())
        own.given.push_back(given[static_cast<std::size_t>(index)]);
    }
    return own;
  };
  work.keeps_surfaces = true;
  RoomsInMemory store;
  finishRooms(source, work, store, threads, report);
  CollectedObjects all;
  all.object_of_point.assign(points.size(), 0);
  for (std::size_t room = 0; room < rooms.size(); ++room) {
    auto objects = store.room(room, source.sizes[room])->objects;
    const auto first = static_cast<std::uint32_t>(all.surfaces.size());
    for (std::size_t i = 0; i < rooms[room].size(); ++i)
      if (objects.object_of_point[i] > 0)
        all.object_of_point[static_cast<std::size_t>(rooms[room][i])] =
            first + objects.object_of_point[i];
    std::move(objects.surfaces.begin(),
              objects.surfaces.end(),
              std::back_inserter(all.surfaces));
  }
  return all;
}

} // namespace pcl::indoor::tool
