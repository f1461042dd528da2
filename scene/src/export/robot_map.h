/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/saved_scene.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Values of a map's cells, as ROS's map server takes them. */
enum MapCell : std::uint8_t { OccupiedCell = 0, UnknownCell = 205, FreeCell = 254 };

/** \brief A map of a storey, in the frame of a SavedScene. */
struct RobotMap {
  int nx = 0, ny = 0;
  double resolution = 0.0;                          ///< side of a cell, metres
  Eigen::Vector2d origin = Eigen::Vector2d::Zero(); ///< lower left corner
  std::vector<std::uint8_t> cells;                  ///< row by row from below

  std::uint8_t
  at(int x, int y) const
  {
    return cells[static_cast<std::size_t>(y) * nx + x];
  }
};

/** \brief Where a robot can go on a storey.
 *
 * Free are the rooms and the ways through doors and passages; occupied the walls and
 * 10 cm around what is free. With furniture, objects below head height are occupied,
 * and doors that were closed.
 * \param[in] resolution side of a cell, metres
 * \throws ToolError if there would be too many cells
 */
RobotMap
robotMap(const SavedScene& scene,
         std::uint32_t storey,
         double resolution,
         bool with_furniture);

/** \brief The map as a PGM file, from above. */
std::string
pgmBytes(const RobotMap& map);

/** \brief The file that tells a map server of it.
 * \param[in] image name of the PGM file */
std::string
mapYaml(const RobotMap& map, const std::string& image);

} // namespace pcl::indoor::tool
