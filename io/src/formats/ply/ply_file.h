/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "files/cloud_stream.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Is it a PLY file, by its first word? */
bool
isPly(const std::string& path, const std::string& beginning);

/** \brief How many points the header promises.
 * \throws ToolError if it cannot be read */
std::uint64_t
plyPointCount(const std::string& path, const std::string& beginning);

/** \brief Open a binary file whose points are records of one size at its beginning.
 * \return null if it is another one: ASCII, lists, faces
 * \throws ToolError as loadPly()
 */
std::unique_ptr<CloudStream>
openPly(const std::string& path);

/** \brief Read the points of a PLY file (ascii, little or big endian) with all their
 * properties, and the pose of the element "camera", if there is one; its viewport gives
 * rows and columns if these fit the points.
 *
 * Lists are left out. PCL's own reader is not used because it stops the program at a
 * damaged file.
 * \throws ToolError if the file is no PLY, has no points, or fewer than its header
 * promises
 */
void
loadPly(CloudFile& file, const TableColumns& columns);

/** \brief Does the header of a file say that it is a PLY with faces?
 * \throws ToolError as loadPly()
 */
bool
hasPlyFaces(const std::string& path);

/** \brief Read the faces of a PLY file: per face the numbers of its vertices, from 0.
 * \return none if the file is no PLY or has no faces
 * \throws ToolError if it is damaged or has fewer faces than its header promises
 */
std::vector<std::vector<std::uint32_t>>
readPlyFaces(const std::string& path);

} // namespace pcl::indoor::tool
