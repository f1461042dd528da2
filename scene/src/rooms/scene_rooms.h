/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "rooms/finished_room.h"
#include "rooms/room_store.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Rooms, and last what is in none, that can be had one by one. */
struct RoomSource {
  std::vector<std::size_t> sizes; ///< points of each
  bool has_normals = false;
  bool is_spooled = false; ///< the points are in files of the work folder already
  /** in the frame of CloudFile::points, with normals if there are; called from several
   * threads */
  std::function<RoomPoints(std::size_t room)> points;
};

/** \brief Is told how many of all points are done, from one thread at a time. */
using PointsDone = std::function<void(std::size_t done, std::size_t all)>;

/** \brief Finishes rooms in this order, each into the store, with the help of other
 * processes.
 * \param[in] is_done is to be told of each room, by one thread at a time */
using ShareRooms =
    std::function<void(const RoomSource& source,
                       const std::vector<std::size_t>& order,
                       const std::function<void(std::size_t room)>& is_done)>;

/** \brief Finish the rooms that are not finished yet, large ones first; each goes into
 * the store.
 * \param[in] threads 0 = automatic; the result does not depend on it
 * \param[in] share finishes them instead of the threads of this process, if given
 */
void
finishRooms(const RoomSource& source,
            const RoomWork& work,
            RoomStore& store,
            int threads,
            const PointsDone& report,
            const ShareRooms& share = {});

/** \brief Is given a room, what is added to the numbers of its objects, and these. */
using VisitRoom = std::function<void(
    std::size_t room, std::uint32_t first_object, const RoomObjects& objects)>;

/** \brief Put what was found in the rooms into the scene, which knows its rooms: all
 * but objects and structure of the points.
 * \param[in] visit is called with each room
 * \throws ToolError if the store lacks one of them
 */
void
gatherRooms(const RoomSource& source,
            const RoomStore& store,
            Scene& scene,
            const VisitRoom& visit);

} // namespace pcl::indoor::tool
