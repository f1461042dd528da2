/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/thesis.h>

#include "internal/option_check.h"
#include "objects/distinct_segmentation.h"
#include "objects/graph/supervoxel_joining.h"
#include "objects/segment_names.h"
#include "objects/structure/enclosed_structure.h"
#include "objects/structure/scene_making.h"
#include "objects/voxel_partition.h"
#include "objects/voxel_votes.h"
#include "thesis/objects/edge_partition.h"
#include "thesis/objects/point_segmentation.h"

#include <pcl/exceptions.h>
#include <pcl/indoor/require_valid.h>

#include <utility>

namespace pcl::indoor {
namespace thesis {
namespace {

JoinSupervoxels
joinBy(const ObjectOptions& options)
{
  return [&options](const Supervoxels& supervoxels,
                    const std::vector<SurfaceEdge>& edges) {
    return joinOverEdges(supervoxels, edges, options);
  };
}

/** With voxels, structure and removal of the way that has pieces. */
DetailedSegmentation
segmentOnVoxels(ObjectSegmentationInput input,
                const ObjectOptions& options,
                const ProgressCallback& progress)
{
  const auto stops = [&progress](double share, const char* stage) {
    return progress && !progress(share, stage);
  };
  DetailedSegmentation result;
  if (stops(0, "voxels and structure"))
    return {};
  auto raw = makeRawScene(input, options.shared);
  result.votes = votesFor(input.points, raw.planes, raw.up, input.voter);
  result.scene =
      makeObjectScene(std::move(input), std::move(raw), result.votes, options.shared);
  if (stops(0.5, "supervoxels"))
    return {};
  spreadToPoints(partitionVoxels(options.shared, joinBy(options), result), result);
  yieldEnclosed(result.scene, result.segment_of_point);
  numberSegments(result);
  result.structure_of_segment = structureOfSegments(result);
  if (stops(1, "done"))
    return {};
  return result;
}

DetailedSegmentation
segmentDistinct(ObjectSegmentationInput input,
                const ObjectOptions& given,
                const ProgressCallback& progress = {})
{
  requireValid(given);
  if (given.on_points && given.on_points->color_weight > 0 && input.colors.empty())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "The weight of colors needs points with colors.");
  input = withoutUnusable(std::move(input));
  auto options = given;
  options.shared = sizedOptions(input, given.shared);
  const auto segment = options.on_points ? segmentOnPoints : segmentOnVoxels;
  auto result = segment(std::move(input), options, progress);
  result.options = options.shared;
  return result;
}

} // namespace

ObjectSegmentation
segmentObjects(ObjectSegmentationInput input,
               const ObjectOptions& options,
               const ProgressCallback& progress)
{
  return segmentEachPlace(std::move(input), [&](ObjectSegmentationInput distinct) {
    return segmentDistinct(std::move(distinct), options, progress);
  });
}

std::map<std::uint32_t, std::uint32_t>
segmentSupervoxels(const NamedSupervoxels& given, const ObjectOptions& given_options)
{
  auto options = given_options;
  options.shared = withSizes(options.shared);
  return joinNamed(given, joinBy(options));
}

RoomObjects
segmentRoomObjects(RoomPoints room,
                   const ObjectOptions& options,
                   const VoxelVoter& voter)
{
  const auto segment = [&options](ObjectSegmentationInput input) {
    return segmentDistinct(std::move(input), options);
  };
  return roomObjectsBy(segment, std::move(room), options.shared.fewest_points, voter);
}

std::string
findProblem(const ObjectOptions& options)
{
  if (const auto problem = indoor::findProblem(options.shared); !problem.empty())
    return problem;
  const auto& [shared, edges, on_points] = options;
  OptionCheck check;
  check.share("concavity weight", edges.concavity_weight);
  check.between(
      0, 180, "concavity tolerance", edges.concavity_tolerance_degrees, " degrees");
  check.finite("graph scale", edges.graph_scale, "");
  if (!on_points)
    return check.problem();
  check.finite("radius of the removal", on_points->removal_radius, " m");
  check.share("share of a plane", on_points->ransac_share);
  check.weight("color importance", on_points->color_weight);
  check.weight("importance of FPFH", on_points->fpfh_weight);
  return check.problem();
}

} // namespace thesis

thesis::ObjectOptions
thesisOptions()
{
  thesis::ObjectOptions options;
  options.shared.voxel_size = 0.03;
  options.shared.seed_size = 0.12;
  options.shared.min_segment_size = 3;
  options.on_points.emplace();
  options.on_points->removal_radius = 0.05; // Sec. 2.1.5.2, points 2 cm apart
  options.on_points->ransac_share = 0.05;
  return options;
}

thesis::ObjectOptions
thesisKinectOptions()
{
  auto options = thesisOptions();
  options.on_points.emplace();
  options.shared.curvature_threshold = 0.02f;
  options.edges.graph_scale = 5;
  options.shared.seed_size = 0.16;
  options.shared.voxel_size = 0.04;
  return options;
}

} // namespace pcl::indoor
