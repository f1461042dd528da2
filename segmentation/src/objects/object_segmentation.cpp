/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/object_segmentation.h>

#include "objects/distinct_segmentation.h"
#include "objects/laden_tables.h"
#include "objects/object_pieces.h"
#include "objects/segment_names.h"
#include "objects/structure/enclosed_structure.h"
#include "objects/structure/scene_making.h"
#include "objects/voxel_partition.h"
#include "objects/voxel_votes.h"

#include <pcl/indoor/require_valid.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace {

using pcl::indoor::ObjectSegmentationOptions;

/** With votes smaller voxels do: sizes that were raised to the point spacing are
 * multiplied by 0.7 (2.5 to 1.75 spacings), not below the defaults. */
void
refineSizes(ObjectSegmentationOptions& options)
{
  constexpr double share = 0.7, seed_voxels = 3;
  const auto least = pcl::indoor::withSizes(ObjectSegmentationOptions());
  options.voxel_size = std::max(least.voxel_size, share * options.voxel_size);
  options.seed_size = std::max(least.seed_size, seed_voxels * options.voxel_size);
}

} // namespace

namespace pcl::indoor {

DetailedSegmentation
segmentDistinct(ObjectSegmentationInput input,
                const ObjectSegmentationOptions& given,
                const ProgressCallback& progress)
{
  requireValid(given);
  input = withoutUnusable(std::move(input));
  auto options = sizedOptions(input, given);
  const auto stops = [&progress](double share, const char* stage) {
    return progress && !progress(share, stage);
  };
  std::optional<Eigen::Vector3f> camera;
  if (input.capture == Capture::TableView)
    camera = input.viewpoint.front();
  const bool of_objects = options.pieces.scale == JoiningScale::Objects;
  const bool has_sizes = given.voxel_size != 0 || given.seed_size != 0;
  DetailedSegmentation result;
  if (stops(0, "voxels and structure"))
    return {};
  auto raw = makeRawScene(input, options);
  result.votes = votesFor(input.points, raw.planes, raw.up, input.voter);
  if (result.votes.class_count > 0 && !has_sizes && of_objects)
    refineSizes(options);
  result.scene =
      makeObjectScene(std::move(input), std::move(raw), result.votes, options);
  if (stops(0.5, "supervoxels"))
    return {};
  const auto segment_of_voxel = partitionVoxels(
      options,
      [&options](const Supervoxels& supervoxels,
                 const std::vector<SurfaceEdge>& edges) {
        return joinByBends(supervoxels, edges, options.min_segment_size);
      },
      result);
  if (stops(0.6, "objects"))
    return {};
  if (camera)
    spreadToPoints(segment_of_voxel, result);
  else
    cutPieces(segment_of_voxel, result);
  joinToObjects(options, camera, result);
  yieldEnclosed(result.scene, result.segment_of_point);
  nameSegments(options, result);
  if (of_objects && !camera) // whose direction up is unknown
    clearLadenTables(options, result);
  result.options = options;
  if (stops(1, "done"))
    return {};
  return result; // moved: a conditional would copy all of it
}

ObjectSegmentation
segmentObjects(ObjectSegmentationInput input,
               const ObjectSegmentationOptions& options,
               const ProgressCallback& progress)
{
  return segmentEachPlace(std::move(input), [&](ObjectSegmentationInput distinct) {
    return segmentDistinct(std::move(distinct), options, progress);
  });
}

} // namespace pcl::indoor
