/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "datasets/s3dis.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace pcl::indoor::tool {
namespace {

namespace fs = std::filesystem;

constexpr const char* annotations = "Annotations";

/** The paths in a folder that a function wants, by name, without hidden ones. */
template <typename Wanted>
std::vector<fs::path>
pathsIn(const fs::path& folder, const Wanted& wanted)
{
  std::vector<fs::path> paths;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; entry != end;
       entry.increment(error))
    if (entry->path().filename().string().front() != '.' && wanted(*entry))
      paths.push_back(entry->path());
  if (error)
    throw ToolError(folder.string() + ": " + error.message());
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<fs::path>
foldersIn(const fs::path& folder)
{
  return pathsIn(folder, [](const auto& entry) {
    std::error_code error;
    return entry.is_directory(error);
  });
}

bool
isRoom(const fs::path& folder)
{
  std::error_code error;
  return fs::is_directory(folder / annotations, error);
}

/** "chair" of chair_12.txt. */
std::string
classOf(const fs::path& file)
{
  const auto name = file.stem().string();
  const auto stroke = name.rfind('_');
  if (stroke == name.npos || stroke == 0 || stroke + 1 == name.size() ||
      name.find_first_not_of("0123456789", stroke + 1) != name.npos)
    throw ToolError(file.string() + ": the name is not CLASS_NUMBER.txt");
  return name.substr(0, stroke);
}

/** The annotations of all rooms, room by room. */
std::vector<std::vector<fs::path>>
annotationFiles(const std::vector<fs::path>& rooms)
{
  std::vector<std::vector<fs::path>> files;
  for (const auto& room : rooms) {
    if (!isRoom(room))
      throw ToolError(room.string() + ": a room without the folder " + annotations);
    files.push_back(pathsIn(room / annotations, [](const auto& entry) {
      return entry.path().extension() == ".txt";
    }));
    if (files.back().empty())
      throw ToolError((room / annotations).string() + ": no file CLASS_NUMBER.txt");
  }
  return files;
}

std::vector<std::string>
categoryNames(const std::vector<std::vector<fs::path>>& files)
{
  std::vector<std::string> names = {"none",
                                    "ceiling",
                                    "floor",
                                    "wall",
                                    "beam",
                                    "column",
                                    "window",
                                    "door",
                                    "table",
                                    "chair",
                                    "sofa",
                                    "bookcase",
                                    "board",
                                    "clutter",
                                    "stairs"};
  std::set<std::string> others;
  for (const auto& room : files)
    for (const auto& file : room)
      if (const auto name = classOf(file);
          std::find(names.begin(), names.end(), name) == names.end())
        others.insert(name);
  names.insert(names.end(), others.begin(), others.end());
  return names;
}

/** Points of the same fields behind those that are there. */
void
append(const PCLPointCloud2& part, PCLPointCloud2& cloud)
{
  if (cloud.fields.empty())
    cloud.fields = part.fields;
  if (part.width > 0x7fffffff - cloud.width)
    throw ToolError("more than 2^31 - 1 points");
  cloud.height = 1;
  cloud.width += part.width;
  cloud.point_step = part.point_step;
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.insert(cloud.data.end(), part.data.begin(), part.data.end());
}

} // namespace

bool
isS3dis(const std::string& folder)
{
  if (isRoom(folder))
    return true;
  if (fs::path(folder).filename() == annotations)
    throw ToolError(folder + ": give the folder of the room, in which this one is");
  const auto folders = foldersIn(folder);
  if (std::any_of(folders.begin(), folders.end(), isRoom))
    return true;
  for (const auto& area : folders)
    if (const auto rooms = foldersIn(area);
        std::any_of(rooms.begin(), rooms.end(), isRoom))
      throw ToolError(folder +
                      ": several areas of S3DIS; give one of them, for example " +
                      area.string());
  return false;
}

LabelledScan
readS3dis(const std::string& folder)
{
  const bool is_area = !isRoom(folder);
  const auto rooms = is_area ? foldersIn(folder) : std::vector<fs::path>{folder};
  const auto files = annotationFiles(rooms);
  LabelledScan scan;
  scan.category_names = categoryNames(files);
  const auto& names = scan.category_names;
  auto& cloud = scan.file.cloud;
  std::uint32_t object = 0;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    if (is_area)
      scan.room_names.push_back(rooms[r].filename().string());
    for (const auto& file : files[r]) {
      const auto part = loadCloud(file.string(), {"x,y,z,r,g,b"}, 1);
      for (const auto& note : part.notes)
        scan.file.notes.push_back(file.lexically_relative(folder).string() + ": " +
                                  note);
      append(part.cloud, cloud);
      const auto category = std::find(names.begin(), names.end(), classOf(file));
      scan.objects.resize(cloud.width, ++object);
      scan.categories.resize(cloud.width,
                             static_cast<std::uint32_t>(category - names.begin()));
      if (is_area)
        scan.rooms.resize(cloud.width, static_cast<std::uint32_t>(r + 1));
    }
  }
  scan.file.path = folder;
  scan.file.offset = coordinateOrigin(cloud).middle;
  return scan;
}

} // namespace pcl::indoor::tool
