/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A mesh while it is read. */
struct Polygons {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/** \brief Add the triangles of a face with these corners, which all touch the first. */
inline void
addFan(const std::vector<std::uint32_t>& corners,
       std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  for (std::size_t k = 2; k < corners.size(); ++k)
    triangles.push_back({corners[0], corners[k - 1], corners[k]});
}

/** \brief Read an STL file, binary or text; every triangle has vertices of its own.
 * \param[in] path of the file, for messages
 * \throws ToolError if it is damaged or truncated
 */
Polygons
readStl(const std::string& content, const std::string& path);

/** \brief Read the triangles of a binary glTF 2.0 file (GLB), moved to their places by
 * its nodes, of all scenes. Its y axis points up.
 * \param[in] path of the file, for messages
 * \throws ToolError if it is damaged, or refers to other files or to compressed data
 */
Polygons
readGlb(const std::string& content, const std::string& path);

} // namespace pcl::indoor::tool
