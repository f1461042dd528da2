/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/file_header.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What the header of a PCD says of its points. */
struct PcdHeader {
  std::vector<std::uint64_t> sizes, counts; ///< of each field: bytes, values
  std::vector<std::string> types;           ///< of each field: F, I or U
  std::size_t fields = 0;
  std::uint64_t width = 0, height = 1, points = 0;
  bool has_points = false; ///< it has the line POINTS
  std::string data;        ///< ascii, binary or binary_compressed

  std::uint64_t
  valuesPerPoint() const;

  std::uint64_t
  bytesPerPoint() const;
};

/** \brief Read a header that agrees with itself: PCL's reader would trust any.
 * \throws ToolError if it does not, or promises no points
 */
PcdHeader
readPcdHeader(const FileHeader& header, const std::string& path);

} // namespace pcl::indoor::tool
