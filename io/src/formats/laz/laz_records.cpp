/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/laz/laz_records.h"

#include "files/tool_error.h"
#include "formats/laz/byte_source.h"
#include "formats/reader_threads.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>

#include <algorithm>

namespace pcl::indoor::tool {

LazRecords::LazRecords(const std::string& path,
                       const std::string& bytes,
                       const LasHeader& header,
                       std::uint64_t file_size)
: path_(path)
, layout_(readLazLayout(bytes, header, path))
, table_(readChunkTable(path, header, layout_, file_size))
, step_(header.step)
, points_(header.points)
{
  if (!isKnown(layout_))
    throw ToolError(path + ": the points of this LAZ file are compressed by a version "
                           "of LASzip that is not known");
}

void
LazRecords::read(std::uint64_t first, std::size_t count, char* records)
{
  const auto all = pieces(first, count, records);
  if (all.empty())
    return;
  std::vector<Open> open(all.size());
  if (open_.decoder && open_.chunk == all[0].chunk && open_.done <= all[0].skipped)
    open[0] = std::move(open_);
  constexpr std::size_t points_of_thread = 1 << 14; // some milliseconds
  const auto last = static_cast<std::ptrdiff_t>(all.size()) - 1;
  const int threads = usefulThreads(readerThreads(), count, points_of_thread);
  parallelFor(last + 1, threads, 1, [&](std::ptrdiff_t i) {
    const auto which = static_cast<std::size_t>(i);
    read(all[which], open[which]);
    if (i < last) // whose chunk the next points go on with
      open[which] = {};
  });
  open_ = std::move(open.back());
}

std::vector<LazRecords::Piece>
LazRecords::pieces(std::uint64_t first, std::size_t count, char* records) const
{
  std::vector<Piece> all;
  const auto& begins = table_.points;
  const std::uint64_t end = first + count;
  auto next = std::upper_bound(begins.begin(), begins.end(), first);
  while (first < end && next != begins.end()) {
    const auto chunk = static_cast<std::size_t>(next - begins.begin()) - 1;
    const auto taken = std::min(*next, end) - first;
    if (taken > 0)
      all.push_back({chunk, first - begins[chunk], taken, records});
    records += taken * step_;
    first += taken;
    ++next;
  }
  return all;
}

void
LazRecords::read(const Piece& piece, Open& open) const
{
  try {
    decode(piece, open);
  } catch (const DamagedChunk& damage) {
    throw ToolError(path_ + ": the file is damaged in chunk " +
                    std::to_string(piece.chunk + 1) + " of " +
                    std::to_string(table_.size()) + ": " + damage.what());
  }
}

void
LazRecords::decode(const Piece& piece, Open& open) const
{
  if (!open.decoder)
    open = {
        ChunkDecoder::open(
            path_, layout_, table_.bytes[piece.chunk], table_.bytes[piece.chunk + 1]),
        piece.chunk,
        0};
  std::string skipped(step_, '\0');
  for (; open.done < piece.skipped; ++open.done)
    open.decoder->next(skipped.data());
  for (std::uint64_t i = 0; i < piece.count; ++i)
    open.decoder->next(piece.records + i * step_);
  open.done += piece.count;
  const auto end = std::min(table_.points[piece.chunk + 1], points_);
  if (table_.points[piece.chunk] + open.done < end)
    return;
  if (layout_.compressor != LazLayout::Compressor::PointWise &&
      !open.decoder->isAtEnd())
    throw DamagedChunk("its points do not end where it ends");
  open = {};
}

} // namespace pcl::indoor::tool
