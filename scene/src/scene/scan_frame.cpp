/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/scan_frame.h"

#include "files/tool_error.h"
#include "scene/cloud_stations.h"
#include "scene/recognised_end.h"
#include "text/pcl_errors.h"
#include "text/place_text.h"
#include "text/printable.h"

#include <iomanip>
#include <locale>
#include <sstream>
#include <utility>

namespace pcl::indoor::tool {

namespace {

constexpr std::pair<const char*, double> units[] = {
    {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"ft", 0.3048}, {"in", 0.0254}};

bool
isAxis(const std::string& text)
{
  return text.size() <= 2 && text.back() >= 'x' && text.back() <= 'z';
}

/** As the option -up takes it. */
std::string
textOf(const Eigen::Vector3f& direction)
{
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {1.0f, -1.0f})
      if (direction == Eigen::Vector3f(sign * Eigen::Vector3f::Unit(axis)))
        return std::string(sign < 0.0f ? "-" : "") + static_cast<char>('x' + axis);
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(9) << direction.x() << ',' << direction.y() << ','
       << direction.z();
  return text.str();
}

} // namespace

Eigen::Vector3f
upDirection(const std::string& text)
{
  const Eigen::Vector3f direction = readPlace("-up", text).cast<float>();
  if (!direction.allFinite() || !(direction.squaredNorm() > 0.0f))
    throw ToolError("-up: '" + text + "' has no direction");
  return direction;
}

std::string
unitName(double metres_per_unit)
{
  for (const auto& [name, metres] : units)
    if (metres == metres_per_unit)
      return name;
  return {};
}

} // namespace pcl::indoor::tool

namespace pcl::indoor {

double
ScanFrame::metresPerUnit() const
{
  for (const auto& [name, metres] : tool::units)
    if (unit == name)
      return metres;
  return 1.0;
}

Eigen::Vector3f
ScanFrame::upAxis() const
{
  if (up == "auto")
    return Eigen::Vector3f::UnitZ();
  if (!tool::isAxis(up))
    return tool::upDirection(up);
  const Eigen::Vector3f axis = Eigen::Vector3f::Unit(up.back() - 'x');
  return up.front() == '-' ? Eigen::Vector3f(-axis) : axis;
}

void
ScanFrame::settle(const ScanReport& report)
{
  if (up == "auto")
    up = tool::textOf(report.up_axis);
  if (unit == "auto")
    unit = tool::unitName(report.metres_per_unit);
}

} // namespace pcl::indoor

namespace pcl::indoor::tool {

SegmentedRooms
segmentRooms(const CloudFile& file,
             const ScanFrame& frame,
             const std::optional<UprightFrame>& found,
             bool looks_at_things,
             RoomSegmentation<PointXYZ>& segmentation,
             const std::function<void(const std::string& line)>& warn)
{
  if (frame.up != "auto")
    segmentation.setUpAxis(frame.upAxis());
  if (frame.unit != "auto")
    segmentation.setMetresPerUnit(frame.metresPerUnit());
  if (found)
    segmentation.setUprightFrame(*found);
  if (looks_at_things)
    segmentation.setEndFinder(recognisedEnd);
  segmentation.setStations(scanStations(file));
  segmentation.setInputCloud(file.points);
  SegmentedRooms rooms;
  const auto problem = problemOf([&] { segmentation.segment(rooms.room_of_point); });
  rooms.report = segmentation.getReport();
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

Eigen::Vector2d
originOf(const Eigen::Vector3d& offset,
         const ScanFrame& frame,
         const Eigen::Isometry3d& pose)
{
  const Eigen::Vector3d origin =
      pose.linear().transpose() * (pose.translation() + frame.metresPerUnit() * offset);
  return origin.head<2>();
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
              const ScanFrame& frame,
              const ScanReport& report)
{
  json["coordinate_unit"] = frame.unit;
  json["voxel_size"] = report.voxel_size;
  json["points_outside"] = report.outside.size();
  json["warnings"] = report.warnings;
}

} // namespace pcl::indoor::tool
