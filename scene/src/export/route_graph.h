/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/door_graph.h"

#include <nlohmann/json.hpp>

namespace pcl::indoor::tool {

/** \brief The part of a graph on one storey as GeoJSON, as Nav2's route server reads
 * it: points with an id in the frame "map", and a line in each direction, with the
 * length as its cost. What the points are is in their metadata. */
nlohmann::ordered_json
routeGraph(const DoorGraph& graph, std::uint32_t storey);

/** \brief How a kind of nodes is called. */
const char*
nameOf(DoorNodeKind kind);

} // namespace pcl::indoor::tool
