/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/file_header.h"
#include "formats/ply/ply_body.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A value, or a list of values, of each of an element. */
struct PlyProperty {
  std::string name;
  std::uint8_t type = 0;      ///< of PCLPointField
  std::uint8_t list_type = 0; ///< of the number of values; 0: one value, no list
};

/** \brief Points, faces, ...: so many of a kind with the same properties. */
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

/** \brief What the header of a PLY file says of its elements.
 * \throws ToolError if it contradicts itself
 */
std::vector<PlyElement>
elementsOf(const FileHeader& header, const std::string& path);

/** \brief How the elements are written.
 * \throws ToolError if the header does not say it
 */
PlyBody::Encoding
encodingOf(const FileHeader& header, const std::string& path);

} // namespace pcl::indoor::tool
