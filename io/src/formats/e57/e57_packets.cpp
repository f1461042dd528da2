/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: ASTM E2807-11, section 9.
#include "formats/e57/e57_packets.h"

#include "files/tool_error.h"
#include "formats/file_header.h" // for throwTruncated

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
  size_ = mark.place - marks_.front().place;
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

E57Packets::Wanted
E57Packets::wantedOf(std::size_t field, std::uint64_t first, std::size_t count) const
{
  const auto bits = scan_.fields[field].bits;
  Wanted wanted;
  wanted.field = field;
  wanted.begin = first / 8 * bits + first % 8 * bits / 8;
  wanted.end = bytesOf(first + count, scan_.fields[field]);
  const auto behind =
      std::partition_point(marks_.begin() + 1, marks_.end(), [&](const Mark& mark) {
        return mark.bytes[field] <= wanted.begin;
      });
  wanted.mark = static_cast<std::size_t>(behind - marks_.begin()) - 1;
  return wanted;
}

/** Read bytes that lie near each other, none of them before a mark. */
void
E57Packets::gather(const std::vector<Wanted>& wanted, Mark mark)
{
  const auto has_all = [&mark](const Wanted& w) {
    return mark.bytes[w.field] >= w.end;
  };
  while (!std::all_of(wanted.begin(), wanted.end(), has_all)) {
    if (mark.place >= end_)
      throw ToolError(pages_.path() + ": the file can no longer be read");
    const auto packet = packetAt(mark.place);
    auto place = mark.place + 6 + 2 * packet.lengths.size();
    auto next = wanted.begin(); // they are in the order of their fields
    for (std::size_t f = 0; f < packet.lengths.size(); ++f) {
      auto& begin = mark.bytes[f];
      if (next != wanted.end() && next->field == f) {
        const auto from = std::max(begin, next->begin);
        const auto end = std::min(begin + packet.lengths[f], next->end);
        if (from < end) {
          auto& bytes = *next->bytes;
          bytes.resize(bytes.size() + (end - from));
          pages_.read(
              place + (from - begin), &bytes[bytes.size() - (end - from)], end - from);
        }
        ++next;
      }
      begin += packet.lengths[f];
      place += packet.lengths[f];
    }
    mark.place += packet.size;
  }
}

std::vector<std::string>
E57Packets::read(std::uint64_t first,
                 std::size_t count,
                 const std::vector<std::size_t>& fields)
{
  constexpr std::size_t near = 2; // marks: fields of a point lie in one packet or two
  std::vector<std::string> streams(fields.size());
  std::vector<Wanted> left;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    left.push_back(wantedOf(fields[k], first, count));
    left.back().bytes = &streams[k];
    streams[k].reserve(left.back().end - left.back().begin + padding);
  }
  const auto is_earlier = [](const Wanted& a, const Wanted& b) {
    return a.mark < b.mark;
  };
  std::sort(left.begin(), left.end(), is_earlier);
  for (auto begin = left.begin(); begin != left.end();) {
    const auto earliest = begin->mark;
    const auto end = std::find_if(begin, left.end(), [earliest](const Wanted& wanted) {
      return wanted.mark > earliest + near;
    });
    std::vector<Wanted> together(begin, end);
    std::sort(together.begin(), together.end(), [](const auto& a, const auto& b) {
      return a.field < b.field;
    });
    gather(together, marks_[earliest]);
    begin = end;
  }
  for (auto& stream : streams)
    stream.append(padding, '\0');
  return streams;
}

} // namespace pcl::indoor::tool
