/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pipeline/ranks.h"
#include "rooms/scene_rooms.h"

#include <functional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Finish rooms with all ranks: each takes the next room when it has finished
 * one, the first rank, too. The points go through files of the folder, which all ranks
 * must see: a message holds no more than 2 GB, and finished rooms are files anyway.
 * \param[in] order the rooms to be finished
 * \param[in] work of the first rank; the others make their own of the same options
 * \param[in] is_done is told of each room that is finished, by one thread at a time
 */
void
shareRooms(const std::vector<std::size_t>& order,
           const RoomSource& source,
           const RoomWork& work,
           WorkFolder& folder,
           Ranks& ranks,
           const std::function<void(std::size_t room)>& is_done);

/** \brief What all other ranks do: finish the rooms that the first one gives out, until
 * it dismisses them.
 * \param[in] folder the name of the WorkFolder
 * \param[in] make_work called with the first room; the pose is set here
 */
void
finishSharedRooms(Ranks& ranks,
                  const std::string& folder,
                  const std::function<RoomWork()>& make_work);

} // namespace pcl::indoor::tool
