/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/scan_frame.h"

#include "command_line/options.h"
#include "command_line/pcl_errors.h"
#include "command_line/printable.h"

#include <sstream>

namespace pcl::indoor::tool {

void
ScanFrame::addOptions(OptionParser& parser)
{
  parser
      .text("-unit",
            unit,
            "unit of the coordinates; lengths of options and areas are in metres",
            {"m", "cm", "mm", "ft", "in"})
      .text("-up", up, "axis that points up", {"x", "y", "z", "-x", "-y", "-z"});
}

double
ScanFrame::metresPerUnit() const
{
  return unit == "cm"   ? 0.01
         : unit == "mm" ? 0.001
         : unit == "ft" ? 0.3048
         : unit == "in" ? 0.0254
                        : 1.0;
}

Eigen::Vector3f
ScanFrame::upAxis() const
{
  const Eigen::Vector3f axis = Eigen::Vector3f::Unit(up.back() - 'x');
  return up.front() == '-' ? Eigen::Vector3f(-axis) : axis;
}

std::vector<std::uint32_t>
segmentRooms(const CloudFile& file,
             const ScanFrame& frame,
             RoomSegmentation<PointXYZ>& segmentation)
{
  segmentation.setUpAxis(frame.upAxis());
  segmentation.setMetresPerUnit(frame.metresPerUnit());
  segmentation.setInputCloud(file.points);
  std::vector<std::uint32_t> rooms;
  const auto problem = problemOf([&] { segmentation.segment(rooms); });
  auto lines = segmentation.getReport().warnings;
  const auto step = stepWarning(file.coordinate_step * frame.metresPerUnit(),
                                segmentation.getVoxelSize());
  if (!step.empty())
    lines.push_back(step);
  for (const auto& line : lines)
    printWarning(file.path + ": " + line);
  if (rooms.empty())
    throw ToolError(file.path + ": " + problem);
  return rooms;
}

Eigen::Vector2d
originOf(const CloudFile& file, const ScanFrame& frame, const Eigen::Isometry3d& pose)
{
  const Eigen::Vector3d origin =
      pose.linear().transpose() *
      (pose.translation() + frame.metresPerUnit() * file.offset);
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
