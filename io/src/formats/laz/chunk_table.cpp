/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: LAZ Specification 1.4, R1.
#include "formats/laz/chunk_table.h"

#include "files/tool_error.h"
#include "formats/laz/integer_decoder.h"

#include <array>
#include <fstream>

namespace pcl::indoor::tool {
namespace {

constexpr std::uint64_t place_size = 8; // of the place of the table, before the chunks
constexpr std::uint64_t table_header = 8; // version, number of chunks

/** Where the table is; 0: nowhere. Writers that could not go back tell it at the end of
 * the file. */
std::uint64_t
tablePlace(std::ifstream& stream, std::uint64_t body_begin, std::uint64_t file_size)
{
  constexpr std::int64_t at_the_end = -1;
  std::int64_t place = 0;
  const auto read_at = [&](std::uint64_t where) {
    stream.seekg(static_cast<std::streamoff>(where));
    if (!stream.read(reinterpret_cast<char*>(&place), sizeof(place)))
      place = 0;
  };
  read_at(body_begin);
  if (place == at_the_end)
    read_at(file_size - place_size);
  const auto table = static_cast<std::uint64_t>(place);
  return place > 0 && table >= body_begin + place_size &&
                 table <= file_size - table_header
             ? table
             : 0;
}

/** The points and the bytes of some chunks, added up. */
void
readEntries(ArithmeticDecoder& decoder,
            const LazLayout& layout,
            std::uint32_t count,
            ChunkTable& table)
{
  const bool is_variable = layout.chunk_size == LazLayout::variable_chunks;
  IntegerDecoder numbers(32, 2);
  std::int32_t points = 0, bytes = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (is_variable)
      points = numbers.next(decoder, points, 0);
    bytes = numbers.next(decoder, bytes, 1);
    table.points.push_back(
        table.points.back() +
        (is_variable ? static_cast<std::uint32_t>(points) : layout.chunk_size));
    table.bytes.push_back(table.bytes.back() + static_cast<std::uint32_t>(bytes));
  }
}

[[noreturn]] void
throwDamaged(const std::string& path)
{
  throw ToolError(path + ": the table of the chunks of this LAZ file is damaged");
}

} // namespace

ChunkTable
readChunkTable(const std::string& path,
               const LasHeader& header,
               const LazLayout& layout,
               std::uint64_t file_size)
{
  if (layout.compressor == LazLayout::Compressor::PointWise)
    return {{header.body_begin, file_size}, {0, header.points}};
  std::ifstream stream(path, std::ios::binary);
  const auto place = file_size < header.body_begin + place_size + table_header
                         ? 0
                         : tablePlace(stream, header.body_begin, file_size);
  if (place == 0)
    throw ToolError(path + ": this LAZ file has no table of its chunks: it was not "
                           "finished by its writer, or is truncated");
  std::array<std::uint32_t, 2> begin{}; // version, number of chunks
  stream.clear();
  stream.seekg(static_cast<std::streamoff>(place));
  stream.read(reinterpret_cast<char*>(begin.data()), table_header);
  ChunkTable table{{header.body_begin + place_size}, {0}};
  // each chunk begins with a point that is not compressed
  if (!stream || begin[0] != 0 || begin[1] > (place - table.bytes[0]) / header.step)
    throwDamaged(path);
  try {
    ArithmeticDecoder decoder(ByteSource(path, place + table_header, file_size));
    if (begin[1] > 0) {
      decoder.start();
      readEntries(decoder, layout, begin[1], table);
    }
  } catch (const DamagedChunk&) {
    throwDamaged(path);
  }
  if (table.bytes.back() != place)
    throwDamaged(path);
  return table;
}

} // namespace pcl::indoor::tool
