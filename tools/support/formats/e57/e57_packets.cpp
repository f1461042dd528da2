/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: ASTM E2807-11, section 9.
#include "formats/e57/e57_packets.h"

#include "command_line/options.h" // for ToolError
#include "formats/file_header.h"  // for throwTruncated

#include <algorithm>
#include <cstring>

namespace pcl::indoor::tool {
namespace {

constexpr std::uint64_t between_marks = 1 << 16; // bytes: as much as the largest packet
constexpr std::size_t padding = 8;               // bytes behind the values

/** Bytes that hold the first values of a stream; bits that do not fit count as more. */
std::uint64_t
bytesOf(std::uint64_t values, const E57Field& field)
{
  return values / 8 * field.bits + (values % 8 * field.bits + 7) / 8;
}

} // namespace

E57Packets::E57Packets(E57Pages& pages, const E57Scan& scan, const Visit& visit)
: pages_(pages)
, scan_(scan)
{
  openSection();
  auto mark = marks_.front();
  std::vector<char> pieces;
  while (mark.place < end_ && needsMore(mark)) {
    if (mark.place - marks_.back().place >= between_marks)
      marks_.push_back(mark);
    const auto packet = packetAt(mark.place);
    pieces.resize(packet.size);
    pages_.read(mark.place, pieces.data(), pieces.size()); // checks all of its pages
    std::size_t at = 6 + 2 * packet.lengths.size();
    for (std::size_t f = 0; f < packet.lengths.size(); ++f) {
      visit(f, &pieces[at], packet.lengths[f]);
      at += packet.lengths[f];
      mark.bytes[f] += packet.lengths[f];
    }
    mark.place += packet.size;
  }
  requireAllValues(mark);
}

void
E57Packets::refuse(const std::string& problem) const
{
  throw ToolError(pages_.path() + ": the file is damaged, " + problem + " of '" +
                  scan_.name + "'");
}

void
E57Packets::openSection()
{
  struct {
    char id, reserved[7];
    std::uint64_t length, data, index;
  } header;
  static_assert(sizeof(header) == 32);
  const auto begin = pages_.logicalPlace(scan_.section, "the points");
  pages_.read(begin, &header, sizeof(header));
  if (header.id != 1)
    refuse("no points stand at the place");
  end_ = begin + std::min(header.length, pages_.size() - begin);
  const auto data = pages_.logicalPlace(header.data, "a packet of points");
  if (data < begin)
    refuse("packets stand before the points");
  marks_.push_back({data, std::vector<std::uint64_t>(scan_.fields.size(), 0)});
}

E57Packets::Packet
E57Packets::packetAt(std::uint64_t place)
{
  enum Type { Index = 0, Data = 1, Empty = 2 };
  unsigned char bytes[6];
  pages_.read(place, bytes, 4);
  Packet packet;
  packet.size = (bytes[2] | bytes[3] << 8) + 1u;
  if (bytes[0] > Empty || packet.size < 4 || packet.size > pages_.size() - place)
    refuse("a packet is none");
  if (bytes[0] != Data)
    return packet;
  pages_.read(place + 4, bytes + 4, 2);
  const std::size_t streams = bytes[4] | bytes[5] << 8;
  std::vector<unsigned char> lengths(2 * streams);
  if (streams != scan_.fields.size() || packet.size < 6 + lengths.size())
    refuse("a packet has " + std::to_string(streams) + " streams for " +
           std::to_string(scan_.fields.size()) + " fields");
  pages_.read(place + 6, lengths.data(), lengths.size());
  std::size_t size = 6 + lengths.size();
  for (std::size_t f = 0; f < streams; ++f) {
    packet.lengths.push_back(lengths[2 * f] | lengths[2 * f + 1] << 8);
    size += packet.lengths.back();
  }
  if (size > packet.size)
    refuse("a packet is shorter than its content");
  return packet;
}

bool
E57Packets::needsMore(const Mark& mark) const
{
  for (std::size_t f = 0; f < scan_.fields.size(); ++f)
    if (mark.bytes[f] < bytesOf(scan_.count, scan_.fields[f]))
      return true;
  return false;
}

void
E57Packets::requireAllValues(const Mark& end) const
{
  std::uint64_t found = scan_.count;
  for (std::size_t f = 0; f < scan_.fields.size(); ++f) {
    const auto bits = scan_.fields[f].bits;
    if (bits > 0 && end.bytes[f] < bytesOf(scan_.count, scan_.fields[f]))
      found = std::min(found, end.bytes[f] / bits * 8 + end.bytes[f] % bits * 8 / bits);
  }
  if (found < scan_.count)
    throwTruncated(pages_.path(), scan_.count, found, "points of '" + scan_.name + "'");
}

std::vector<std::string>
E57Packets::read(std::uint64_t first,
                 std::size_t count,
                 const std::vector<std::size_t>& fields)
{
  struct Range {
    std::uint64_t begin, end;
  };
  std::vector<Range> ranges;
  std::vector<std::string> streams;
  for (const auto f : fields) {
    const auto bits = scan_.fields[f].bits;
    ranges.push_back({first / 8 * bits + first % 8 * bits / 8,
                      bytesOf(first + count, scan_.fields[f])});
    streams.emplace_back().reserve(ranges.back().end - ranges.back().begin + padding);
  }
  const auto lies_before = [&](const Mark& mark) {
    for (std::size_t k = 0; k < fields.size(); ++k)
      if (mark.bytes[fields[k]] > ranges[k].begin)
        return false;
    return true;
  };
  auto mark =
      *(std::partition_point(marks_.begin() + 1, marks_.end(), lies_before) - 1);
  const auto wants_more = [&] {
    for (std::size_t k = 0; k < fields.size(); ++k)
      if (mark.bytes[fields[k]] < ranges[k].end)
        return true;
    return false;
  };
  while (wants_more()) {
    if (mark.place >= end_)
      throw ToolError(pages_.path() + ": the file can no longer be read");
    const auto packet = packetAt(mark.place);
    std::vector<std::uint64_t> places(packet.lengths.size());
    std::uint64_t place = mark.place + 6 + 2 * packet.lengths.size();
    for (std::size_t f = 0; f < places.size(); ++f) {
      places[f] = place;
      place += packet.lengths[f];
    }
    for (std::size_t k = 0; k < fields.size() && !places.empty(); ++k) {
      auto& begin = mark.bytes[fields[k]];
      const auto from = std::max(begin, ranges[k].begin);
      const auto end = std::min(begin + packet.lengths[fields[k]], ranges[k].end);
      if (from < end) {
        const auto size = streams[k].size();
        streams[k].resize(size + (end - from));
        pages_.read(places[fields[k]] + (from - begin), &streams[k][size], end - from);
      }
    }
    for (std::size_t f = 0; f < places.size(); ++f)
      mark.bytes[f] += packet.lengths[f];
    mark.place += packet.size;
  }
  for (auto& stream : streams)
    stream.append(padding, '\0');
  return streams;
}

} // namespace pcl::indoor::tool
