/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/saved_scene.h"
#include "export/shortest_paths.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::indoor::tool {

enum class DoorNodeKind {
  Room,    ///< where the room is widest
  Opening, ///< the middle of a door or passage
  Stair,   ///< an end of stairs
  Corner,  ///< a place where ways in a room turn
  Place    ///< that was asked for
};

/** \brief A place that ways of a building lead over. */
struct DoorNode {
  DoorNodeKind kind = DoorNodeKind::Corner;
  std::uint32_t number = 0; ///< of the room, the opening, the stairs' object or, from
                            ///< 1, the place; 0 of a corner
  std::uint32_t room = 0;   ///< that it is in; 0 = between rooms
  std::uint32_t storey = 0;
  Eigen::Vector3d position; ///< on the floor, frame of the scene
};

/** \brief Rooms, doors and stairs of a building with the ways between them. */
struct DoorGraph {
  std::vector<DoorNode> nodes;     ///< of the kinds in their order, corners last
  std::vector<WeightedLine> lines; ///< straight, metres
};

/** \brief A way through a building. */
struct DoorRoute {
  double length = 0.0;            ///< metres
  std::vector<std::size_t> nodes; ///< of the graph, from begin to end
};

/** \brief Make the graph: doors, open or closed, and passages join their rooms; stairs,
 * objects of that class, rooms of two storeys; in each room the shortest ways lead
 * around its corners. Objects that stand about are not looked at.
 * \param[in] places that become nodes, too
 * \throws ToolError if a place is in no room, nor within a metre of one
 */
DoorGraph
doorGraph(const SavedScene& scene, const std::vector<Eigen::Vector3d>& places = {});

/** \brief The shortest way between two nodes; none if no way leads there. */
std::optional<DoorRoute>
shortestRoute(const DoorGraph& graph, std::size_t from, std::size_t to);

/** \brief The node of a kind with a number.
 * \throws ToolError if there is none */
std::size_t
nodeOf(const DoorGraph& graph, DoorNodeKind kind, std::uint32_t number);

} // namespace pcl::indoor::tool
