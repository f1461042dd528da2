/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "text/text_table.h"

#include <pcl/indoor/exports.h>

#include <nlohmann/json.hpp>

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Which objects of a scene are looked for; all conditions must hold. */
struct SceneQuery {
  std::string object_class; ///< empty = any
  std::string room_name;    ///< of the room they are in; empty = any
  std::optional<std::uint32_t> room, storey;
  double min_size = 0.0; ///< of the longest side, metres
  double max_size = std::numeric_limits<double>::infinity();
  bool with_structure = false; ///< floors, walls and ceilings, too
  std::optional<Eigen::Vector3d>
      nearest;           ///< the nearest first; frame and unit of the file
  std::size_t count = 0; ///< at most so many; 0 = all
};

/** \brief Read scene.json.
 * \throws ToolError if the file is missing, is no scene, or one of another version
 */
PCL_INDOOR_EXPORTS nlohmann::ordered_json
readScene(const std::string& path);

/** \brief The rooms that are looked for, by number, name and storey, as they are in
 * the scene.
 * \throws ToolError if no room or storey of the scene has that name
 * \throws nlohmann::json::exception if the scene lacks a field
 */
PCL_INDOOR_EXPORTS std::vector<nlohmann::ordered_json>
matchingRooms(const nlohmann::ordered_json& scene, const SceneQuery& query);

/** \brief The objects that are looked for, as they are in the scene, in its order or by
 * their distance; then they have a field distance, metres, of the box.
 * \throws ToolError if no room, storey or class of the scene has that name
 * \throws nlohmann::json::exception if the scene lacks a field
 */
PCL_INDOOR_EXPORTS std::vector<nlohmann::ordered_json>
matchingObjects(const nlohmann::ordered_json& scene, const SceneQuery& query);

/** \brief Such objects as a table.
 * \param[in] with_distances which they have if the query names a place
 * \throws nlohmann::json::exception if one lacks a field
 */
PCL_INDOOR_EXPORTS TextTable
objectTable(const std::vector<nlohmann::ordered_json>& objects, bool with_distances);

/** \brief Such rooms as a table. */
PCL_INDOOR_EXPORTS TextTable
roomTable(const std::vector<nlohmann::ordered_json>& rooms);

/** \brief A sceneRoute() as a table, without the corners where it turns. */
PCL_INDOOR_EXPORTS TextTable
routeTable(const nlohmann::ordered_json& route);

} // namespace pcl::indoor::tool
