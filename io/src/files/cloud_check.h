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

/** \brief Reads bytes in memory. */
using MemoryStream = boost::iostreams::stream<boost::iostreams::array_source>;

/** \brief A PCD file whose header fits what follows it. */
struct CheckedPcd {
  std::uint64_t bytes = 0; ///< of all points in memory
  FileHeader header;
  /** All of the file: whatever happens to it afterwards does not matter, as it would to
   * the pages that PCL's reader maps. */
  std::string content;
  std::vector<std::string> notes; ///< see CloudFile::notes
};

/** \brief Compare the header of a PCD file with what follows it.
 *
 * PCL's reader trusts the header: it reads past the end of a short file or allocates
 * what a wrong number asks for.
 * \throws ToolError if its header contradicts itself, or if it has no points, or fewer
 * bytes or lines than its header promises
 */
CheckedPcd
checkPcdFile(const std::string& path);

} // namespace pcl::indoor::tool
