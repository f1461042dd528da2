/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/pcd_writer.h"

#include "formats/file_header.h" // for numberText

#include <pcl/common/io.h> // for getFieldSize, getFieldType
#include <pcl/io/lzf.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

namespace pcl::indoor::tool {
namespace {

std::size_t
byteCount(const PCLPointField& field)
{
  return static_cast<std::size_t>(getFieldSize(field.datatype)) * field.count;
}

std::string
headerOf(const PCLPointCloud2& cloud,
         const std::vector<PCLPointField>& fields,
         const CloudFrame& frame,
         const std::string& encoding)
{
  std::string names, sizes, types, counts;
  for (const auto& field : fields) {
    names += " " + field.name;
    sizes += " " + std::to_string(getFieldSize(field.datatype));
    types += std::string(" ") + getFieldType(field.datatype);
    counts += " " + std::to_string(field.count);
  }
  std::string text = "# .PCD v0.7 - Point Cloud Data file format\n";
  if (!frame.offset.isZero(0.0))
    text += "# " + offsetText(frame.offset) + "\n";
  const auto& turn = frame.orientation;
  return text + "VERSION 0.7\nFIELDS" + names + "\nSIZE" + sizes + "\nTYPE" + types +
         "\nCOUNT" + counts + "\nWIDTH " + std::to_string(cloud.width) + "\nHEIGHT " +
         std::to_string(cloud.height) + "\nVIEWPOINT " + numberText(frame.origin.x()) +
         " " + numberText(frame.origin.y()) + " " + numberText(frame.origin.z()) + " " +
         numberText(turn.w()) + " " + numberText(turn.x()) + " " +
         numberText(turn.y()) + " " + numberText(turn.z()) + "\nPOINTS " +
         std::to_string(static_cast<std::size_t>(cloud.width) * cloud.height) +
         "\nDATA " + encoding + "\n";
}

/** The values of one field of all points, then those of the next. */
std::vector<std::uint8_t>
fieldByField(const PCLPointCloud2& cloud, const std::vector<PCLPointField>& fields)
{
  const auto point_count = static_cast<std::size_t>(cloud.width) * cloud.height;
  std::size_t bytes_per_point = 0;
  for (const auto& field : fields)
    bytes_per_point += byteCount(field);
  std::vector<std::uint8_t> bytes(point_count * bytes_per_point);
  auto* next = bytes.data();
  for (const auto& field : fields)
    for (std::size_t i = 0; i < point_count; ++i) {
      std::memcpy(
          next, &cloud.data[i * cloud.point_step + field.offset], byteCount(field));
      next += byteCount(field);
    }
  return bytes;
}

/** Nothing if the bytes do not shrink or are too many for the format. */
std::vector<std::uint8_t>
compressed(const std::vector<std::uint8_t>& bytes)
{
  const std::size_t largest = bytes.size() + bytes.size() / 16 + 64; // at 1 in 32 more
  if (largest > std::numeric_limits<std::uint32_t>::max())
    return {};
  std::vector<std::uint8_t> smaller(largest);
  smaller.resize(lzfCompress(bytes.data(),
                             static_cast<std::uint32_t>(bytes.size()),
                             smaller.data(),
                             static_cast<std::uint32_t>(largest)));
  return smaller.size() < bytes.size() ? smaller : std::vector<std::uint8_t>();
}

/** Those that are written. */
std::vector<PCLPointField>
fieldsOf(const PCLPointCloud2& cloud)
{
  std::vector<PCLPointField> fields;
  for (const auto& field : cloud.fields)
    if (field.name != "_") { // PCL's padding
      fields.push_back(field);
      fields.back().count = std::max(field.count, 1u); // 0: by old converters
    }
  return fields;
}

void
writePointByPoint(OutputFile& file,
                  const PCLPointCloud2& cloud,
                  const std::vector<PCLPointField>& fields)
{
  constexpr std::size_t block_size = 1 << 16;
  const auto point_count = static_cast<std::size_t>(cloud.width) * cloud.height;
  std::string block;
  for (std::size_t i = 0; i < point_count; ++i) {
    const auto* point =
        reinterpret_cast<const char*>(&cloud.data[i * cloud.point_step]);
    for (const auto& field : fields)
      block.append(point + field.offset, byteCount(field));
    if (block.size() >= block_size || i + 1 == point_count) {
      file.write(block);
      block.clear();
    }
  }
}

} // namespace

void
writePcd(OutputFile& file, const PCLPointCloud2& cloud, const CloudFrame& frame)
{
  const auto fields = fieldsOf(cloud);
  const auto bytes = fieldByField(cloud, fields);
  const auto smaller = compressed(bytes);
  if (smaller.empty()) {
    file.write(headerOf(cloud, fields, frame, "binary"));
    writePointByPoint(file, cloud, fields);
    return;
  }
  const std::uint32_t sizes[] = {static_cast<std::uint32_t>(smaller.size()),
                                 static_cast<std::uint32_t>(bytes.size())};
  file.write(headerOf(cloud, fields, frame, "binary_compressed"));
  file.write(sizes, sizeof(sizes));
  file.write(smaller.data(), smaller.size());
}

void
writePcdHeader(OutputFile& file, const PCLPointCloud2& layout, const CloudFrame& frame)
{
  file.write(headerOf(layout, fieldsOf(layout), frame, "binary"));
}

void
writePcdPart(OutputFile& file, const PCLPointCloud2& part)
{
  writePointByPoint(file, part, fieldsOf(part));
}

} // namespace pcl::indoor::tool
