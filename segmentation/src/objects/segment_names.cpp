/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/segment_names.h"

#include "objects/join/building_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

namespace {

using pcl::indoor::DetailedSegmentation;
using pcl::indoor::ObjectSegmentationOptions;

/** Put segments that are too small to be told into one.
 * \return a point of it; none if there is none */
std::optional<std::size_t>
gatherRemainder(const ObjectSegmentationOptions& options, DetailedSegmentation& result)
{
  auto& segments = result.segment_of_point;
  const auto highest = std::max_element(segments.begin(), segments.end());
  const auto remainder = highest == segments.end() ? 0 : *highest + 1;
  const double voxels_of_supervoxel =
      std::pow(options.seed_size / options.voxel_size, 2);
  const auto sizes = pcl::indoor::sizesOfSegments(result, remainder);
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (const auto s = segments[i];
        static_cast<double>(sizes.voxels[s]) < voxels_of_supervoxel ||
        sizes.points[s] < options.fewest_points) {
      segments[i] = remainder;
      first = first.value_or(i);
    }
  return first;
}

/** What the segments of pieces are that were voted to be of the building. */
void
nameVoted(DetailedSegmentation& result)
{
  const auto kinds = pcl::indoor::buildingPieces(result.pieces);
  for (std::size_t i = 0; i < result.piece_of_point.size(); ++i)
    if (const auto kind = kinds[result.piece_of_point[i]];
        kind != pcl::indoor::StructureKind::None)
      result.structure_of_segment[result.segment_of_point[i]] = kind;
}

} // namespace

namespace pcl::indoor {

SegmentSizes
sizesOfSegments(const DetailedSegmentation& result, std::size_t segment_count)
{
  const auto& cells = result.scene.voxels.cells;
  SegmentSizes sizes;
  sizes.voxels.assign(segment_count, 0);
  sizes.points.assign(segment_count, 0);
  std::vector<std::uint32_t> last_voxel(segment_count, Supervoxels::none);
  for (std::uint32_t v = 0; v < cells.size(); ++v)
    for (const auto point : cells.pointsOf(v)) {
      const auto segment = result.segment_of_point[point];
      ++sizes.points[segment];
      sizes.voxels[segment] += std::exchange(last_voxel[segment], v) != v;
    }
  return sizes;
}

void
numberSegments(DetailedSegmentation& result)
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

std::vector<StructureKind>
structureOfSegments(const DetailedSegmentation& result)
{
  const auto& planes = result.scene.planes;
  std::vector<std::map<std::uint32_t, std::size_t>> counts(planes.size());
  std::vector<std::ptrdiff_t> outside(result.segment_count, 0); // less those in planes
  for (std::size_t i = 0; i < result.segment_of_point.size(); ++i)
    outside[result.segment_of_point[i]] += result.scene.planeOfPoint(i) == 0 ? 1 : -1;
  for (std::size_t i = 0; i < result.segment_of_point.size(); ++i) {
    const auto segment = result.segment_of_point[i];
    if (const auto plane = result.scene.planeOfPoint(i);
        plane != 0 && outside[segment] <= 0)
      ++counts[plane - 1][segment];
  }
  std::vector<StructureKind> kinds(result.segment_count, StructureKind::None);
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

void
nameSegments(const ObjectSegmentationOptions& options, DetailedSegmentation& result)
{
  const auto remainder = gatherRemainder(options, result);
  numberSegments(result);
  result.structure_of_segment = structureOfSegments(result);
  if (result.pieces.has_votes)
    nameVoted(result);
  if (remainder)
    result.structure_of_segment[result.segment_of_point[*remainder]] =
        StructureKind::Remainder;
}

} // namespace pcl::indoor
