/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/object_segmentation.h>

#include "internal/extent_along.h"
#include "objects/object_steps.h"
#include "objects/structure/camera_view.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace pcl::indoor {

namespace {

/** The segment with most points that is neither structure nor the remainder; the number
 * of segments if there is none. */
std::uint32_t
largestObject(const ObjectSegmentation& result)
{
  std::vector<std::size_t> sizes(result.segment_count, 0);
  for (const auto segment : result.segment_of_point)
    if (segment != ObjectSegmentation::none &&
        result.structure_of_segment[segment] == StructureKind::None)
      ++sizes[segment];
  const auto largest = std::max_element(sizes.begin(), sizes.end());
  const bool is_none = largest == sizes.end() || *largest == 0;
  return is_none ? result.segment_count
                 : static_cast<std::uint32_t>(largest - sizes.begin());
}

/** Whether the direction up of the segmented scene is known, and it may be a room. */
bool
knowsUp(const ObjectSegmentation& result)
{
  return result.options.pieces.scale != JoiningScale::View &&
         stepsOf(result).scene.capture != Capture::TableView;
}

} // namespace

std::string
oneSegmentWarning(const ObjectSegmentation& result)
{
  constexpr std::size_t many = 1000;  // points, ten times those that tell a segment
  constexpr double nearly_all = 0.95; // beside a few that stray
  std::vector<std::size_t> sizes(result.segment_count, 0);
  for (const auto segment : result.segment_of_point)
    if (segment != ObjectSegmentation::none)
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
    line << ", of floor, wall or ceiling: there is no object.";
  else
    line << ": right if the scan is of one object. If not, the objects are too small "
            "for "
            "voxels of "
         << result.options.voxel_size
         << " m: set the options for small objects (-preset single_view), or smaller "
            "voxels (-voxel_resolution).";
  return line.str();
}

std::string
tableTopWarning(const ObjectSegmentation& result)
{
  constexpr std::size_t many = 10; // pieces; objects of that size in rooms have fewer
  if (!knowsUp(result))
    return {};
  const auto largest = largestObject(result);
  std::vector<std::int64_t> balance; // of each piece: points within, less others
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < result.piece_of_point.size(); ++i) {
    const auto piece = result.piece_of_point[i];
    const bool is_within = result.segment_of_point[i] == largest;
    if (piece >= balance.size())
      balance.resize(piece + 1, 0);
    balance[piece] += is_within ? 1 : -1;
    if (is_within)
      points.push_back(stepsOf(result).scene.points[i]);
  }
  const auto pieces = static_cast<std::size_t>(std::count_if(
      balance.begin(), balance.end(), [](auto value) { return value > 0; }));
  if (pieces < many || !isTableTop(points, stepsOf(result).scene.up))
    return {};
  return "The largest segment is no larger than what stands on a table, but of " +
         std::to_string(pieces) +
         " pieces: if it is several objects, cut them out of the scan, or set the "
         "options for small objects (-preset single_view).";
}

std::string
wideObjectWarning(const ObjectSegmentation& result)
{
  constexpr float widest = 4; // metres, both ways; a corner sofa has 3
  if (!knowsUp(result))
    return {};
  const auto largest = largestObject(result);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < result.segment_of_point.size(); ++i)
    if (result.segment_of_point[i] == largest)
      points.push_back(stepsOf(result).scene.points[i]);
  if (points.empty())
    return {};
  const Eigen::Vector3f& up = stepsOf(result).scene.up;
  const Eigen::Vector3f across = up.unitOrthogonal();
  const float width = extentAlong(across, points),
              depth = extentAlong(up.cross(across), points);
  if (std::min(width, depth) <= widest)
    return {};
  std::ostringstream line;
  line << "The largest object, with " << points.size() << " points, is "
       << std::round(10 * width) / 10 << " x " << std::round(10 * depth) / 10
       << " m wide, as no furniture is: walls or floors were not told from objects. If "
          "the scan is of several rooms, pcl_indoor_pipeline finds them first.";
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
cameraNote(const CameraView& view)
{
  if (view.capture == Capture::Scan)
    return {};
  const std::string axes = view.is_turned ? "-z, with y up" : "z, with y down";
  const std::string what = view.capture == Capture::TableView ? "a table" : "a room";
  return "The points are taken as what one camera sees of " + what +
         ", looking along " + axes + "; if y points the other way, turn its sign.";
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

} // namespace pcl::indoor
