/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/object_segmentation.h>

#include "object_unions.h"
#include "wall_frames.h"

#include <pcl/exceptions.h>
#include <pcl/features/normal_orientation.h>
#include <pcl/filters/non_convex_points.h>
#include <pcl/filters/point_resolution.h>
#include <pcl/segmentation/door_unions.h>
#include <pcl/segmentation/enclosed_structure.h>
#include <pcl/segmentation/flat_things.h>
#include <pcl/segmentation/object_gaps.h>
#include <pcl/segmentation/object_seams.h>
#include <pcl/segmentation/room_structure.h>
#include <pcl/segmentation/shadow_unions.h>
#include <pcl/segmentation/straight_bars.h>
#include <pcl/segmentation/structure_contacts.h>

#include <algorithm>
#include <cmath>

namespace {

using pcl::indoor::ObjectSegmentation;
using pcl::indoor::ObjectSegmentationInput;
using pcl::indoor::ObjectSegmentationOptions;
using pcl::indoor::Supervoxels;
using pcl::indoor::SurfaceVoxels;

/** The single-camera transform of LCCP: voxels that grow with the distance. */
std::vector<Eigen::Vector3f>
singleCameraGrid(const ObjectSegmentationInput& input)
{
  std::vector<Eigen::Vector3f> grid_points;
  grid_points.reserve(input.points.size());
  for (const auto& point : input.points) {
    const Eigen::Vector3f ray = point - input.viewpoint.front();
    const float depth = std::max(ray.z(), 1e-3f);
    grid_points.emplace_back(ray.x() / depth, ray.y() / depth, std::log(depth));
  }
  return grid_points;
}

void
findNormals(const ObjectSegmentationInput& input,
            const ObjectSegmentationOptions& options,
            unsigned thinning,
            SurfaceVoxels& voxels)
{
  pcl::indoor::estimateNormals(
      input.points, voxels, options.normal_rings, options.threads);
  if (!input.normals.empty()) {
    pcl::indoor::averageNormals(input.normals, voxels);
    return;
  }
  pcl::indoor::FreeSpaceOptions free_space;
  free_space.cell_size = 2 * options.voxel_size;
  free_space.threads = options.threads;
  free_space.sample_stride *= thinning;
  pcl::indoor::orientNormals(options.orientation,
                             voxels.centroids,
                             voxels.neighbors,
                             input.viewpoint,
                             free_space,
                             voxels.normals);
}

/** Voxels with normals; floor, walls and ceiling are apart from all else.
 * \return floor, walls and ceiling
 */
std::vector<pcl::indoor::StructurePlane>
makeVoxels(const ObjectSegmentationInput& input,
           const ObjectSegmentationOptions& options,
           ObjectSegmentation& result)
{
  auto voxels = pcl::indoor::surfaceVoxels(
      input.points,
      input.single_camera ? singleCameraGrid(input) : std::vector<Eigen::Vector3f>(),
      options.voxel_size);
  // Normals for the sides of large planes need fewer votes.
  const bool separate = options.separate_structure && !input.single_camera;
  findNormals(input, options, separate ? 4 : 1, voxels);
  result.plane_of_voxel.assign(voxels.size(), 0);
  pcl::indoor::RoomStructureOptions structure;
  structure.voxel_size = options.voxel_size;
  std::vector<pcl::indoor::StructurePlane> planes;
  if (separate)
    planes = pcl::indoor::findRoomStructure(voxels, structure);
  if (planes.empty()) {
    result.voxels = std::move(voxels);
    return planes;
  }
  const auto plane_of_point =
      pcl::indoor::pointsOfStructure(input.points, voxels, planes, structure);
  result.voxels = pcl::indoor::separateVoxels(
      input.points, plane_of_point, options.voxel_size, result.plane_of_voxel);
  findNormals(input, options, 1, result.voxels);
  const double seed_voxels = options.seed_size / options.voxel_size;
  const auto patch = static_cast<std::size_t>(seed_voxels * seed_voxels);
  pcl::indoor::returnIslands(result.voxels,
                             planes,
                             options.voxel_size,
                             patch,
                             options.min_segment_size * patch,
                             result.plane_of_voxel);
  pcl::indoor::yieldContacts(input.points,
                             voxels,
                             planes,
                             options.voxel_size,
                             result.plane_of_voxel,
                             result.voxels);
  return planes;
}

/** Eq. (4.2) for voxels: the points of the voxels around are counted. */
std::vector<std::uint8_t>
findNonConvexVoxels(const SurfaceVoxels& voxels,
                    const std::vector<std::uint8_t>& in_plane,
                    const ObjectSegmentationOptions& options)
{
  const double on_plane = options.plane_tolerance * options.voxel_size;
  std::vector<std::uint8_t> removed(voxels.size(), 0);
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    if (in_plane[v] || !(voxels.curvatures[v] > options.curvature_threshold))
      continue;
    double positive = 0, negative = 0;
    for (auto j = voxels.neighbors.offsets[v]; j < voxels.neighbors.offsets[v + 1];
         ++j) {
      const auto other = voxels.neighbors.targets[j];
      const float height =
          voxels.normals[v].dot(voxels.centroids[other] - voxels.centroids[v]);
      const auto points = voxels.cells.offsets[other + 1] - voxels.cells.offsets[other];
      if (std::abs(height) > on_plane)
        (height > 0 ? positive : negative) += points;
    }
    removed[v] = pcl::indoor::isNonConvex(positive, negative, options.ratio_threshold);
  }
  return removed;
}

pcl::indoor::SurfaceDistance
distanceFor(const ObjectSegmentationOptions& options)
{
  pcl::indoor::SurfaceDistance distance;
  distance.seed_size = options.seed_size;
  distance.spatial_weight = options.spatial_weight;
  distance.normal_weight = options.normal_weight;
  return distance;
}

pcl::indoor::ConvexityOptions
convexityFor(const ObjectSegmentationOptions& options)
{
  pcl::indoor::ConvexityOptions convexity;
  convexity.concavity_tolerance_degrees = options.concavity_tolerance_degrees;
  convexity.use_sanity_check = options.use_sanity_check;
  convexity.use_smoothness_check = options.use_smoothness_check;
  convexity.smoothness_threshold = options.smoothness_threshold;
  convexity.voxel_size = options.voxel_size;
  convexity.seed_size = options.seed_size;
  return convexity;
}

std::vector<std::uint32_t>
joinSupervoxels(const ObjectSegmentation& result,
                const ObjectSegmentationOptions& options,
                const pcl::indoor::SurfaceDistance& distance)
{
  using pcl::indoor::Partition;
  const auto count = result.supervoxels.size();
  if (options.partition == Partition::Lccp)
    return pcl::indoor::convexSegments(
        count, result.edges, options.common_neighbors, options.lccp_min_segment);
  if (options.partition == Partition::FelzenszwalbHuttenlocher)
    return pcl::indoor::segmentGraph(
        count,
        pcl::indoor::weighEdges(
            result.supervoxels, result.edges, distance, options.concavity_weight),
        {options.graph_scale, options.min_segment_size});
  return pcl::indoor::clusterByBorders(
      count,
      pcl::indoor::bendBorders(result.supervoxels, result.edges, options.bend),
      {options.bend_threshold_degrees, options.min_segment_size});
}

std::vector<std::uint8_t>
flagsOf(const std::vector<std::uint32_t>& plane_of_voxel)
{
  std::vector<std::uint8_t> flags;
  flags.reserve(plane_of_voxel.size());
  for (const auto plane : plane_of_voxel)
    flags.push_back(plane != 0);
  return flags;
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

/** Above those of supervoxels and planes. */
std::uint32_t
firstFreeLabel(const ObjectSegmentation& result)
{
  const auto& planes = result.plane_of_voxel;
  const auto last = std::max_element(planes.begin(), planes.end());
  return static_cast<std::uint32_t>(result.supervoxels.size()) +
         (last == planes.end() ? 0 : *last);
}

/** Segments of voxels, parted where points tell more than voxels. */
std::vector<std::uint32_t>
segmentsOfPoints(const ObjectSegmentationInput& input,
                 const ObjectSegmentationOptions& options,
                 const ObjectSegmentation& result,
                 const std::vector<std::uint8_t>& in_plane,
                 const std::vector<pcl::indoor::StructurePlane>& planes,
                 const std::vector<std::uint32_t>& segment_of_voxel)
{
  const auto& voxels = result.voxels;
  std::vector<std::uint32_t> segments;
  if (options.separate_things && !input.single_camera) {
    pcl::indoor::FlatThingOptions things;
    things.up = options.up;
    things.voxel_size = options.voxel_size;
    segments = pcl::indoor::partFlatThings(
        input.points, voxels, segment_of_voxel, in_plane, things);
  }
  else {
    segments.reserve(input.points.size());
    for (const auto voxel : voxels.cells.cell_of_point)
      segments.push_back(segment_of_voxel[voxel]);
  }
  if (input.single_camera ||
      (!options.separate_gaps && !options.separate_seams && !options.separate_bars))
    return segments;
  const auto left_out = pcl::indoor::flagStructureAndFrames(input.points,
                                                            voxels,
                                                            planes,
                                                            result.plane_of_voxel,
                                                            options.voxel_size,
                                                            options.up,
                                                            segments);
  if (options.separate_gaps) {
    pcl::indoor::ObjectGapOptions gaps;
    gaps.up = options.up;
    gaps.voxel_size = options.voxel_size;
    gaps.threads = options.threads;
    pcl::indoor::partAtGaps(input.points, left_out, gaps, segments);
  }
  if (options.separate_seams) {
    pcl::indoor::ObjectSeamOptions seams;
    seams.up = options.up;
    seams.voxel_size = options.voxel_size;
    seams.threads = options.threads;
    pcl::indoor::partAtSeams(input.points, voxels, left_out, seams, segments);
  }
  if (options.separate_bars) {
    pcl::indoor::StraightBarOptions bars;
    bars.up = options.up;
    bars.voxel_size = options.voxel_size;
    for (const auto& axes : pcl::indoor::axesOfWalls(planes)) {
      bars.axes = axes.cast<float>();
      pcl::indoor::partAtBars(input.points, voxels, left_out, bars, segments);
    }
  }
  return segments;
}

/** Number the segments from 0 in the order of their first points. */
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

} // namespace

namespace pcl {
namespace indoor {

ObjectSegmentation
segmentObjects(const ObjectSegmentationInput& input,
               const ObjectSegmentationOptions& given_options)
{
  const auto problem = findInvalidOption(given_options);
  if (!problem.empty())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException, problem);
  if (!input.normals.empty() && input.normals.size() != input.points.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        input.points.size()
                            << " points have " << input.normals.size() << " normals.");
  if (input.single_camera && input.viewpoint.empty())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "A single camera needs a viewpoint.");
  auto options = given_options;
  options.threads = std::min(options.threads, 1024u); // each needs memory for its stack
  if (options.adapt_to_resolution && !input.single_camera) {
    options.voxel_size = raisedToResolution(input.points, options.voxel_size);
    options.seed_size *= options.voxel_size / given_options.voxel_size;
  }
  const auto distance = distanceFor(options);
  const auto convexity = convexityFor(options);

  ObjectSegmentation result;
  result.voxel_size = options.voxel_size;
  const auto planes = makeVoxels(input, options, result);
  const auto in_plane = flagsOf(result.plane_of_voxel);
  result.removed = findNonConvexVoxels(result.voxels, in_plane, options);
  auto left_out = in_plane;
  for (std::size_t v = 0; v < left_out.size(); ++v)
    left_out[v] |= result.removed[v];
  result.supervoxels = growSupervoxels(result.voxels,
                                       left_out,
                                       options.seed_size / options.voxel_size,
                                       distance,
                                       options.threads);
  result.edges = surfaceEdges(result.voxels, result.supervoxels, convexity);
  auto segment_of_voxel = segmentsOfVoxels(
      joinSupervoxels(result, options, distance), options.min_segment_size, result);
  recoverLabels(result.voxels.centroids,
                result.voxels.normals,
                result.voxels.neighbors,
                distance,
                options.recovery,
                segment_of_voxel);
  labelRemainder(result.voxels.neighbors, firstFreeLabel(result), segment_of_voxel);
  joinSegments(result.voxels, in_plane, planes, options, segment_of_voxel);
  result.segment_of_point =
      segmentsOfPoints(input, options, result, in_plane, planes, segment_of_voxel);
  if (options.join_shadowed && !input.single_camera) {
    ShadowUnionOptions shadows;
    shadows.voxel_size = options.voxel_size;
    shadows.up = options.up;
    joinAcrossShadows(result.voxels, in_plane, shadows, result.segment_of_point);
  }
  if (options.join_doors && !input.single_camera) {
    DoorUnionOptions doors;
    doors.voxel_size = options.voxel_size;
    doors.up = options.up;
    joinDoorLeaves(input.points,
                   result.voxels,
                   planes,
                   result.plane_of_voxel,
                   doors,
                   result.segment_of_point);
  }
  yieldEnclosed(input.points,
                result.voxels,
                planes,
                options.voxel_size,
                result.plane_of_voxel,
                result.segment_of_point);
  numberSegments(result);
  return result;
}

} // namespace indoor
} // namespace pcl
