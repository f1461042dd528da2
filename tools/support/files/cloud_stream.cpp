/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_stream.h"

#include "command_line/options.h" // for ToolError
#include "files/cloud_check.h"    // for MemoryStream
#include "files/cloud_file.h"
#include "files/file_header.h"
#include "files/las_file.h"
#include "files/pcd_header.h"
#include "files/ply_file.h"
#include "files/silent_pcl.h"

#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t points_of_part = 1 << 18;

/** A row of points with the fields of a layout. */
PCLPointCloud2
emptyPart(const PCLPointCloud2& layout, std::size_t count)
{
  auto part = layout;
  part.width = static_cast<std::uint32_t>(count);
  part.height = 1;
  part.row_step = part.point_step * part.width;
  return part;
}

/** The header of a PCD with a single point: for more, PCL's reader takes memory. */
std::string
headerOfOnePoint(const FileHeader& header)
{
  std::string text;
  for (const auto& words : header.lines) {
    const bool is_count =
        words[0] == "WIDTH" || words[0] == "HEIGHT" || words[0] == "POINTS";
    text += words[0];
    for (std::size_t i = 1; i < words.size(); ++i)
      text += " " + (is_count ? "1" : words[i]);
    text += "\n";
  }
  return text;
}

} // namespace

std::unique_ptr<CloudStream>
CloudStream::open(const std::string& path)
{
  std::unique_ptr<CloudStream> cloud(new CloudStream);
  cloud->path_ = path;
  try {
    cloud->stream_.open(path, std::ios::binary);
    std::string beginning(512, '\0');
    cloud->stream_.read(beginning.data(),
                        static_cast<std::streamsize>(beginning.size()));
    cloud->stream_.clear();
    cloud->stream_.seekg(0);
    const bool is_open = isLas(beginning)                      ? cloud->openLas()
                         : beginning.compare(0, 3, "ply") == 0 ? cloud->openPly()
                                                               : cloud->openPcd();
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    if (!is_open || error || cloud->pointCount() == 0 || cloud->record_size_ == 0 ||
        size < cloud->body_begin_ ||
        (size - cloud->body_begin_) / cloud->record_size_ < cloud->pointCount())
      return nullptr;
  } catch (const ToolError&) {
    return nullptr;
  }
  for (const char* name : {"x", "y", "z"})
    if (!isRealField(cloud->layout_, name))
      return nullptr;
  return cloud;
}

bool
CloudStream::openPcd()
{
  const auto header = readFileHeader(stream_, "DATA", path_);
  const auto pcd = readPcdHeader(header, path_);
  if (pcd.data != "binary")
    return false;
  const auto text = headerOfOnePoint(header);
  MemoryStream stream(text.data(), text.size());
  int version = 0, encoding = 0;
  unsigned int body_begin = 0;
  const SilentPcl silence;
  if (PCDReader().readHeader(stream,
                             layout_,
                             frame_.origin,
                             frame_.orientation,
                             version,
                             encoding,
                             body_begin) != 0 ||
      layout_.point_step != pcd.bytesPerPoint())
    return false;
  readPose(header, frame_);
  frame_.offset = header.offset;
  layout_.data.clear();
  layout_.width = static_cast<std::uint32_t>(pcd.width);
  layout_.height = static_cast<std::uint32_t>(pcd.height);
  layout_.row_step = layout_.point_step * layout_.width;
  body_begin_ = header.body_begin;
  record_size_ = layout_.point_step;
  points_ = [this](const std::string& records, std::size_t count) {
    auto part = emptyPart(layout_, count);
    part.data.assign(records.begin(), records.end());
    return part;
  };
  return true;
}

bool
CloudStream::openPly()
{
  auto records = plyRecords(path_);
  if (!records)
    return false;
  layout_ = std::move(records->layout);
  frame_ = {records->origin, records->orientation, records->offset};
  body_begin_ = records->body_begin;
  record_size_ = records->record_size;
  points_ = std::move(records->points);
  return true;
}

bool
CloudStream::openLas()
{
  auto records = lasRecords(path_);
  layout_ = records.layout;
  body_begin_ = records.body_begin;
  record_size_ = records.record_size;
  points_ = [this, copy = records.copy](const std::string& bytes, std::size_t count) {
    auto part = emptyPart(layout_, count);
    part.data.resize(count * part.point_step);
    for (std::size_t i = 0; i < count; ++i)
      copy(&bytes[i * record_size_],
           reinterpret_cast<char*>(&part.data[i * part.point_step]));
    return part;
  };
  return true;
}

PCLPointCloud2
CloudStream::read(std::uint64_t first, std::size_t count)
{
  std::string records(count * record_size_, '\0');
  stream_.clear();
  stream_.seekg(static_cast<std::streamoff>(body_begin_ + first * record_size_));
  if (!stream_.read(records.data(), static_cast<std::streamsize>(records.size())))
    throw ToolError(path_ + ": the file can no longer be read");
  return points_(std::move(records), count);
}

void
CloudStream::forEachPart(
    const std::function<void(std::uint64_t first, PCLPointCloud2& part)>& visit)
{
  for (std::uint64_t first = 0; first < pointCount();) {
    const auto count = static_cast<std::size_t>(
        std::min<std::uint64_t>(points_of_part, pointCount() - first));
    auto part = read(first, count);
    visit(first, part);
    first += count;
  }
}

} // namespace pcl::indoor::tool
