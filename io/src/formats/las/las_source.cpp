/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: ASPRS, LAS Specification 1.4, R15.
#include "formats/las/las_source.h"

#include "files/tool_error.h"
#include "formats/file_header.h" // for throwTruncated
#include "formats/laz/laz_records.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace pcl::indoor::tool {
namespace {

class PlainSource : public LasSource {
public:
  PlainSource(std::string path, const LasHeader& header)
  : path_(std::move(path))
  , stream_(path_, std::ios::binary)
  , begin_(header.body_begin)
  , step_(header.step)
  {}

  void
  read(std::uint64_t first, std::size_t count, char* records) override
  {
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(begin_ + first * step_));
    if (!stream_.read(records, static_cast<std::streamsize>(count * step_)))
      throw ToolError(path_ + ": the file can no longer be read");
  }

private:
  std::string path_;
  std::ifstream stream_;
  std::size_t begin_, step_;
};

class CompressedSource : public LasSource {
public:
  explicit CompressedSource(LazRecords records)
  : records_(std::move(records))
  {}

  void
  read(std::uint64_t first, std::size_t count, char* records) override
  {
    records_.read(first, count, records);
  }

private:
  LazRecords records_;
};

/** Make the number of points fit to the file, as far as it can. */
void
chooseCount(const std::string& path, std::uint64_t file_size, OpenLas& file)
{
  auto& header = file.header;
  const auto end =
      header.body_end > 0 ? std::min(header.body_end, file_size) : file_size;
  const std::uint64_t held = (file_size - header.body_begin) / header.step;
  const std::uint64_t whole = (end - header.body_begin) / header.step;
  if (held < header.points)
    throwTruncated(path, header.points, held, "points");
  if (header.points == 0 && whole > 0) {
    header.points = whole;
    file.notes.push_back("its header promises no points; the " + std::to_string(whole) +
                         " that it holds are read");
  }
  else if (header.points < whole)
    file.notes.push_back(
        "points beyond the number that its header promises are left out: " +
        std::to_string(whole - header.points));
}

/** The same of a LAZ file, of which only whole chunks are counted. */
void
checkCount(const std::string& path, const LazRecords& records, OpenLas& file)
{
  const auto points = file.header.points;
  if (records.capacity() < points)
    throwTruncated(path, points, records.capacity(), "points");
  if (points > 0 && records.fullPoints() >= points)
    file.notes.push_back("points beyond the number that its header promises are left "
                         "out: those of whole chunks");
}

/** The header, and all else before the points. */
OpenLas
openBeginning(const std::string& path, std::ifstream& stream, std::uint64_t& size)
{
  OpenLas file;
  std::string bytes(512, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  const auto header = parseLasHeader(bytes);
  if (!header)
    throw ToolError(path + ": the header of this LAS file is damaged, or of a version "
                           "other than 1.0 to 1.4");
  file.header = *header;
  stream.clear();
  stream.seekg(0, std::ios::end);
  size = static_cast<std::uint64_t>(stream.tellg());
  if (header->body_begin > size)
    throwTruncated(path, header->body_begin, size, "bytes before its points");
  for (const double scale : header->scales)
    if (!(std::abs(scale) > 0))
      throw ToolError(path + ": the header of this LAS file has the scale 0, by which "
                             "all points are one");
  file.bytes.resize(header->body_begin);
  stream.seekg(0);
  stream.read(file.bytes.data(), static_cast<std::streamsize>(file.bytes.size()));
  return file;
}

} // namespace

OpenLas
openLas(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::uint64_t size = 0;
  auto file = openBeginning(path, stream, size);
  if (file.header.is_compressed) {
    LazRecords records(path, file.bytes, file.header, size);
    checkCount(path, records, file);
    file.source = std::make_shared<CompressedSource>(std::move(records));
  }
  else {
    chooseCount(path, size, file);
    file.source = std::make_shared<PlainSource>(path, file.header);
  }
  if (file.header.points > 0x7fffffff)
    throw ToolError(path + ": more than 2^31 - 1 points");
  return file;
}

} // namespace pcl::indoor::tool
