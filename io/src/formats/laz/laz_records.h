/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/laz/chunk_decoder.h"
#include "formats/laz/chunk_table.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Decodes the records of the points of a LAZ file: those of the LAS file that
 * it was made of, bit by bit.
 *
 * LASzip's compressors 1 to 3, with all items of point formats 0 to 10 in all versions,
 * and chunks of one size or of many. Chunks are decoded in several threads. */
class LazRecords {
public:
  /** \param[in] bytes of the file, up to its points
   * \param[in] file_size in bytes
   * \throws ToolError if the file is damaged, or compressed in a way that is not known
   */
  LazRecords(const std::string& path,
             const std::string& bytes,
             const LasHeader& header,
             std::uint64_t file_size);

  /** \brief How many points the chunks have room for. */
  std::uint64_t
  capacity() const
  {
    return table_.points.back();
  }

  /** \brief How many points all chunks but the last have. */
  std::uint64_t
  fullPoints() const
  {
    return table_.size() == 0 ? 0 : table_.points[table_.size() - 1];
  }

  /** \brief Decode some points; fast where they follow the last ones that were decoded.
   * \param[out] records \a count of them
   * \throws ToolError if the file is damaged */
  void
  read(std::uint64_t first, std::size_t count, char* records);

private:
  /** Points of a chunk that are decoded in one go. */
  struct Piece {
    std::size_t chunk;
    std::uint64_t skipped, count; ///< points of the chunk
    char* records;
  };

  /** A decoder that has not yet come to the end of its chunk. */
  struct Open {
    std::unique_ptr<ChunkDecoder> decoder;
    std::size_t chunk = 0;
    std::uint64_t done = 0; ///< points
  };

  std::vector<Piece>
  pieces(std::uint64_t first, std::size_t count, char* records) const;

  /** Decode a piece.
   * \param[in,out] open a decoder of its chunk; without one, a new one */
  void
  read(const Piece& piece, Open& open) const;

  void
  decode(const Piece& piece, Open& open) const;

  std::string path_;
  LazLayout layout_;
  ChunkTable table_;
  std::size_t step_;
  std::uint64_t points_; ///< that the header promises
  Open open_;
};

} // namespace pcl::indoor::tool
