/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pipeline/finished_room.h"
#include "scene/scene_file.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Rooms, and last what is in none, that can be had one by one. */
struct RoomSource {
  std::vector<std::size_t> sizes; ///< points of each
  /** in the frame of CloudFile::points, with normals if there are; called from several
   * threads */
  std::function<RoomPoints(std::size_t room)> points;
};

/** \brief Finish all rooms, large ones first, several at a time.
 * \param[in] threads 0 = automatic; the result does not depend on it
 * \param[in] report is told how many of all points are done, from one thread at a time
 */
std::vector<FinishedRoom>
finishRooms(const RoomSource& source,
            const RoomWork& work,
            int threads,
            const std::function<void(std::size_t done, std::size_t all)>& report);

/** \brief Put what was found in the rooms into the scene, which knows its rooms and the
 * room of each point.
 * \param[in] rooms the points of each room
 */
void
gatherRooms(const std::vector<Indices>& rooms,
            std::vector<FinishedRoom> finished,
            Scene& scene);

} // namespace pcl::indoor::tool
