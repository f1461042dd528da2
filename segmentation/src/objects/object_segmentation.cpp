/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/object_segmentation.h>

#include "objects/distinct_segmentation.h"
#include "objects/graph/point_recovery.h"
#include "objects/graph/supervoxel_joining.h"
#include "objects/laden_tables.h"
#include "objects/non_convex_voxels.h"
#include "objects/object_pieces.h"
#include "objects/point_segmentation.h"
#include "objects/segment_names.h"
#include "objects/structure/enclosed_structure.h"
#include "objects/structure/scene_making.h"
#include "objects/voxel_votes.h"

#include <pcl/exceptions.h>
#include <pcl/features/unit_normals.h>
#include <pcl/indoor/distinct_points.h>
#include <pcl/indoor/point_resolution.h>
#include <pcl/indoor/require_valid.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace {

using pcl::indoor::Capture;
using pcl::indoor::DetailedSegmentation;
using pcl::indoor::DistinctPoints;
using pcl::indoor::JoiningScale;
using pcl::indoor::ObjectSegmentationInput;
using pcl::indoor::ObjectSegmentationOptions;
using pcl::indoor::Partition;
using pcl::indoor::Supervoxels;
using pcl::indoor::VoxelVoter;

void
requireFitting(const ObjectSegmentationInput& input,
               const ObjectSegmentationOptions& given)
{
  requireValid(given);
  if (!input.normals.empty() && input.normals.size() != input.points.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        input.points.size()
                            << " points have " << input.normals.size() << " normals.");
  if (!input.colors.empty() && input.colors.size() != input.points.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        input.points.size()
                            << " points have " << input.colors.size() << " colors.");
  if (given.on_points && given.on_points->color_weight > 0 && input.colors.empty())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The weight of colors needs points with colors.");
  if (input.capture != Capture::Scan && input.viewpoint.empty())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "A single camera needs a viewpoint.");
  if (!(std::abs(input.up.norm() - 1) < 1e-3f))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The direction up must have the length 1, not "
                            << input.up.norm() << '.');
}

bool
hasAutomaticSizes(const ObjectSegmentationOptions& given)
{
  return given.voxel_size == 0 && given.seed_size == 0;
}

/** The options to work with. */
ObjectSegmentationOptions
sizedOptions(const ObjectSegmentationInput& input,
             const ObjectSegmentationOptions& given)
{
  auto options = withSizes(given);
  options.threads = std::min(given.threads, 1024u); // each needs memory for its stack
  if (hasAutomaticSizes(given)) {
    const auto grid_points = pcl::indoor::gridPoints(input);
    const double size = options.voxel_size;
    options.voxel_size = pcl::indoor::raisedToResolution(
        grid_points.empty() ? input.points : grid_points, size);
    options.seed_size *= options.voxel_size / size;
  }
  return options;
}

/** Segments of voxels, the planes after those of the supervoxels; too small ones,
 * islands among removed voxels, are left open. */
std::vector<std::uint32_t>
segmentsOfVoxels(const std::vector<std::uint32_t>& segment_of_supervoxel,
                 std::uint32_t min_segment_size,
                 const DetailedSegmentation& result)
{
  std::vector<std::uint32_t> size(segment_of_supervoxel.size(), 0);
  for (const auto segment : segment_of_supervoxel)
    ++size[segment];
  std::vector<std::uint32_t> segments(result.scene.voxels.size(), Supervoxels::none);
  for (std::size_t v = 0; v < result.scene.voxels.size(); ++v) {
    const auto supervoxel = result.supervoxels.label_of_voxel[v];
    if (result.scene.plane_of_voxel[v] != 0)
      segments[v] =
          static_cast<std::uint32_t>(size.size()) + result.scene.plane_of_voxel[v] - 1;
    if (supervoxel == Supervoxels::none)
      continue;
    const auto segment = segment_of_supervoxel[supervoxel];
    if (size[segment] >= min_segment_size)
      segments[v] = segment;
  }
  return segments;
}

/** The segment of every voxel: that of its supervoxel, recovered, or its plane. */
std::vector<std::uint32_t>
partitionVoxels(const ObjectSegmentationOptions& options, DetailedSegmentation& result)
{
  const auto distance = distanceOf(options);
  const auto& scene = result.scene;
  result.removed = pcl::indoor::findNonConvexVoxels(scene, options);
  auto left_out = scene.structureFlags();
  for (std::size_t v = 0; v < left_out.size(); ++v)
    left_out[v] |= result.removed[v];
  result.supervoxels =
      pcl::indoor::growSupervoxels(result.scene.voxels,
                                   left_out,
                                   options.seed_size / options.voxel_size,
                                   distance,
                                   options.threads);
  result.edges = pcl::indoor::surfaceEdges(result.scene.voxels,
                                           result.supervoxels,
                                           options.edges.concavity_tolerance_degrees);
  auto segments =
      segmentsOfVoxels(joinSupervoxels(result.supervoxels, result.edges, options),
                       options.min_segment_size,
                       result);
  pcl::indoor::recoverLabels(result.scene.voxels.centroids,
                             result.scene.voxels.normals,
                             result.scene.voxels.neighbors,
                             distance,
                             segments);
  pcl::indoor::labelRemainder(
      scene.voxels.neighbors,
      static_cast<std::uint32_t>(result.supervoxels.size() + scene.planes.size()),
      segments);
  return segments;
}

void
keepDistinct(const DistinctPoints& places, ObjectSegmentationInput& input)
{
  input.points = places.once(input.points);
  input.normals = places.least(input.normals);
  input.colors = places.least(input.colors);
}

/** Give the copies of points what their places have. */
void
spreadToCopies(const DistinctPoints& places, DetailedSegmentation& result)
{
  auto& scene = result.scene;
  scene.points = places.forAll(scene.points);
  scene.voxels.cells.cell_of_point = places.forAll(scene.voxels.cells.cell_of_point);
  pcl::indoor::listPoints(scene.voxels.cells);
  result.piece_of_point = places.forAll(result.piece_of_point);
  result.votes.voxel_of_point = places.forAll(result.votes.voxel_of_point);
  result.segment_of_point = places.forAll(result.segment_of_point);
}

/** The sizes to look for objects with where voxels are voted on: votes tell what small
 * pieces are part of. Voxels are smaller where they were raised, which leaves 1.75
 * times the spacing of the points. */
void
refineSizes(ObjectSegmentationOptions& options)
{
  constexpr double share = 0.7, seed_voxels = 3;
  const auto least = pcl::indoor::withSizes(ObjectSegmentationOptions());
  options.voxel_size = std::max(least.voxel_size, share * options.voxel_size);
  options.seed_size = std::max(least.seed_size, seed_voxels * options.voxel_size);
}

DetailedSegmentation
segmentBySteps(ObjectSegmentationInput input,
               ObjectSegmentationOptions options,
               bool has_automatic_sizes,
               const pcl::indoor::ProgressCallback& progress)
{
  const auto voter =
      input.capture == Capture::Scan ? std::move(input.voter) : VoxelVoter();
  if (options.on_points) {
    auto result = segmentOnPoints(std::move(input), options, progress);
    result.options = options;
    if (!result.segment_of_point.empty())
      result.votes =
          votesFor(result.scene.points, result.scene.planes, result.scene.up, voter);
    return result;
  }
  const auto stops = [&progress](double share, const char* stage) {
    return progress && !progress(share, stage);
  };
  const bool has_pieces = options.partition == Partition::Pieces;
  std::optional<Eigen::Vector3f> camera;
  if (input.capture == Capture::TableView)
    camera = input.viewpoint.front();
  DetailedSegmentation result;
  if (stops(0, "voxels and structure"))
    return {};
  auto raw = makeRawScene(input, options);
  result.votes = votesFor(input.points, raw.planes, raw.up, voter);
  if (result.votes.class_count > 0 && has_pieces && has_automatic_sizes &&
      options.pieces.scale == JoiningScale::Objects)
    refineSizes(options);
  result.scene =
      makeObjectScene(std::move(input), std::move(raw), result.votes, options);
  if (stops(0.5, "supervoxels"))
    return {};
  const auto segment_of_voxel = partitionVoxels(options, result);
  if (stops(0.6, "objects"))
    return {};
  if (has_pieces && !camera)
    cutPieces(segment_of_voxel, result);
  else
    for (const auto voxel : result.scene.voxels.cells.cell_of_point)
      result.segment_of_point.push_back(segment_of_voxel[voxel]);
  if (has_pieces)
    joinToThings(options, camera, result);
  if (has_pieces && !camera)
    cutBodies(result);
  yieldEnclosed(result.scene, result.segment_of_point);
  nameSegments(options, result);
  if (has_pieces && options.pieces.scale == JoiningScale::Objects)
    clearLadenTables(options, result);
  result.options = options;
  if (stops(1, "done"))
    return {};
  return result; // moved: a conditional would copy all of it
}

} // namespace

namespace pcl {
namespace indoor {

DetailedSegmentation
segmentDistinct(ObjectSegmentationInput input,
                const ObjectSegmentationOptions& given_options,
                const ProgressCallback& progress)
{
  requireFitting(input, given_options);
  if (!areUnitNormals(input.normals))
    input.normals.clear(); // they are estimated
  const auto options = sizedOptions(input, given_options);
  return segmentBySteps(
      std::move(input), options, hasAutomaticSizes(given_options), progress);
}

ObjectSegmentation
segmentObjects(ObjectSegmentationInput input,
               const ObjectSegmentationOptions& options,
               const ProgressCallback& progress)
{
  requireFitting(input, options);
  const auto places = placesOfCopies(input.points);
  if (!places)
    return published(segmentDistinct(std::move(input), options, progress));
  keepDistinct(*places, input);
  auto result = segmentDistinct(std::move(input), options, progress);
  if (!result.segment_of_point.empty())
    spreadToCopies(*places, result);
  return published(std::move(result));
}

} // namespace indoor
} // namespace pcl
