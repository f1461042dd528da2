/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/station_choice.h"

#include "files/field_value.h"
#include "files/tool_error.h"

#include <pcl/common/io.h> // for getFieldIndex

#include <cmath>
#include <optional>

namespace pcl::indoor::tool {
namespace {

constexpr const char* field_of_stations = "station";

/** The values of the field station, if they are whole numbers up to a number of
 * stations. */
std::optional<std::vector<std::uint32_t>>
fieldUpTo(std::size_t stations, const PCLPointCloud2& cloud)
{
  const auto& field =
      cloud.fields[static_cast<std::size_t>(getFieldIndex(cloud, field_of_stations))];
  const std::size_t count = static_cast<std::size_t>(cloud.width) * cloud.height;
  std::vector<std::uint32_t> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double value =
        valueAt(&cloud.data[i * cloud.point_step + field.offset], field.datatype);
    if (!(value >= 0.0 && value <= static_cast<double>(stations)) ||
        value != std::floor(value))
      return {};
    values[i] = static_cast<std::uint32_t>(value);
  }
  return values;
}

bool
hasStationField(const CloudFile& file)
{
  return hasField(file.cloud, field_of_stations) && !file.cloud.data.empty();
}

} // namespace

std::vector<Station>
readStations(const std::string& path)
{
  const auto file = loadCloud(path, {}, 1);
  const CloudPlaces places(file.cloud);
  std::vector<Station> stations;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector3d position = places.at(i) + file.pose.offset;
    if (!position.allFinite())
      throw ToolError(path + ": the position of station " + std::to_string(i + 1) +
                      " is not finite");
    stations.push_back({std::to_string(i + 1), position});
  }
  return stations;
}

void
choose(const StationChoice& choice, CloudFile& file)
{
  if (choice.is_ignored)
    for (auto& station : file.stations)
      station.position.reset();
  if (choice.is_ignored || choice.file.empty())
    return;
  auto stations = readStations(choice.file);
  const std::size_t told = file.stations.size();
  if (told > 1 && told != stations.size())
    throw ToolError(choice.file + ": " + std::to_string(stations.size()) +
                    " positions for the " + std::to_string(told) + " stations of " +
                    file.path);
  if (told <= 1 && hasStationField(file) && !fieldUpTo(stations.size(), file.cloud))
    file.notes.push_back("the field station does not fit the " +
                         std::to_string(stations.size()) + " positions of " +
                         choice.file + ": which point is of which is not known");
  if (told == stations.size())
    for (std::size_t k = 0; k < told; ++k)
      stations[k].name = file.stations[k].name;
  file.stations = std::move(stations);
}

std::vector<Eigen::Vector3d>
stationPositions(const CloudFile& file)
{
  std::vector<Eigen::Vector3d> positions;
  for (const auto& station : file.stations) {
    if (!station.position)
      return {};
    positions.emplace_back(*station.position - file.offset);
  }
  return positions;
}

std::vector<std::uint32_t>
stationsOfPoints(const CloudFile& file)
{
  if (stationPositions(file).empty())
    return {};
  if (file.stations.size() == 1)
    return std::vector<std::uint32_t>(file.points->size(), 1);
  if (!hasStationField(file))
    return {};
  return fieldUpTo(file.stations.size(), file.cloud)
      .value_or(std::vector<std::uint32_t>());
}

} // namespace pcl::indoor::tool
