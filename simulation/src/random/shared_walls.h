/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "random/random_layout.h"

#include <optional>
#include <utility>
#include <vector>

namespace pcl::indoor {

/** \brief A piece of wall parallel to an axis. */
struct SharedWall {
  int room = -1;   ///< the neighbour; -1: outside
  int axis = 0;    ///< along which the wall runs
  double at = 0.0; ///< its coordinate across
  double from = 0.0, to = 0.0;
};

/** \brief The wall between two rooms, if any. */
std::optional<SharedWall>
wallBetween(const Eigen::AlignedBox2d& a, const Eigen::AlignedBox2d& b);

/** \brief The walls of a room to its neighbours that are long enough for a door. */
std::vector<SharedWall>
wallsOf(const std::vector<LayoutRoom>& rooms, std::size_t r);

/** \brief The rooms in the order in which doors reach them from the hall: a room that
 * is reached already, and its wall to the next. */
std::vector<std::pair<int, SharedWall>>
treeOfDoors(const std::vector<LayoutRoom>& rooms);

} // namespace pcl::indoor
