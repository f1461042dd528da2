/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/objects/object_report.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl {
namespace indoor {

std::string
oneSegmentWarning(const ObjectSegmentation& result)
{
  constexpr std::size_t many = 1000;  // points, ten times those that tell a segment
  constexpr double nearly_all = 0.95; // beside a few that stray
  std::vector<std::size_t> sizes(result.segment_count, 0);
  for (const auto segment : result.segment_of_point)
    if (segment != Supervoxels::none)
      ++sizes[segment];
  const auto count = result.segment_of_point.size();
  const auto largest = std::max_element(sizes.begin(), sizes.end());
  if (count < many || largest == sizes.end() ||
      static_cast<double>(*largest) < nearly_all * static_cast<double>(count))
    return {};
  std::ostringstream line;
  line << (*largest == count ? "All " : "Nearly all of ") << count
       << " points are one segment";
  const auto kind = result.structure_of_segment[largest - sizes.begin()];
  if (kind == StructureKind::Floor || kind == StructureKind::Wall ||
      kind == StructureKind::Ceiling)
    line << ", of floor, wall or ceiling: there is no thing.";
  else
    line << ": right if the scan is of one thing. If not, the things are too small for "
            "voxels of "
         << result.options.voxel_size
         << " m: set smaller ones (-voxel_resolution), or, for the view of a table by "
            "one camera, the options for it (-preset single_view).";
  return line.str();
}

std::string
straysWarning(std::size_t strays, std::size_t all)
{
  if (strays == 0)
    return {};
  return std::to_string(strays) + " of " + std::to_string(all) +
         " points lie kilometres away from the others: they are in no object";
}

std::string
cameraNote(const CameraView& view, bool is_organized)
{
  if (view.capture == Capture::Scan || (is_organized && !view.is_turned))
    return {};
  const std::string axes = view.is_turned ? "-z, with y up" : "z, with y down";
  const std::string what = view.capture == Capture::TableView ? "a table" : "a room";
  return "The points are taken as what one camera sees of " + what +
         ", looking along " + axes + '.';
}

std::string
farViewWarning(const ObjectSegmentationInput& input)
{
  constexpr float farthest = 20; // metres, beyond the range of depth cameras
  if (input.capture == Capture::Scan || input.viewpoint.empty())
    return {};
  const float distance = distanceInMiddle(input.points, input.viewpoint.front());
  if (!(distance > farthest))
    return {};
  std::ostringstream line;
  line << "What the camera looks at is " << std::round(distance)
       << " m away, farther than depth cameras see: the view is probably in "
          "millimetres; scale it to metres (-unit mm).";
  return line.str();
}

} // namespace indoor
} // namespace pcl
