/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scan/scan.h"

#include "files/cloud_sample.h"
#include "files/placed_points.h"

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/segmentation/scan_warnings.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::indoor::tool {
namespace {

/** Of many small blocks: a block may be one line of a scanner. */
PCLPointCloud2
scatteredPoints(CloudStream& stream)
{
  constexpr std::uint64_t blocks = 16384, block_size = 64;
  auto cloud = stream.read(0, block_size);
  for (std::uint64_t block = 1; block < blocks; ++block) {
    const auto first = stream.pointCount() / blocks * block;
    const auto part = stream.read(
        first,
        static_cast<std::size_t>(std::min(block_size, stream.pointCount() - first)));
    cloud.data.insert(cloud.data.end(), part.data.begin(), part.data.end());
    cloud.width += part.width;
  }
  return cloud;
}

/** The sensor's pose, in the frame of the points. */
void
setSensor(const CloudFile& file, PointCloud<PointXYZ>& cloud)
{
  cloud.sensor_origin_ = file.pose.origin;
  cloud.sensor_origin_.head<3>() -= (file.offset - file.pose.offset).cast<float>();
  cloud.sensor_orientation_ = file.pose.orientation;
}

/** What a sample of the points tells of all: where they are, and if their normals are
 * any. */
void
setPlaces(const PCLPointCloud2& sample, ScanContent& scan)
{
  auto& file = scan.file;
  const auto placed = placedPoints(sample, file.cloud.height > 1);
  scan.middle = placed.origin.middle;
  file.offset = file.pose.offset + scan.middle;
  file.coordinate_step = placed.origin.step;
  file.left_out = placed.left_out;
  if (!hasNormals(sample))
    return;
  const auto note = normalsNote(sample, *placed.points);
  file.has_normals = note.empty();
  if (!note.empty())
    file.notes.push_back(note);
}

/** What the files told stands before what the points did. */
void
putNotesFirst(ScanContent& scan, std::vector<std::string> told)
{
  told.insert(told.begin(), scan.notes.begin(), scan.notes.end());
  scan.file.notes.insert(scan.file.notes.begin(), told.begin(), told.end());
}

} // namespace

double
metresPerUnitOf(CloudStream& stream)
{
  const auto cloud = pointsFromAllOver(stream);
  std::size_t finite = 0;
  const auto points = pointsAround(cloud, coordinateOrigin(cloud).middle, finite);
  std::vector<Eigen::Vector3f> positions;
  for (const auto& point : *points)
    if (isFinite(point))
      positions.push_back(point.getVector3fMap());
  return metresPerUnit(findVertical(positions).room_height);
}

void
drawSample(ScanContent& scan,
           double cell_size,
           std::size_t most_points,
           const std::function<void(std::size_t done, std::size_t all)>& report)
{
  auto& stream = *scan.stream;
  CloudFile file;
  file.path = scan.file.path;
  file.cloud = stream.layout();
  file.pose = stream.pose();
  file.stations = scan.file.stations;
  scan.file = std::move(file);
  setPlaces(pointsFromAllOver(stream), scan);
  auto& left_out = scan.file.left_out;
  std::vector<std::uint64_t> counts(left_out.size(), 0);
  auto& sample = scan.sample.emplace(cell_size, most_points);
  stream.forEachPart([&](std::uint64_t first, PCLPointCloud2& part) {
    std::size_t finite = 0;
    const auto points = pointsAround(part, scan.middle, finite, left_out);
    scan.file.finite_count += finite;
    for (std::size_t k = 0; k < counts.size(); ++k)
      counts[k] += countAt(part, left_out[k]);
    sample.add(*points, first);
    report(first + points->size(), stream.pointCount());
  });
  for (const auto& line : leftOutNotes(left_out, counts, stream.pointCount()))
    scan.file.notes.push_back(line);
  if (scan.file.finite_count < 2)
    throw ToolError(scan.file.path + ": " + std::to_string(scan.file.finite_count) +
                    " finite points are too few, 2 are needed");
  sample.shrink();
  setSensor(scan.file, *sample.points());
  scan.file.points = sample.points();
  putNotesFirst(scan, stream.notes());
}

void
drawFewPoints(ScanContent& scan)
{
  auto& stream = *scan.stream;
  const auto stations = scan.file.stations;
  scan.file = withPoints(
      scan.file.path, scatteredPoints(stream), stream.pose(), 2, stream.notes());
  const auto finite = static_cast<double>(scan.file.finite_count) /
                      static_cast<double>(scan.file.points->size());
  scan.file.finite_count = static_cast<std::size_t>(
      std::llround(finite * static_cast<double>(stream.pointCount())));
  scan.file.stations = stations;
  putNotesFirst(scan, {});
}

CloudFile
partOf(const ScanContent& scan, PCLPointCloud2 part)
{
  CloudFile file;
  file.path = scan.file.path;
  file.pose = scan.stream->pose();
  file.offset = scan.file.offset;
  file.has_normals = scan.file.has_normals;
  file.points = pointsAround(part, scan.middle, file.finite_count, scan.file.left_out);
  file.cloud = std::move(part);
  return file;
}

} // namespace pcl::indoor::tool
