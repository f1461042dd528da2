/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/finished_room.h"

#include "rooms/object_votes.h"
#include "scene/bundled_network.h"

#include <utility>

namespace pcl::indoor::tool {
namespace {

VoxelVoter
voterOf(const VotingNetwork& voting)
{
  VoxelVoter voter;
  if (voting.votes)
    voter.classify = [](const std::vector<Eigen::Vector3f>& points) {
      return classifyVoxels(points, bundledNetwork());
    };
  voter.in_all_rooms = voting.in_all_rooms;
  return voter;
}

} // namespace

FinishedRoom
finishRoom(RoomPoints room, const RoomWork& work)
{
  const auto positions = room.positions;
  if (!work.frame.isScanUpright()) {
    const Eigen::Matrix3f turn = work.frame.pose.linear().transpose().cast<float>();
    for (auto& position : room.positions)
      position = work.frame.scanToUpright(position.cast<double>()).cast<float>();
    for (auto& normal : room.normals)
      normal = turn * normal;
  }
  const auto upright = room.positions;
  const auto removed = prepareRoom(work.preparation, room);
  FinishedRoom finished;
  const auto voter = voterOf(work.network);
  finished.objects =
      work.thesis ? thesis::segmentRoomObjects(std::move(room), *work.thesis, voter)
                  : segmentRoomObjects(std::move(room), work.options, voter);
  putBack(removed, finished.objects);
  ObjectVotes votes;
  if (finished.objects.votes.class_count > 0) {
    votes = votesOf(finished.objects);
    if (work.network.names_objects)
      votes.classes = bundledNetwork().classes;
    else
      votes = {};
    finished.objects.votes = {};
  }
  finished.measures = measureObjects(positions, upright, finished.objects);
  if (work.naming)
    finished.classes =
        classesOf(finished.objects.surfaces, finished.measures, *work.naming, votes);
  if (!work.keeps_surfaces)
    finished.objects.surfaces = {};
  return finished;
}

} // namespace pcl::indoor::tool
