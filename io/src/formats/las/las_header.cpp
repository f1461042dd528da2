/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: ASPRS, LAS Specification 1.4, R15.
#include "formats/las/las_header.h"

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t smallest_header = 227; // of LAS 1.0 to 1.2

constexpr std::array<LasPointFormat, 11> point_formats = {{{20, 15, 18, 0, 0, 0},
                                                           {28, 15, 18, 20, 0, 0},
                                                           {26, 15, 18, 0, 20, 0},
                                                           {34, 15, 18, 20, 28, 0},
                                                           {57, 15, 18, 20, 0, 0},
                                                           {63, 15, 18, 20, 28, 0},
                                                           {30, 16, 20, 22, 0, 0},
                                                           {36, 16, 20, 22, 30, 0},
                                                           {38, 16, 20, 22, 30, 36},
                                                           {59, 16, 20, 22, 0, 0},
                                                           {67, 16, 20, 22, 30, 36}}};

/** Where records begin that follow the points, of version 1.3 or later; 0 = nowhere. */
std::uint64_t
bodyEnd(const std::string& bytes, std::size_t header_size, std::size_t body_begin)
{
  constexpr std::size_t waveforms = 227, more_records = 235;
  std::uint64_t end = 0;
  for (const auto place : {waveforms, more_records})
    if (header_size >= place + 8 && bytes.size() >= place + 8)
      if (const auto begin = numberAt<std::uint64_t>(&bytes[place]);
          begin > body_begin && (end == 0 || begin < end))
        end = begin;
  return end;
}

} // namespace

const LasPointFormat&
LasHeader::places() const
{
  return point_formats[format];
}

bool
LasHeader::isWithheld(const char* point) const
{
  constexpr std::size_t flags = 15;
  return (static_cast<unsigned char>(point[flags]) & (isLong() ? 4 : 0x80)) != 0;
}

std::optional<LasHeader>
parseLasHeader(const std::string& bytes)
{
  if (bytes.size() < smallest_header || bytes.compare(0, 4, "LASF") != 0)
    return {};
  LasHeader header;
  header.header_size = numberAt<std::uint16_t>(&bytes[94]);
  header.body_begin = numberAt<std::uint32_t>(&bytes[96]);
  header.records = numberAt<std::uint32_t>(&bytes[100]);
  const auto format = numberAt<std::uint8_t>(&bytes[104]); // two bits are of LAZ
  header.format = format & 0x3fu;
  header.is_compressed = (format & 0x80u) != 0;
  header.step = numberAt<std::uint16_t>(&bytes[105]);
  header.points = numberAt<std::uint32_t>(&bytes[107]);
  constexpr std::size_t long_count = 247; // of version 1.4
  if (bytes[25] >= 4 && header.header_size >= long_count + 8 &&
      bytes.size() >= long_count + 8)
    if (const auto points = numberAt<std::uint64_t>(&bytes[long_count]); points > 0)
      header.points = points;
  header.body_end = bodyEnd(bytes, header.header_size, header.body_begin);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.scales[axis] = numberAt<double>(&bytes[131 + 8 * axis]);
    header.offsets[axis] = numberAt<double>(&bytes[155 + 8 * axis]);
  }
  if (bytes[24] != 1 || header.header_size < smallest_header ||
      header.body_begin < header.header_size || header.format >= point_formats.size() ||
      header.step < point_formats[header.format].size)
    return {};
  return header;
}

std::string_view
lasRecord(const std::string& bytes,
          const LasHeader& header,
          std::string_view user,
          std::uint16_t id)
{
  constexpr std::size_t record_header = 54;
  std::size_t place = header.header_size;
  for (std::size_t r = 0; r < header.records; ++r) {
    if (place + record_header > bytes.size())
      return {};
    const std::string_view own(&bytes[place + 2], strnlen(&bytes[place + 2], 16));
    const auto own_id = numberAt<std::uint16_t>(&bytes[place + 18]);
    const std::size_t length = numberAt<std::uint16_t>(&bytes[place + 20]);
    place += record_header;
    if (place + length > bytes.size())
      return {};
    if (own == user && own_id == id)
      return std::string_view(bytes).substr(place, length);
    place += length;
  }
  return {};
}

} // namespace pcl::indoor::tool
