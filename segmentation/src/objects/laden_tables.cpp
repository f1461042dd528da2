/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/laden_tables.h"

#include "objects/distinct_segmentation.h"
#include "objects/graph/segment_members.h"
#include "objects/segment_names.h"
#include "objects/split/laden_top.h"
#include "objects/table_top.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace {

using pcl::indoor::DetailedSegmentation;
using pcl::indoor::fewest_points_of_table;
using pcl::indoor::ObjectScene;
using pcl::indoor::ObjectSegmentationInput;
using pcl::indoor::ObjectSegmentationOptions;
using pcl::indoor::SegmentMembers;
using pcl::indoor::StructureKind;
using pcl::indoor::TopLevel;

constexpr std::size_t fewest_objects = 4; // fewer were seen in learning from rooms
constexpr float largest_reach = 0.28f;    // metres from the middle of an object

std::size_t
countAbove(const TopLevel& top, const SegmentMembers& members, const ObjectScene& scene)
{
  return std::count_if(members.begin(), members.end(), [&](auto i) {
    return scene.points[i].dot(scene.up) >= top.upper;
  });
}

std::vector<Eigen::Vector3f>
pointsOf(const SegmentMembers& members, const std::vector<Eigen::Vector3f>& points)
{
  std::vector<Eigen::Vector3f> chosen;
  chosen.reserve(members.size());
  for (const auto i : members)
    chosen.push_back(points[i]);
  return chosen;
}

/** The segments that are objects, have many points, and bear voxels of half the size:
 * of raisedToResolution() a voxel of a surface holds four points or more, and one of
 * twice the size four times as many. */
std::vector<std::uint32_t>
denseObjects(const DetailedSegmentation& result)
{
  constexpr std::uint32_t fewest_per_voxel = 16;
  const auto sizes = pcl::indoor::sizesOfSegments(result, result.segment_count);
  std::vector<std::uint32_t> dense;
  for (std::uint32_t s = 0; s < result.segment_count; ++s)
    if (result.structure_of_segment[s] == StructureKind::None &&
        sizes.points[s] >= fewest_points_of_table &&
        sizes.points[s] / fewest_per_voxel >= sizes.voxels[s])
      dense.push_back(s);
  return dense;
}

/** Whether all points of an object lie close to its middle. */
bool
isSmall(const SegmentMembers& object, const ObjectScene& scene)
{
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  for (const auto i : object)
    middle += scene.points[i] / static_cast<float>(object.size());
  return std::all_of(object.begin(), object.end(), [&](auto i) {
    return (scene.points[i] - middle).norm() <= largest_reach;
  });
}

/** The points of each small object that rises above the top.
 * \return none if these are few, less than half of what lies above the top, or beside
 * larger ones with more than a fifth of it: those are parts of one larger object, such
 * as cushions, boards and leaves */
std::vector<SegmentMembers>
smallObjects(const TopLevel& top, const DetailedSegmentation& small)
{
  const auto& scene = small.scene;
  SegmentMembers all(scene.points.size());
  std::iota(all.begin(), all.end(), 0);
  const auto above = countAbove(top, all, scene);
  std::size_t above_in_small = 0, above_in_large = 0;
  std::vector<SegmentMembers> objects;
  const std::vector<std::uint8_t> left_out(scene.points.size(), 0);
  for (auto& object :
       pcl::indoor::membersOfSegments(left_out, small.segment_of_point)) {
    const auto segment = small.segment_of_point[object.front()];
    const auto rising = countAbove(top, object, scene);
    if (small.structure_of_segment[segment] != StructureKind::None ||
        2 * rising <= object.size())
      continue;
    if (!isSmall(object, scene)) {
      above_in_large += rising;
      continue;
    }
    above_in_small += rising;
    objects.push_back(std::move(object));
  }
  if (objects.size() < fewest_objects || 2 * above_in_small < above ||
      5 * above_in_large > above)
    objects.clear();
  return objects;
}

/** Give the objects on one table segments of their own. */
void
clearTable(const SegmentMembers& members,
           const ObjectSegmentationOptions& options,
           DetailedSegmentation& result)
{
  const auto& scene = result.scene;
  const auto points = pointsOf(members, scene.points);
  const auto top = pcl::indoor::ladenTop(points, scene.up);
  if (!top)
    return;
  SegmentMembers on_top;
  for (const auto i : members)
    if (scene.points[i].dot(scene.up) >= top->lower)
      on_top.push_back(i);
  ObjectSegmentationInput input;
  input.points = pointsOf(on_top, scene.points);
  input.up = scene.up;
  auto small_options = pcl::indoor::singleViewOptions();
  small_options.threads = options.threads;
  const auto small = segmentDistinct(std::move(input), small_options);
  for (const auto& object : smallObjects(*top, small)) {
    for (const auto i : object)
      result.segment_of_point[on_top[i]] = result.segment_count;
    ++result.segment_count;
    result.structure_of_segment.push_back(StructureKind::None);
  }
}

} // namespace

namespace pcl::indoor {

void
clearLadenTables(const ObjectSegmentationOptions& options, DetailedSegmentation& result)
{
  const auto dense = denseObjects(result);
  if (dense.empty())
    return;
  const std::vector<std::uint8_t> left_out(result.segment_of_point.size(), 0);
  const auto segments = membersOfSegments(left_out, result.segment_of_point);
  for (const auto s : dense)
    clearTable(segments[s], options, result);
}

} // namespace pcl::indoor
