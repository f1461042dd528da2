/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/pcd/pcd_writer.h"

#include "files/field_value.h"
#include "formats/file_header.h" // for shortestText

#include <pcl/common/io.h> // for getFieldSize, getFieldType
#include <pcl/indoor/parallel_for.h>
#include <pcl/io/lzf.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

namespace pcl::indoor::tool {
namespace {

std::size_t
sizeOf(const std::vector<std::vector<std::uint8_t>>& blocks)
{
  std::size_t size = 0;
  for (const auto& block : blocks)
    size += block.size();
  return size;
}

std::string
headerOf(const PCLPointCloud2& cloud,
         const std::vector<PCLPointField>& fields,
         const CloudPose& pose,
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
  if (!pose.offset.isZero(0.0))
    text += "# " + offsetText(pose.offset) + "\n";
  const auto& turn = pose.orientation;
  return text + "VERSION 0.7\nFIELDS" + names + "\nSIZE" + sizes + "\nTYPE" + types +
         "\nCOUNT" + counts + "\nWIDTH " + std::to_string(cloud.width) + "\nHEIGHT " +
         std::to_string(cloud.height) + "\nVIEWPOINT " + shortestText(pose.origin.x()) +
         " " + shortestText(pose.origin.y()) + " " + shortestText(pose.origin.z()) +
         " " + shortestText(turn.w()) + " " + shortestText(turn.x()) + " " +
         shortestText(turn.y()) + " " + shortestText(turn.z()) + "\nPOINTS " +
         std::to_string(static_cast<std::size_t>(cloud.width) * cloud.height) +
         "\nDATA " + encoding + "\n";
}

/** Some values of one field. */
struct FieldBlock {
  const PCLPointField* field;
  std::size_t first, count; ///< points
};

/** All values of one field, then those of the next. Blocks are compressed by
 * themselves: one after the other they are what all together would unpack to, and each
 * fits into the caches. */
std::vector<FieldBlock>
blocksOf(const std::vector<PCLPointField>& fields, std::size_t point_count)
{
  constexpr std::size_t block_bytes = 1 << 19;
  std::vector<FieldBlock> blocks;
  for (const auto& field : fields) {
    const auto most = std::max<std::size_t>(block_bytes / byteCount(field), 1);
    for (std::size_t first = 0; first < point_count; first += most)
      blocks.push_back({&field, first, std::min(most, point_count - first)});
  }
  return blocks;
}

std::vector<std::uint8_t>
compressed(const PCLPointCloud2& cloud, const FieldBlock& block)
{
  const auto size = byteCount(*block.field);
  std::vector<std::uint8_t> bytes(block.count * size);
  const auto* value =
      cloud.data.data() + block.first * cloud.point_step + block.field->offset;
  for (std::size_t at = 0; at < bytes.size(); at += size, value += cloud.point_step)
    std::memcpy(&bytes[at], value, size);
  std::vector<std::uint8_t> smaller(bytes.size() + bytes.size() / 16 +
                                    64); // at most 1 in 32 more
  smaller.resize(lzfCompress(bytes.data(),
                             static_cast<std::uint32_t>(bytes.size()),
                             smaller.data(),
                             static_cast<std::uint32_t>(smaller.size())));
  smaller.shrink_to_fit();
  return smaller;
}

/** Nothing if the bytes do not shrink or are too many for the format. */
std::vector<std::vector<std::uint8_t>>
compressedBlocks(const PCLPointCloud2& cloud,
                 const std::vector<PCLPointField>& fields,
                 std::size_t all_bytes,
                 int threads)
{
  if (all_bytes > std::numeric_limits<std::uint32_t>::max())
    return {};
  const auto blocks =
      blocksOf(fields, static_cast<std::size_t>(cloud.width) * cloud.height);
  std::vector<std::vector<std::uint8_t>> smaller(blocks.size());
  parallelFor(
      static_cast<std::ptrdiff_t>(blocks.size()), threads, 1, [&](std::ptrdiff_t k) {
        smaller[static_cast<std::size_t>(k)] =
            compressed(cloud, blocks[static_cast<std::size_t>(k)]);
      });
  if (sizeOf(smaller) >= all_bytes)
    smaller.clear();
  return smaller;
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
writePcd(OutputFile& file,
         const PCLPointCloud2& cloud,
         const CloudPose& pose,
         int threads)
{
  const auto fields = fieldsOf(cloud);
  std::size_t all_bytes = 0;
  for (const auto& field : fields)
    all_bytes += byteCount(field) * cloud.width * cloud.height;
  const auto smaller = compressedBlocks(cloud, fields, all_bytes, threads);
  if (smaller.empty()) {
    file.write(headerOf(cloud, fields, pose, "binary"));
    writePointByPoint(file, cloud, fields);
    return;
  }
  const std::uint32_t sizes[] = {static_cast<std::uint32_t>(sizeOf(smaller)),
                                 static_cast<std::uint32_t>(all_bytes)};
  file.write(headerOf(cloud, fields, pose, "binary_compressed"));
  file.write(sizes, sizeof(sizes));
  for (const auto& block : smaller)
    file.write(block.data(), block.size());
}

void
writePcdHeader(OutputFile& file, const PCLPointCloud2& layout, const CloudPose& pose)
{
  file.write(headerOf(layout, fieldsOf(layout), pose, "binary"));
}

void
writePcdPart(OutputFile& file, const PCLPointCloud2& part)
{
  writePointByPoint(file, part, fieldsOf(part));
}

} // namespace pcl::indoor::tool
