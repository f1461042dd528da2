/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_stream.h"

#include <cstdint>
#include <memory>
#include <string>

namespace pcl::indoor::tool {

/** \brief Is it an E57 file (ASTM E2807), by its first bytes? */
bool
isE57(const std::string& path, const std::string& beginning);

/** \brief How many points the scans of an E57 file have.
 * \throws ToolError if its description is damaged */
std::uint64_t
e57PointCount(const std::string& path, const std::string& beginning);

/** \brief Open an E57 file, after a look at all of its points.
 *
 * Several scans are joined as several files are, see joinedStream(): with the field
 * station. Scans without points are left out. For the fields see E57Points. Images are
 * not looked at.
 * \throws ToolError if the file is damaged anywhere, has no points, or fewer than it
 * promises
 */
std::unique_ptr<CloudStream>
openE57(const std::string& path);

} // namespace pcl::indoor::tool
