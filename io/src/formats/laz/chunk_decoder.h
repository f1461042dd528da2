/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/laz/laz_layout.h"

#include <cstdint>
#include <memory>
#include <string>

namespace pcl::indoor::tool {

/** \brief Decodes the points of a chunk, one after the other. */
class ChunkDecoder {
public:
  virtual ~ChunkDecoder() = default;

  /** \brief Begin with the first point of a chunk.
   *
   * In memory are a window of the chunk's bytes, or all if it is layered.
   * \param[in] begin, end of its bytes in the file
   * \throws DamagedChunk if it cannot be one */
  static std::unique_ptr<ChunkDecoder>
  open(const std::string& path,
       const LazLayout& layout,
       std::uint64_t begin,
       std::uint64_t end);

  /** \brief Decode the next point.
   * \param[out] record of the point, as an uncompressed file has it
   * \throws DamagedChunk if there is none */
  virtual void
  next(char* record) = 0;

  /** \brief Were all bytes of the chunk needed? */
  virtual bool
  isAtEnd() const = 0;
};

/** \brief Are all items of a layout of known versions? */
bool
isKnown(const LazLayout& layout);

} // namespace pcl::indoor::tool
