/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/table/table_file.h"

#include "files/field_value.h" // for appendTo
#include "files/tool_error.h"
#include "formats/file_ending.h"
#include "formats/table/table_rows.h"
#include "formats/table/table_words.h"

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace pcl::indoor::tool {
namespace {

using Kind = TableColumn::Kind;

constexpr const char* station_field = "station";

template <typename Visit>
void
visitLines(std::string_view text, const Visit& visit)
{
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    visit(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

std::vector<std::string_view>
wordsOf(std::string_view line)
{
  std::vector<std::string_view> words;
  splitLine(line, separatorOf(line), words);
  return words;
}

bool
beginsWithThreeNumbers(std::string_view line)
{
  const auto words = wordsOf(line);
  return words.size() >= 3 && std::all_of(words.begin(), words.begin() + 3, isNumber);
}

bool
holdsThreeNumbers(std::string_view line)
{
  const auto words = wordsOf(line);
  return std::count_if(words.begin(), words.end(), isNumber) >= 3;
}

/** Without blank lines and comments, of which the last may be cut. */
std::vector<std::string_view>
firstLines(std::string_view beginning)
{
  std::vector<std::string_view> lines;
  visitLines(beginning, [&](std::string_view line) {
    const auto begin = line.find_first_not_of(" \t\r");
    if (begin != line.npos && line[begin] != '#' && line.substr(begin, 2) != "//")
      lines.push_back(line);
  });
  return lines;
}

/** Where a value goes in a point of the cloud. */
struct Target {
  Kind kind = Kind::Skipped;
  std::size_t at = 0;   ///< byte
  unsigned channel = 0; ///< of a colour: bits to the left
};

std::vector<Target>
layOut(const std::vector<TableColumn>& columns, PCLPointCloud2& cloud)
{
  std::size_t rgb = 0;
  std::vector<Target> targets(columns.size());
  bool has_rgb = false;
  for (const char* axis : {"x", "y", "z"}) // in this order, as viewers want them
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (columns[c].kind == Kind::Coordinate && columns[c].field == axis)
        targets[c] = {
            Kind::Coordinate, appendTo(cloud, axis, PCLPointField::FLOAT64), 0};
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto& [name, kind] = columns[c];
    if (kind == Kind::Real)
      targets[c] = {kind, appendTo(cloud, name, PCLPointField::FLOAT32), 0};
    else if (kind == Kind::Label)
      targets[c] = {kind, appendTo(cloud, name, PCLPointField::UINT32), 0};
    else if (kind == Kind::Color) {
      if (!has_rgb)
        rgb = appendTo(cloud, "rgb", PCLPointField::FLOAT32);
      has_rgb = true;
      targets[c] = {kind, rgb, name == "r" ? 16u : name == "g" ? 8u : 0u};
    }
  }
  return targets;
}

void
putValue(const Target& target, double value, std::uint8_t* point)
{
  const auto put = [&](auto stored) {
    std::memcpy(point + target.at, &stored, sizeof(stored));
  };
  if (target.kind == Kind::Coordinate)
    put(value);
  else if (target.kind == Kind::Label)
    put(static_cast<std::uint32_t>(value));
  else if (target.kind == Kind::Real)
    put(static_cast<float>(value)); // infinite where it is too large
  else if (target.kind == Kind::Color) {
    std::uint32_t rgb = 0;
    std::memcpy(&rgb, point + target.at, sizeof(rgb));
    put(rgb | static_cast<std::uint32_t>(value) << target.channel);
  }
}

/** Tell of each point from which part it is. */
void
addStations(const std::vector<std::uint64_t>& parts,
            PCLPointCloud2& cloud,
            std::vector<Station>& stations)
{
  std::vector<std::uint32_t> station_of_point;
  for (const auto count : parts) {
    stations.push_back({"scan " + std::to_string(stations.size() + 1), {}});
    station_of_point.insert(station_of_point.end(),
                            static_cast<std::size_t>(count),
                            static_cast<std::uint32_t>(stations.size()));
  }
  appendField(cloud, station_field, station_of_point);
}

} // namespace

const std::vector<std::string>&
tableEndings()
{
  static const std::vector<std::string> endings = {
      ".xyz", ".txt", ".csv", ".asc", ".pts", ".tsv", ".xyzn", ".xyzrgb"};
  return endings;
}

bool
isTable(const std::string& path, const std::string& beginning)
{
  const auto lines = firstLines(beginning);
  if (!lines.empty() && lines[0].find('\0') != std::string_view::npos)
    return false;
  const auto& endings = tableEndings();
  if (std::count(endings.begin(), endings.end(), fileEnding(path)) > 0)
    return true;
  // the first line may hold names or a count
  return std::any_of(lines.begin(),
                     lines.begin() + std::min<std::size_t>(2, lines.size()),
                     beginsWithThreeNumbers);
}

std::uint64_t
tablePointCount(const std::string& path, const std::string& beginning)
{
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  for (const auto& line : firstLines(beginning)) {
    const auto words = wordsOf(line);
    double count = 0;
    if (words.size() == 1 && readNumber(words[0], count) && count >= 1 && count < 1e15)
      return static_cast<std::uint64_t>(count);
    if (holdsThreeNumbers(line) && !error)
      return size / (line.size() + 1);
  }
  return 0;
}

void
loadTable(CloudFile& file, const TableColumns& columns)
{
  const auto& path = file.path;
  std::error_code error;
  std::string content(std::filesystem::file_size(path, error), '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(stream.gcount()));
  TableRows rows(path, columns);
  visitLines(content, [&rows](std::string_view line) { rows.add(line); });
  rows.finish();
  file.notes = rows.notes();
  if (rows.count() > 0x7fffffff)
    throw ToolError(path + ": more than 2^31 - 1 points");
  auto& cloud = file.cloud;
  const auto targets = layOut(rows.columns(), cloud);
  cloud.width = static_cast<std::uint32_t>(rows.count());
  cloud.height = 1;
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.data.resize(std::size_t{cloud.point_step} * cloud.width);
  const double* value = rows.values().data();
  for (std::size_t i = 0; i < rows.count(); ++i)
    for (const auto& target : targets)
      putValue(target, *value++, &cloud.data[i * cloud.point_step]);
  if (rows.parts().size() > 1 && !hasField(cloud, station_field))
    addStations(rows.parts(), cloud, file.stations);
}

} // namespace pcl::indoor::tool
