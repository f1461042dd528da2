/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pipeline/scan.h"

#include "command_line/printable.h"
#include "files/joined_clouds.h"

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/segmentation/scan_warnings.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

namespace pcl::indoor::tool {
namespace {

namespace fs = std::filesystem;

bool
hasCloudEnding(const fs::path& path)
{
  auto ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  for (const char* known :
       {".pcd", ".ply", ".las", ".xyz", ".txt", ".csv", ".asc", ".pts"})
    if (ending == known)
      return true;
  return false;
}

/** Points from all over the file, to see where its middle is. */
PCLPointCloud2
pointsFromAllOver(CloudStream& stream)
{
  constexpr std::uint64_t blocks = 256, block_size = 4096;
  PCLPointCloud2 cloud;
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const auto first = stream.pointCount() * block / blocks;
    const auto part = stream.read(
        first,
        static_cast<std::size_t>(std::min(block_size, stream.pointCount() - first)));
    if (block == 0)
      cloud = part;
    else {
      cloud.data.insert(cloud.data.end(), part.data.begin(), part.data.end());
      cloud.width += part.width;
    }
  }
  return cloud;
}

/** The notes of several files, those that are the same as one. */
std::vector<std::string>
notesOf(const std::vector<std::string>& files,
        const std::vector<std::unique_ptr<CloudStream>>& opened)
{
  std::vector<std::pair<std::string, std::vector<std::string>>> files_of_note;
  for (std::size_t i = 0; i < files.size(); ++i)
    for (const auto& note : opened[i]->notes()) {
      auto same = std::find_if(files_of_note.begin(),
                               files_of_note.end(),
                               [&](const auto& other) { return other.first == note; });
      if (same == files_of_note.end())
        same = files_of_note.insert(same, {note, {}});
      same->second.push_back(fs::path(files[i]).filename().string());
    }
  std::vector<std::string> notes;
  for (const auto& [note, names] : files_of_note)
    notes.push_back(
        names.front() +
        (names.size() > 1 ? " and " + std::to_string(names.size() - 1) + " more" : "") +
        ": " + note);
  return notes;
}

PointCloud<PointXYZ>::Ptr
cloudOf(const std::vector<Eigen::Vector3f>& points, const CloudFile& file)
{
  auto cloud = pcl::make_shared<PointCloud<PointXYZ>>();
  cloud->reserve(points.size());
  for (const auto& point : points)
    cloud->emplace_back(point.x(), point.y(), point.z());
  cloud->sensor_origin_ = file.frame.origin;
  cloud->sensor_origin_.head<3>() -= (file.offset - file.frame.offset).cast<float>();
  cloud->sensor_orientation_ = file.frame.orientation;
  return cloud;
}

} // namespace

std::vector<std::string>
scanFiles(const std::vector<std::string>& inputs)
{
  std::vector<std::string> files;
  for (const auto& input : inputs) {
    std::error_code error;
    if (!fs::is_directory(input, error)) {
      files.push_back(input);
      continue;
    }
    std::vector<std::string> inside;
    for (const auto& entry : fs::directory_iterator(input, error))
      if (entry.is_regular_file() && hasCloudEnding(entry.path()))
        inside.push_back(entry.path().string());
    if (error)
      throw ToolError(input + ": the folder cannot be read");
    if (inside.empty())
      throw ToolError(input + ": the folder holds no PCD, PLY or LAS file or table");
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

std::string
nameOfScan(const std::vector<std::string>& inputs,
           const std::vector<std::string>& files)
{
  if (inputs.size() == 1) { // of a folder without the slash that may end it
    const fs::path path(inputs[0]);
    return (path.has_filename() ? path : path.parent_path()).string();
  }
  return files.front() + " and " + std::to_string(files.size() - 1) + " more";
}

std::unique_ptr<CloudStream>
joinedScans(const std::vector<std::string>& files,
            std::vector<std::unique_ptr<CloudStream>> opened,
            const TableColumns& columns,
            std::vector<std::string>& notes)
{
  for (std::size_t i = 0; i < files.size(); ++i)
    if (!opened[i]) {
      auto file = loadCloud(files[i], columns, 0);
      opened[i] =
          streamInMemory(std::move(file.cloud), file.frame, std::move(file.notes));
    }
  notes = notesOf(files, opened);
  std::vector<std::string> left_out;
  auto joined = joinedStream(std::move(opened), left_out);
  std::string names;
  for (const auto& name : left_out)
    names += (names.empty() ? "" : ", ") + name;
  if (!names.empty())
    notes.push_back("fields that not all of the scans have are left out: " + names);
  return joined;
}

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

Scan
readScan(const std::string& path,
         std::unique_ptr<CloudStream> stream,
         double cell_size,
         std::size_t most_points,
         const std::function<void(std::size_t done, std::size_t all)>& report)
{
  Scan scan;
  auto& file = scan.file;
  file.path = path;
  file.cloud = stream->layout();
  file.frame = stream->frame();
  const auto origin = coordinateOrigin(pointsFromAllOver(*stream));
  file.offset = file.frame.offset + origin.middle;
  file.coordinate_step = origin.step;
  file.has_normals = hasNormals(file.cloud);
  auto& sample = scan.sample.emplace(cell_size, most_points);
  stream->forEachPart([&](std::uint64_t first, PCLPointCloud2& part) {
    std::size_t finite = 0;
    const auto points = pointsAround(part, origin.middle, finite);
    file.finite_count += finite;
    for (std::size_t i = 0; i < points->size(); ++i)
      if (isFinite((*points)[i]))
        sample.add((*points)[i].getVector3fMap(), first + i);
    report(first + points->size(), stream->pointCount());
  });
  if (file.finite_count < 2)
    throw ToolError(path + ": " + std::to_string(file.finite_count) +
                    " finite points are too few, 2 are needed");
  file.points = cloudOf(sample.points(), file);
  scan.stream = std::move(stream);
  return scan;
}

CloudFile
partOf(const Scan& scan, PCLPointCloud2 part)
{
  CloudFile file;
  file.path = scan.file.path;
  file.frame = scan.stream->frame();
  file.offset = scan.file.offset;
  file.has_normals = scan.file.has_normals;
  file.points = pointsAround(part, file.offset - file.frame.offset, file.finite_count);
  file.cloud = std::move(part);
  return file;
}

} // namespace pcl::indoor::tool
