/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstdint>
#include <string>

namespace pcl::indoor::tool {

enum class CloudFormat { PCD, PLY };

struct CheckedCloud {
  CloudFormat format = CloudFormat::PCD;
  std::uint64_t bytes = 0; ///< of all points of a PCD in memory
};

/** \brief Find out what a cloud file is and, for a PCD, compare its header with what
 * follows it.
 *
 * PCL's reader trusts the header: it reads past the end of a short file or allocate
 * what a wrong number asks for.
 * \throws ToolError if the file cannot be read, is neither PCD nor PLY, has a header
 * that contradicts itself, no points, or fewer bytes or lines than its header
 * promises
 */
CheckedCloud
checkCloudFile(const std::string& path);

} // namespace pcl::indoor::tool
