/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/opened_scan.h"

#include "files/cloud_formats.h" // for promisedPoints
#include "files/joined_clouds.h"
#include "files/sampled_surface.h"
#include "files/scan_files.h"

#include <filesystem>
#include <utility>

namespace pcl::indoor::tool {
namespace {

std::unique_ptr<CloudStream>
oneStream(OpenedScan& scan, const TableColumns& columns)
{
  return scan.files.size() == 1
             ? std::move(scan.streams[0])
             : joinedScans(scan.files, std::move(scan.streams), columns);
}

/** Is a file so small that it is read whole? To open some formats takes as long as to
 * read them. The promise of some is an estimate. */
bool
isSmall(const std::string& file, std::uint64_t points_at_once)
{
  const auto promised = promisedPoints(file);
  return promised > 0 && (points_at_once == 0 || promised <= points_at_once / 2);
}

} // namespace

OpenedScan
openScan(const std::vector<std::string>& inputs, std::uint64_t points_at_once)
{
  auto found = scanFiles(inputs);
  OpenedScan scan;
  scan.name = nameOfScan(inputs, found.paths);
  scan.unpacked = unpackScans(found);
  scan.files = std::move(found.paths);
  scan.notes = std::move(found.notes);
  for (const auto& file : scan.files) {
    auto& stream = scan.streams.emplace_back();
    if (scan.files.size() > 1 || !isSmall(file, points_at_once))
      stream = CloudStream::open(file);
    const auto own = stream ? stream->pointCount() : promisedPoints(file);
    scan.count += own;
    scan.in_memory += stream ? 0 : own;
  }
  return scan;
}

ScanContent
readWhole(OpenedScan scan, const TableColumns& columns)
{
  ScanContent content;
  content.columns = columns.names;
  auto& file = content.file;
  if (scan.files.size() == 1)
    file = loadSurface(scan.files[0], columns);
  else {
    const auto stream = oneStream(scan, columns);
    file = withPoints(scan.name,
                      stream->read(0, static_cast<std::size_t>(stream->pointCount())),
                      stream->pose());
    file.stations = stream->stations();
    const auto& told = stream->notes();
    scan.notes.insert(scan.notes.end(), told.begin(), told.end());
  }
  file.path = scan.name; // also of what was unpacked
  file.notes.insert(file.notes.begin(), scan.notes.begin(), scan.notes.end());
  return content;
}

ScanContent
readLater(OpenedScan scan, const TableColumns& columns)
{
  ScanContent content;
  content.columns = columns.names;
  content.stream = oneStream(scan, columns);
  content.unpacked = std::move(scan.unpacked);
  content.notes = std::move(scan.notes);
  auto& file = content.file;
  file.path = scan.name;
  file.cloud = content.stream->layout();
  file.pose = content.stream->pose();
  file.offset = file.pose.offset;
  file.stations = content.stream->stations();
  file.notes = content.notes;
  file.notes.insert(
      file.notes.end(), content.stream->notes().begin(), content.stream->notes().end());
  return content;
}

std::unique_ptr<CloudStream>
joinedScans(const std::vector<std::string>& files,
            std::vector<std::unique_ptr<CloudStream>> opened,
            const TableColumns& columns)
{
  for (std::size_t i = 0; i < files.size(); ++i)
    if (!opened[i]) {
      auto file = loadSurface(files[i], columns, 0);
      opened[i] = streamInMemory(std::move(file.cloud),
                                 file.pose,
                                 std::move(file.notes),
                                 std::move(file.stations));
    }
  std::vector<std::string> names;
  for (const auto& file : files)
    names.push_back(std::filesystem::path(file).filename().string());
  return joinedStream(std::move(opened), names);
}

} // namespace pcl::indoor::tool
