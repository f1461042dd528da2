/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pipeline/scene_rooms.h"

#include "command_line/options.h" // for ToolError
#include "pipeline/scene_record.h"

#include <pcl/indoor/parallel_for.h>

#include <iterator>
#include <mutex>
#include <numeric>
#include <utility>

namespace pcl::indoor::tool {
namespace {

/** A room that is finished and has as many points as it should; else nothing. */
std::optional<FinishedRoom>
finishedRoom(const WorkFolder& folder, std::size_t room, std::size_t size)
{
  const auto bytes = folder.read(roomFile(room));
  auto finished = bytes ? roomOf(*bytes) : std::nullopt;
  return finished && finished->objects.object_of_point.size() == size ? finished
                                                                      : std::nullopt;
}

} // namespace

void
finishRooms(const RoomSource& source,
            const RoomWork& work,
            WorkFolder& folder,
            int threads,
            const PointsDone& report)
{
  const auto order = largestFirst(source.sizes);
  const auto all =
      std::accumulate(source.sizes.begin(), source.sizes.end(), std::size_t(0));
  std::size_t done = 0;
  std::mutex mutex; // of the report
  parallelFor(
      static_cast<std::ptrdiff_t>(order.size()), threads, 1, [&](std::ptrdiff_t i) {
        const auto room = order[static_cast<std::size_t>(i)];
        if (!finishedRoom(folder, room, source.sizes[room]))
          folder.write(roomFile(room),
                       roomBytes(finishRoom(source.points(room), work)));
        const std::lock_guard<std::mutex> lock(mutex);
        report(done += source.sizes[room], all);
      });
}

void
gatherRooms(const std::vector<Indices>& rooms, const WorkFolder& folder, Scene& scene)
{
  const std::size_t point_count = scene.room_of_point.size();
  scene.object_of_point.assign(point_count, 0);
  scene.structure_of_point.assign(point_count, 0);
  for (std::size_t room = 0; room < rooms.size(); ++room) {
    auto own = finishedRoom(folder, room, rooms[room].size());
    if (!own)
      throw ToolError(folder.path(roomFile(room)) +
                      ": the file is gone or damaged; start again to go on");
    const auto first = static_cast<std::uint32_t>(scene.objects.size());
    const auto& objects = own->objects;
    for (std::size_t i = 0; i < rooms[room].size(); ++i) {
      if (objects.object_of_point[i] > 0)
        scene.object_of_point[rooms[room][i]] = first + objects.object_of_point[i];
      scene.structure_of_point[rooms[room][i]] = objects.structure_of_point[i];
    }
    const bool is_room = room < scene.rooms.size();
    for (const auto& measures : own->measures)
      scene.objects.push_back(
          {measures, is_room ? static_cast<std::uint32_t>(room + 1) : 0u});
    std::move(own->classes.begin(),
              own->classes.end(),
              std::back_inserter(scene.classes.objects));
    scene.object_voxels.push_back(objects.voxel_size);
  }
}

} // namespace pcl::indoor::tool
