/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/file_header.h"

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

enum class CloudFormat { PCD, PLY, LAS, Table, Mesh };

/** \brief Reads bytes in memory. */
using MemoryStream = boost::iostreams::stream<boost::iostreams::array_source>;

struct CheckedCloud {
  CloudFormat format = CloudFormat::PCD;
  std::uint64_t bytes = 0; ///< of all points of a PCD in memory
  FileHeader header;       ///< of a PCD
  /** All of a PCD file: whatever happens to the file afterwards does not matter, as it
   * would to the pages that PCL's reader maps. */
  std::string content;
  std::vector<std::string> notes; ///< see CloudFile::notes
};

/** \brief Find out what a cloud file is and, for a PCD, compare its header with what
 * follows it.
 *
 * PCL's reader trusts the header: it reads past the end of a short file or allocate
 * what a wrong number asks for.
 * \throws ToolError if the file cannot be read, is of no format that is read, has a
 * header that contradicts itself, no points, or fewer bytes or lines than its header
 * promises
 */
CheckedCloud
checkCloudFile(const std::string& path);

/** \brief How many points the header of a cloud file promises, or a table about has; 0
 * if it is not understood. Reads no more than the header. */
std::uint64_t
promisedPoints(const std::string& path);

} // namespace pcl::indoor::tool
