/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/segment_names.h"

#include <algorithm>
#include <map>
#include <optional>

namespace {

using pcl::indoor::ObjectSegmentation;

/** Put segments of fewer voxels than a supervoxel, too small to be told, into one.
 * \return a point of it; none if there is none */
std::optional<std::size_t>
gatherRemainder(double supervoxel, ObjectSegmentation& result)
{
  auto& segments = result.segment_of_point;
  const auto highest = std::max_element(segments.begin(), segments.end());
  const auto remainder = highest == segments.end() ? 0 : *highest + 1;
  std::vector<std::vector<std::uint32_t>> voxels(remainder); // as many as are enough
  for (std::size_t i = 0; i < segments.size(); ++i) {
    auto& own = voxels[segments[i]];
    const auto voxel = result.scene.voxels.cells.cell_of_point[i];
    if (static_cast<double>(own.size()) < supervoxel &&
        std::find(own.begin(), own.end(), voxel) == own.end())
      own.push_back(voxel);
  }
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (static_cast<double>(voxels[segments[i]].size()) < supervoxel) {
      segments[i] = remainder;
      first = first.value_or(i);
    }
  return first;
}

/** What the segments of most points of the planes are. */
std::vector<pcl::indoor::StructureKind>
structureOfSegments(const ObjectSegmentation& result)
{
  const auto& planes = result.scene.planes;
  std::vector<std::map<std::uint32_t, std::size_t>> counts(planes.size());
  for (std::size_t i = 0; i < result.segment_of_point.size(); ++i)
    if (const auto plane = result.scene.planeOfPoint(i))
      ++counts[plane - 1][result.segment_of_point[i]];
  std::vector<pcl::indoor::StructureKind> kinds(result.segment_count,
                                                pcl::indoor::StructureKind::None);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const auto most = std::max_element(
        counts[p].begin(), counts[p].end(), [](const auto& a, const auto& b) {
          return a.second < b.second;
        });
    if (most != counts[p].end())
      kinds[most->first] = kindOf(planes[p], result.scene.up);
  }
  return kinds;
}

} // namespace

namespace pcl {
namespace indoor {

void
numberSegments(ObjectSegmentation& result)
{
  const auto highest =
      std::max_element(result.segment_of_point.begin(), result.segment_of_point.end());
  std::vector<std::uint32_t> number(
      highest == result.segment_of_point.end() ? 0 : *highest + 1, Supervoxels::none);
  result.segment_count = 0;
  for (auto& segment : result.segment_of_point) {
    if (number[segment] == Supervoxels::none)
      number[segment] = result.segment_count++;
    segment = number[segment];
  }
}

void
nameSegments(double supervoxel, ObjectSegmentation& result)
{
  const auto remainder = gatherRemainder(supervoxel, result);
  numberSegments(result);
  result.structure_of_segment = structureOfSegments(result);
  if (remainder)
    result.structure_of_segment[result.segment_of_point[*remainder]] =
        StructureKind::Remainder;
}

} // namespace indoor
} // namespace pcl
