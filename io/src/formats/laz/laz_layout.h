/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/las/las_header.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A part of each point that is compressed by itself. */
struct LazItem {
  /** Numbers of the format; those named long and layered are of point formats 6 to 10.
   */
  enum class Type : std::uint16_t {
    Bytes = 0,
    Core = 6,
    Time = 7,
    Color = 8,
    Wave = 9,
    LayeredCore = 10,
    LayeredColor = 11,
    LayeredColorInfrared = 12,
    LayeredWave = 13,
    LayeredBytes = 14
  };
  Type type;
  std::size_t size; ///< bytes in a point
  unsigned version;
};

/** \brief How the points of a LAZ file are compressed. */
struct LazLayout {
  enum class Compressor : std::uint16_t { PointWise = 1, Chunked = 2, Layered = 3 };
  static constexpr std::uint32_t variable_chunks = 0xffffffffu;

  Compressor compressor = Compressor::Chunked;
  std::uint32_t chunk_size = variable_chunks; ///< points, of all chunks but the last
  std::vector<LazItem> items;

  bool
  isLayered() const
  {
    return compressor == Compressor::Layered;
  }
};

/** \brief Find the record that tells it.
 * \param[in] bytes of the file, up to its points
 * \throws ToolError if there is none, or one that cannot be read
 */
LazLayout
readLazLayout(const std::string& bytes,
              const LasHeader& header,
              const std::string& path);

} // namespace pcl::indoor::tool
