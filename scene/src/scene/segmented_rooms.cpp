/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/segmented_rooms.h"

#include "files/station_choice.h"
#include "files/tool_error.h"
#include "scene/coordinate_options.h" // for unitName
#include "scene/recognised_end.h"
#include "text/pcl_errors.h"
#include "text/printable.h"

#include <algorithm>
#include <sstream>

namespace pcl::indoor::tool {

SegmentedRooms
segmentRooms(const CloudFile& file,
             const CoordinateOptions& coordinates,
             const std::optional<ScanCoordinates>& found,
             bool looks_at_objects,
             RoomSegmentation<PointXYZ>& segmentation,
             const std::function<void(const std::string& line)>& warn)
{
  if (coordinates.up != "auto")
    segmentation.setUpAxis(coordinates.upAxis());
  if (coordinates.unit != "auto")
    segmentation.setMetresPerUnit(coordinates.metresPerUnit());
  if (found)
    segmentation.setCoordinates(*found);
  if (looks_at_objects)
    segmentation.setEndFinder(recognisedEnd);
  segmentation.setStations({stationPositions(file), stationsOfPoints(file)});
  segmentation.setInputCloud(file.points);
  SegmentedRooms rooms;
  const auto problem = problemOf([&] { segmentation.segment(rooms.room_of_point); });
  rooms.report = segmentation.getReport();
  rooms.frame = segmentation.getBuildingFrame();
  rooms.frame.offset = file.offset;
  auto& lines = rooms.report.warnings;
  const auto step = stepWarning(file.coordinate_step * rooms.report.metres_per_unit,
                                segmentation.getVoxelSize());
  if (!step.empty())
    lines.push_back(step);
  for (const auto& line : lines)
    warn(file.path + ": " + line);
  lines.insert(lines.begin(), file.notes.begin(), file.notes.end());
  if (rooms.room_of_point.empty())
    throw ToolError(file.path + ": " + problem);
  return rooms;
}

std::size_t
pointsInRooms(const std::vector<std::uint32_t>& room_of_point)
{
  const auto in_none = std::count(room_of_point.begin(), room_of_point.end(), 0u);
  return room_of_point.size() - static_cast<std::size_t>(in_none);
}

std::string
summaryOf(const RoomSegmentation<PointXYZ>& segmentation)
{
  const auto& report = segmentation.getReport();
  std::ostringstream text;
  text << segmentation.getRooms().size() << " rooms";
  if (segmentation.getVoxelSize() == 0.0 &&
      report.voxel_size > smallest_automatic_voxel)
    text << ", sparse points: voxels of " << report.voxel_size << " m";
  if (!report.outside.empty())
    text << ", " << report.outside.size() << " points beyond the building left out";
  return text.str();
}

void
addReportJson(nlohmann::ordered_json& json,
              const ScanReport& report,
              std::uint64_t outside)
{
  json["coordinate_unit"] = unitName(report.metres_per_unit);
  json["voxel_size"] = report.voxel_size;
  json["points_outside"] = outside;
  json["warnings"] = report.warnings;
}

} // namespace pcl::indoor::tool
