/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/finished_room.h"

#include "rooms/object_votes.h"

#include <utility>

namespace pcl::indoor::tool {

FinishedRoom
finishRoom(RoomPoints room, const RoomWork& work)
{
  const auto positions = room.positions;
  if (!work.is_standing) {
    const Eigen::Matrix3f turn = work.pose.linear().transpose().cast<float>();
    for (auto& position : room.positions)
      position = work.standing(position);
    for (auto& normal : room.normals)
      normal = turn * normal;
  }
  const auto standing = room.positions;
  const auto removed = prepareRoom(work.preparation, room);
  FinishedRoom finished;
  finished.objects = segmentRoomObjects(std::move(room), work.options);
  putBack(removed, finished.objects);
  ObjectVotes votes;
  if (work.network.network.valid() &&
      (work.network.in_all_rooms || !hasCeiling(finished.objects))) {
    votes =
        votesOf(standing, finished.objects.object_of_point, work.network.network.get());
    nameStructure(votes, finished.objects);
    if (!work.network.names_things)
      votes = {};
  }
  finished.measures = measureObjects(positions, standing, finished.objects);
  if (work.naming)
    finished.classes =
        classesOf(finished.objects.surfaces, finished.measures, *work.naming, votes);
  if (!work.keeps_surfaces)
    finished.objects.surfaces = {};
  return finished;
}

} // namespace pcl::indoor::tool
