/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/laz/laz_layout.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Where the chunks of a LAZ file are, and which points are in them. */
struct ChunkTable {
  std::vector<std::uint64_t> bytes;  ///< where each begins, and where the last one ends
  std::vector<std::uint64_t> points; ///< the first one of each, and the end of the last

  std::size_t
  size() const
  {
    return bytes.size() - 1;
  }
};

/** \brief Read the table of chunks.
 *
 * Chunks of one size are taken for full ones, also the last. Without chunks, all points
 * are one.
 * \param[in] file_size in bytes
 * \throws ToolError if it is missing, or contradicts the file
 */
ChunkTable
readChunkTable(const std::string& path,
               const LasHeader& header,
               const LazLayout& layout,
               std::uint64_t file_size);

} // namespace pcl::indoor::tool
