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
  std::vector<std::string> fields;          ///< their names
  std::vector<std::uint64_t> sizes, counts; ///< of each field: bytes, values
  std::vector<std::string> types;           ///< of each field: F, I or U
  std::uint64_t width = 0, height = 1, points = 0;
  bool has_points = false;        ///< it has the line POINTS
  std::string data;               ///< ascii, binary or binary_compressed
  std::vector<std::string> notes; ///< see CloudFile::notes

  std::uint64_t
  bytesPerPoint() const;

  /** \brief Note that binary points are left out, if there are more than promised.
   * \param[in] body bytes behind the header */
  void
  noteBytes(std::uint64_t body);
};

/** \brief Read a header that agrees with itself: PCL's reader would trust any.
 * \param[in,out] header loses the fields of COUNT 0, which have no bytes and which
 * PCL's reader refuses
 * \throws ToolError if it does not, or promises no points
 */
PcdHeader
readPcdHeader(FileHeader& header, const std::string& path);

/** \brief The header as PCL's reader wants it.
 * \param[in] one_point as of a file of a single point: for more, it takes memory
 */
std::string
pcdHeaderText(const FileHeader& header, bool one_point);

} // namespace pcl::indoor::tool
