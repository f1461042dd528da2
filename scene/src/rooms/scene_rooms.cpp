/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/scene_rooms.h"

#include "files/tool_error.h"

#include <pcl/indoor/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <mutex>
#include <utility>

namespace pcl::indoor::tool {

void
finishRooms(const RoomSource& source,
            const RoomWork& work,
            RoomStore& store,
            int threads,
            const PointsDone& report,
            const ShareRooms& share)
{
  std::size_t all = 0, done = 0;
  std::vector<std::size_t> left;
  for (const auto room : largestFirst(source.sizes)) {
    all += source.sizes[room];
    if (store.room(room, source.sizes[room]))
      done += source.sizes[room];
    else
      left.push_back(room);
  }
  if (done > 0)
    report(done, all);
  const auto is_done = [&](std::size_t room) {
    report(done += source.sizes[room], all);
  };
  if (share) {
    share(source, left, is_done);
    return store.await(left);
  }
  std::mutex mutex;
  parallelFor(
      static_cast<std::ptrdiff_t>(left.size()), threads, 1, [&](std::ptrdiff_t i) {
        const auto room = left[static_cast<std::size_t>(i)];
        store.putRoom(room, finishRoom(source.points(room), work));
        const std::lock_guard<std::mutex> lock(mutex);
        is_done(room);
      });
}

void
gatherRooms(const RoomSource& source,
            const RoomStore& store,
            Scene& scene,
            const VisitRoom& visit)
{
  constexpr auto remainder = static_cast<std::uint32_t>(StructureKind::Remainder);
  for (std::size_t room = 0; room < source.sizes.size(); ++room) {
    auto own = store.room(room, source.sizes[room]);
    if (!own)
      throw ToolError(store.absence(room));
    visit(room, static_cast<std::uint32_t>(scene.objects.size()), own->objects);
    const bool is_room = room < scene.rooms.size();
    for (const auto& measures : own->measures)
      scene.objects.push_back(
          {measures, is_room ? static_cast<std::uint32_t>(room + 1) : 0u});
    std::move(own->classes.begin(),
              own->classes.end(),
              std::back_inserter(scene.classes.objects));
    scene.object_voxels.push_back(own->objects.voxel_size);
    const auto& structure = own->objects.structure_of_point;
    scene.remainders.push_back(static_cast<std::size_t>(
        std::count(structure.begin(), structure.end(), remainder)));
  }
}

} // namespace pcl::indoor::tool
