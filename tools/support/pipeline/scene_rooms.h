/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pipeline/finished_room.h"
#include "pipeline/ranks.h"
#include "pipeline/work_folder.h"
#include "scene/scene_file.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Rooms, and last what is in none, that can be had one by one. */
struct RoomSource {
  std::vector<std::size_t> sizes; ///< points of each
  bool has_normals = false;
  bool is_filed = false; ///< the points are in files of the work folder already
  /** in the frame of CloudFile::points, with normals if there are; called from several
   * threads */
  std::function<RoomPoints(std::size_t room)> points;
};

/** \brief Is told how many of all points are done, from one thread at a time. */
using PointsDone = std::function<void(std::size_t done, std::size_t all)>;

/** \brief Finish the rooms that are not finished yet, large ones first; each goes into
 * a file of the folder, see roomFile().
 * \param[in] ranks each does one room at a time; if there is one only, its threads do
 * \param[in] threads 0 = automatic; the result does not depend on it
 */
void
finishRooms(const RoomSource& source,
            const RoomWork& work,
            WorkFolder& folder,
            Ranks& ranks,
            int threads,
            const PointsDone& report);

/** \brief Is given a room, what is added to the numbers of its objects, and these. */
using VisitRoom = std::function<void(
    std::size_t room, std::uint32_t first_object, const RoomObjects& objects)>;

/** \brief Put what was found in the rooms into the scene, which knows its rooms: all
 * but objects and structure of the points.
 * \param[in] visit is called with each room
 * \throws ToolError if the folder lacks one of them
 */
void
gatherRooms(const RoomSource& source,
            const WorkFolder& folder,
            Scene& scene,
            const VisitRoom& visit);

} // namespace pcl::indoor::tool
