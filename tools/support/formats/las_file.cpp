/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: ASPRS, LAS Specification 1.4, R15.
#include "formats/las_file.h"

#include "command_line/options.h" // for ToolError
#include "formats/file_header.h"  // for throwTruncated
#include "formats/las_fields.h"
#include "formats/las_header.h"

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <vector>

namespace pcl::indoor::tool {
namespace {

/** What a look at all points of a file tells. */
struct LasLook {
  std::uint64_t withheld = 0;
  std::uint16_t largest_color = 0;
};

LasLook
lookAt(std::ifstream& stream, const LasHeader& header)
{
  constexpr std::size_t points_at_once = 1 << 16;
  const auto colors = header.places().colors;
  LasLook look;
  std::string bytes;
  stream.seekg(static_cast<std::streamoff>(header.body_begin));
  for (std::uint64_t done = 0; done < header.points; done += points_at_once) {
    const auto count = std::min<std::uint64_t>(points_at_once, header.points - done);
    bytes.resize(count * header.step);
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(stream.gcount()) / header.step * header.step);
    for (std::size_t at = 0; at < bytes.size(); at += header.step) {
      look.withheld += header.isWithheld(&bytes[at]);
      for (std::size_t channel = 0; channel < 3 && colors > 0; ++channel)
        look.largest_color =
            std::max(look.largest_color,
                     numberAt<std::uint16_t>(&bytes[at + colors + 2 * channel]));
    }
  }
  return look;
}

/** Copies the fields of a point; of one that is withheld without its place. */
std::function<void(const char*, char*)>
copierOf(const std::vector<LasField>& fields,
         const LasLook& look,
         const LasHeader& header)
{
  return [fields, has_withheld = look.withheld > 0, header](const char* record,
                                                            char* point) {
    char* const begin = point;
    for (const auto& field : fields) {
      field.copy(record, point);
      point += field.size;
    }
    constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
    if (has_withheld && header.isWithheld(record))
      for (std::size_t axis = 0; axis < 3; ++axis)
        std::memcpy(begin + axis * sizeof(double), &nowhere, sizeof(double));
  };
}

/** Fields and width of the cloud. */
void
layOut(const std::vector<LasField>& fields,
       const LasHeader& header,
       PCLPointCloud2& layout)
{
  layout.width = static_cast<std::uint32_t>(header.points);
  layout.height = 1;
  for (const auto& field : fields) {
    PCLPointField about;
    about.name = field.name;
    about.offset = layout.point_step;
    about.datatype = field.type;
    about.count = 1;
    layout.fields.push_back(about);
    layout.point_step += static_cast<std::uint32_t>(field.size);
  }
  layout.row_step = layout.point_step * layout.width;
}

void
addLookNotes(const LasLook& look, std::vector<std::string>& notes)
{
  if (look.largest_color > 0 && look.largest_color <= 255)
    notes.emplace_back(
        "its colours have 8 bits in fields of 16, none exceeds 255: they "
        "are taken as they are");
  if (look.withheld > 0)
    notes.push_back("points that are flagged as withheld are left out: " +
                    std::to_string(look.withheld));
}

/** Make the number of points fit to the file, as far as it can. */
void
chooseCount(const std::string& path,
            std::uint64_t file_size,
            LasHeader& header,
            std::vector<std::string>& notes)
{
  const auto end =
      header.body_end > 0 ? std::min(header.body_end, file_size) : file_size;
  const std::uint64_t held = (file_size - header.body_begin) / header.step;
  const std::uint64_t whole = (end - header.body_begin) / header.step;
  if (held < header.points)
    throwTruncated(path, header.points, held, "points");
  if (header.points == 0 && whole > 0) {
    header.points = whole;
    notes.push_back("its header promises no points; the " + std::to_string(whole) +
                    " that it holds are read");
  }
  else if (header.points < whole)
    notes.push_back("points beyond the number that its header promises are left out: " +
                    std::to_string(whole - header.points));
  if (header.points > 0x7fffffff)
    throw ToolError(path + ": more than 2^31 - 1 points");
}

} // namespace

bool
isLas(const std::string& /*path*/, const std::string& beginning)
{
  constexpr std::size_t format_place = 104; // whose highest bit says LAZ
  return beginning.compare(0, 4, "LASF") == 0 && beginning.size() > format_place &&
         (static_cast<unsigned char>(beginning[format_place]) & 0x80) == 0;
}

std::uint64_t
lasPointCount(const std::string& /*path*/, const std::string& beginning)
{
  const auto header = parseLasHeader(beginning);
  return header ? header->points : 0;
}

LasRecords
lasRecords(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(512, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  auto header = parseLasHeader(bytes);
  if (!header)
    throw ToolError(path + ": the header of this LAS file is damaged, or of a version "
                           "other than 1.0 to 1.4");
  stream.clear();
  stream.seekg(0, std::ios::end);
  const auto size = static_cast<std::uint64_t>(stream.tellg());
  if (header->body_begin > size)
    throwTruncated(path, header->body_begin, size, "bytes before its points");
  for (const double scale : header->scales)
    if (!(std::abs(scale) > 0))
      throw ToolError(path + ": the header of this LAS file has the scale 0, by which "
                             "all points are one");
  LasRecords records;
  chooseCount(path, size, *header, records.notes);
  const auto look = lookAt(stream, *header);
  stream.clear();
  bytes.resize(header->body_begin);
  stream.seekg(0);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const auto fields =
      lasFields(bytes, *header, look.largest_color > 255 ? 8 : 0, records.notes);
  records.body_begin = header->body_begin;
  records.record_size = header->step;
  records.copy = copierOf(fields, look, *header);
  addLookNotes(look, records.notes);
  layOut(fields, *header, records.layout);
  return records;
}

PCLPointCloud2
readLas(const std::string& path, std::vector<std::string>& notes)
{
  const auto records = lasRecords(path);
  notes = records.notes;
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  auto cloud = records.layout;
  if (bytes.size() < records.body_begin + records.record_size * cloud.width)
    throw ToolError(path + ": the file has become shorter");
  cloud.data.resize(static_cast<std::size_t>(cloud.point_step) * cloud.width);
  const char* record = bytes.data() + records.body_begin;
  auto* target = reinterpret_cast<char*>(cloud.data.data());
  for (std::uint32_t i = 0; i < cloud.width; ++i) {
    records.copy(record, target);
    record += records.record_size;
    target += cloud.point_step;
  }
  return cloud;
}

} // namespace pcl::indoor::tool
