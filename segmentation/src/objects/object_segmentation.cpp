/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/object_segmentation.h>

#include "objects/graph/object_voxels.h"
#include "objects/object_pieces.h"

#include "objects/graph/point_recovery.h"
#include "objects/structure/enclosed_structure.h"
#include <pcl/exceptions.h>
#include <pcl/indoor/point_resolution.h>
#include <pcl/segmentation/objects/graph_segmentation.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace {

using pcl::indoor::ObjectSegmentation;
using pcl::indoor::ObjectSegmentationInput;
using pcl::indoor::ObjectSegmentationOptions;
using pcl::indoor::Partition;
using pcl::indoor::Supervoxels;

/** The options to work with, once they and the input have been checked. */
ObjectSegmentationOptions
checkedOptions(const ObjectSegmentationInput& input,
               const ObjectSegmentationOptions& given)
{
  const auto problem = pcl::indoor::findInvalidOption(given);
  if (!problem.empty())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException, problem);
  if (!input.normals.empty() && input.normals.size() != input.points.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        input.points.size()
                            << " points have " << input.normals.size() << " normals.");
  if (input.single_camera && input.viewpoint.empty())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "A single camera needs a viewpoint.");
  auto options = given;
  options.threads = std::min(given.threads, 1024u); // each needs memory for its stack
  if (given.adapt_to_resolution && !input.single_camera) {
    options.voxel_size =
        pcl::indoor::raisedToResolution(input.points, given.voxel_size);
    options.seed_size *= options.voxel_size / given.voxel_size;
  }
  return options;
}

std::vector<std::uint32_t>
joinSupervoxels(const ObjectSegmentation& result,
                const ObjectSegmentationOptions& options,
                const pcl::indoor::SurfaceDistance& distance)
{
  const auto count = result.supervoxels.size();
  if (options.partition == Partition::Lccp)
    return pcl::indoor::convexSegments(count, result.edges);
  if (options.partition == Partition::FelzenszwalbHuttenlocher)
    return pcl::indoor::segmentGraph(
        count,
        pcl::indoor::weighEdges(
            result.supervoxels, result.edges, distance, options.concavity_weight),
        {options.graph_scale, options.min_segment_size});
  return pcl::indoor::clusterByBorders(
      count,
      pcl::indoor::bendBorders(result.supervoxels, result.edges),
      {options.bend_threshold_degrees, options.min_segment_size});
}

/** Segments of voxels, the planes after those of the supervoxels; too small ones,
 * islands among removed voxels, are left open. */
std::vector<std::uint32_t>
segmentsOfVoxels(const std::vector<std::uint32_t>& segment_of_supervoxel,
                 std::uint32_t min_segment_size,
                 const ObjectSegmentation& result)
{
  std::vector<std::uint32_t> size(segment_of_supervoxel.size(), 0);
  for (const auto segment : segment_of_supervoxel)
    ++size[segment];
  std::vector<std::uint32_t> segments(result.voxels.size(), Supervoxels::none);
  for (std::size_t v = 0; v < result.voxels.size(); ++v) {
    const auto supervoxel = result.supervoxels.label_of_voxel[v];
    if (result.plane_of_voxel[v] != 0)
      segments[v] =
          static_cast<std::uint32_t>(size.size()) + result.plane_of_voxel[v] - 1;
    if (supervoxel == Supervoxels::none)
      continue;
    const auto segment = segment_of_supervoxel[supervoxel];
    if (size[segment] >= min_segment_size)
      segments[v] = segment;
  }
  return segments;
}

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
    const auto voxel = result.voxels.cells.cell_of_point[i];
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
structureOfSegments(const std::vector<pcl::indoor::StructurePlane>& planes,
                    const Eigen::Vector3f& up,
                    const ObjectSegmentation& result)
{
  std::vector<std::map<std::uint32_t, std::size_t>> counts(planes.size());
  for (std::size_t i = 0; i < result.segment_of_point.size(); ++i)
    if (const auto plane = result.plane_of_voxel[result.voxels.cells.cell_of_point[i]])
      ++counts[plane - 1][result.segment_of_point[i]];
  std::vector<pcl::indoor::StructureKind> kinds(result.segment_count,
                                                pcl::indoor::StructureKind::None);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const auto most = std::max_element(
        counts[p].begin(), counts[p].end(), [](const auto& a, const auto& b) {
          return a.second < b.second;
        });
    if (most != counts[p].end())
      kinds[most->first] = kindOf(planes[p], up);
  }
  return kinds;
}

/** The segment of every voxel: that of its supervoxel, recovered, or its plane. */
std::vector<std::uint32_t>
partitionVoxels(const ObjectSegmentationOptions& options, ObjectSegmentation& result)
{
  const pcl::indoor::SurfaceDistance distance{
      options.seed_size, options.spatial_weight, options.normal_weight};
  const auto in_plane = inStructure(result);
  result.removed = pcl::indoor::findNonConvexVoxels(result.voxels, in_plane, options);
  auto left_out = in_plane;
  for (std::size_t v = 0; v < left_out.size(); ++v)
    left_out[v] |= result.removed[v];
  result.supervoxels =
      pcl::indoor::growSupervoxels(result.voxels,
                                   left_out,
                                   options.seed_size / options.voxel_size,
                                   distance,
                                   options.threads);
  result.edges = pcl::indoor::surfaceEdges(
      result.voxels, result.supervoxels, options.concavity_tolerance_degrees);
  auto segments = segmentsOfVoxels(
      joinSupervoxels(result, options, distance), options.min_segment_size, result);
  pcl::indoor::recoverLabels(result.voxels.centroids,
                             result.voxels.normals,
                             result.voxels.neighbors,
                             distance,
                             segments);
  const auto& planes = result.plane_of_voxel;
  const auto last = std::max_element(planes.begin(), planes.end());
  const auto plane_count = last == planes.end() ? 0 : *last;
  pcl::indoor::labelRemainder(result.voxels.neighbors,
                              static_cast<std::uint32_t>(result.supervoxels.size()) +
                                  plane_count,
                              segments);
  return segments;
}

} // namespace

namespace pcl {
namespace indoor {

ObjectSegmentation
segmentObjects(const ObjectSegmentationInput& input,
               const ObjectSegmentationOptions& given_options)
{
  const auto options = checkedOptions(input, given_options);
  ObjectSegmentation result;
  result.voxel_size = options.voxel_size;
  const auto planes = makeObjectVoxels(input, options, result);
  const auto segment_of_voxel = partitionVoxels(options, result);
  result.segment_of_point.reserve(input.points.size());
  for (const auto voxel : result.voxels.cells.cell_of_point)
    result.segment_of_point.push_back(segment_of_voxel[voxel]);
  if (options.partition == Partition::Pieces && !input.single_camera) {
    cutPieces(input.points, segment_of_voxel, options, result);
    joinPiecesOfRoom(planes, options, result);
    cutBodies(input.points, planes, options, result);
  }
  yieldEnclosed(input.points,
                result.voxels,
                planes,
                options.voxel_size,
                options.up,
                result.plane_of_voxel,
                result.segment_of_point);
  std::optional<std::size_t> remainder;
  if (options.partition == Partition::Pieces)
    remainder =
        gatherRemainder(std::pow(options.seed_size / options.voxel_size, 2), result);
  numberSegments(result);
  result.structure_of_segment = structureOfSegments(planes, options.up, result);
  if (remainder)
    result.structure_of_segment[result.segment_of_point[*remainder]] =
        StructureKind::Remainder;
  return result;
}

} // namespace indoor
} // namespace pcl
