/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pipeline/scene_rooms.h"

#include <pcl/indoor/parallel_for.h>

#include <iterator>
#include <mutex>
#include <numeric>
#include <utility>

namespace pcl::indoor::tool {

std::vector<FinishedRoom>
finishRooms(const RoomSource& source,
            const RoomWork& work,
            int threads,
            const std::function<void(std::size_t done, std::size_t all)>& report)
{
  const auto order = largestFirst(source.sizes);
  const auto all =
      std::accumulate(source.sizes.begin(), source.sizes.end(), std::size_t(0));
  std::size_t done = 0;
  std::mutex mutex; // of the report
  std::vector<FinishedRoom> finished(order.size());
  parallelFor(
      static_cast<std::ptrdiff_t>(order.size()), threads, 1, [&](std::ptrdiff_t i) {
        const auto room = order[static_cast<std::size_t>(i)];
        finished[room] = finishRoom(source.points(room), work);
        const std::lock_guard<std::mutex> lock(mutex);
        report(done += source.sizes[room], all);
      });
  return finished;
}

void
gatherRooms(const std::vector<Indices>& rooms,
            std::vector<FinishedRoom> finished,
            Scene& scene)
{
  const std::size_t point_count = scene.room_of_point.size();
  scene.object_of_point.assign(point_count, 0);
  scene.structure_of_point.assign(point_count, 0);
  for (std::size_t room = 0; room < rooms.size(); ++room) {
    auto& own = finished[room];
    const auto first = static_cast<std::uint32_t>(scene.objects.size());
    for (std::size_t i = 0; i < rooms[room].size(); ++i) {
      if (own.objects.object_of_point[i] > 0)
        scene.object_of_point[rooms[room][i]] = first + own.objects.object_of_point[i];
      scene.structure_of_point[rooms[room][i]] = own.objects.structure_of_point[i];
    }
    const bool is_room = room < scene.rooms.size();
    for (const auto& measures : own.measures)
      scene.objects.push_back(
          {measures, is_room ? static_cast<std::uint32_t>(room + 1) : 0u});
    std::move(own.classes.begin(),
              own.classes.end(),
              std::back_inserter(scene.classes.objects));
    scene.object_voxels.push_back(own.objects.voxel_size);
  }
}

} // namespace pcl::indoor::tool
