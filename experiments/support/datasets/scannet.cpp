/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "datasets/scannet.h"

#include "formats/json_file.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>

namespace pcl::indoor::tool {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* points_ending = "_vh_clean_2.ply";

/** The names of the scenes whose points are in a folder. */
std::vector<std::string>
scenesIn(const std::string& folder)
{
  const std::string ending = points_ending;
  std::vector<std::string> scenes;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; entry != end;
       entry.increment(error)) {
    const auto name = entry->path().filename().string();
    if (name.size() > ending.size() &&
        name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
      scenes.push_back(name.substr(0, name.size() - ending.size()));
  }
  return scenes;
}

/** A whole number from 0; the library would turn others into one. */
std::uint32_t
wholeNumber(const Json& json, const std::string& what)
{
  // one less than the greatest: objects are numbered from 1
  if (!json.is_number_unsigned() ||
      json.get<std::uint64_t>() >= std::numeric_limits<std::uint32_t>::max())
    throw ToolError(what + " is " + json.dump() + ", not a whole number from 0");
  return json.get<std::uint32_t>();
}

struct Group {
  std::uint32_t id = 0;
  std::string label;
  std::vector<std::uint32_t> segments;
};

std::vector<std::uint32_t>
readSegments(const std::string& path)
{
  return fromJsonFile(path, [&](const Json& json) {
    std::vector<std::uint32_t> segments;
    for (const auto& number : json.at("segIndices"))
      segments.push_back(wholeNumber(number, path + ": a number of 'segIndices'"));
    return segments;
  });
}

std::vector<Group>
readGroups(const std::string& path)
{
  return fromJsonFile(path, [&](const Json& json) {
    std::vector<Group> groups;
    std::set<std::uint32_t> ids;
    for (const auto& entry : json.at("segGroups")) {
      Group group;
      group.id = wholeNumber(entry.at("id"), path + ": an 'id'");
      if (!ids.insert(group.id).second)
        throw ToolError(path + ": two groups have the id " + std::to_string(group.id));
      group.label = entry.at("label").get<std::string>();
      for (const auto& number : entry.at("segments"))
        group.segments.push_back(wholeNumber(
            number, path + ": a segment of group " + std::to_string(group.id)));
      groups.push_back(std::move(group));
    }
    return groups;
  });
}

/** The group of each segment. */
std::unordered_map<std::uint32_t, const Group*>
groupOfSegment(const std::vector<Group>& groups,
               const std::vector<std::uint32_t>& segments,
               const std::string& path)
{
  std::unordered_map<std::uint32_t, const Group*> group_of;
  for (const auto segment : segments)
    group_of[segment] = nullptr;
  for (const auto& group : groups)
    for (const auto segment : group.segments) {
      const auto found = group_of.find(segment);
      if (found == group_of.end())
        throw ToolError(path + ": group " + std::to_string(group.id) +
                        " has the segment " + std::to_string(segment) +
                        ", which no vertex has");
      found->second = &group;
    }
  return group_of;
}

} // namespace

bool
isScanNet(const std::string& folder)
{
  return !scenesIn(folder).empty();
}

LabelledScan
readScanNet(const std::string& folder)
{
  const auto scenes = scenesIn(folder);
  if (scenes.size() != 1)
    throw ToolError(folder + ": " + std::to_string(scenes.size()) + " files *" +
                    points_ending + ", one is needed");
  const auto start = (fs::path(folder) / scenes[0]).string();
  const auto segments_path = start + "_vh_clean_2.0.010000.segs.json";
  const auto groups_path = start + ".aggregation.json";
  const auto groups = readGroups(groups_path);
  const auto segments = readSegments(segments_path);
  auto file = loadCloud(start + points_ending, {}, 1);
  const auto count = file.points->size();
  if (segments.size() != count)
    throw ToolError(segments_path + ": segments of " + std::to_string(segments.size()) +
                    " vertices, the scan has " + std::to_string(count));
  const auto group_of = groupOfSegment(groups, segments, groups_path);

  LabelledScan scan;
  std::map<std::string, std::uint32_t> number_of;
  for (const auto& group : groups)
    number_of[group.label];
  for (auto& [label, number] : number_of) {
    number = static_cast<std::uint32_t>(scan.category_names.size());
    scan.category_names.push_back(label);
  }
  scan.objects.assign(count, 0);
  scan.categories.assign(count, 0);
  for (std::size_t i = 0; i < count; ++i)
    if (const auto* group = group_of.at(segments[i])) {
      scan.objects[i] = group->id + 1;
      scan.categories[i] = number_of.at(group->label);
    }
  scan.file = std::move(file);
  return scan;
}

} // namespace pcl::indoor::tool
