/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/object_segmentation_options.h>

#include <cmath>
#include <sstream>

namespace pcl {
namespace indoor {

std::string
findProblem(const ObjectSegmentationOptions& options)
{
  std::ostringstream problem;
  const auto require =
      [&](bool holds, const char* what, double value, const char* unit = "") {
        if (!holds && problem.str().empty())
          problem << "The " << what << ", not " << value << unit << '.';
      };
  const auto not_negative = [](double value) {
    return value >= 0 && std::isfinite(value);
  };
  const auto is_weight = [](float value) { // the square of a distance is finite
    return value >= 0 && value <= 1e6f;
  };
  require(not_negative(options.voxel_size),
          "voxel resolution must not be negative",
          options.voxel_size,
          " m");
  require(not_negative(options.seed_size) &&
              (options.seed_size == 0 || options.seed_size >= options.voxel_size),
          "seed resolution must be at least the voxel resolution",
          options.seed_size,
          " m");
  require(options.curvature_threshold >= 0 && options.curvature_threshold <= 1.0f / 3,
          "curvature threshold must be in [0, 1/3]",
          options.curvature_threshold);
  require(options.ratio_threshold >= 0 && options.ratio_threshold <= 1,
          "ratio threshold must be in [0, 1]",
          options.ratio_threshold);
  require(is_weight(options.spatial_weight),
          "spatial importance must be in [0, 1e6]",
          options.spatial_weight);
  require(is_weight(options.normal_weight),
          "normal importance must be in [0, 1e6]",
          options.normal_weight);
  require(options.edges.concavity_weight >= 0 && options.edges.concavity_weight <= 1,
          "concavity weight must be in [0, 1]",
          options.edges.concavity_weight);
  require(options.edges.concavity_tolerance_degrees >= 0 &&
              options.edges.concavity_tolerance_degrees <= 180,
          "concavity tolerance must be in [0, 180]",
          options.edges.concavity_tolerance_degrees,
          " degrees");
  require(not_negative(options.edges.graph_scale),
          "graph scale must not be negative",
          options.edges.graph_scale);
  const float level = options.pieces.joining_level.value_or(0);
  require(level >= 0 && level <= 1, "joining level must be in [0, 1]", level);
  if (!options.on_points)
    return problem.str();
  require(not_negative(options.on_points->removal_radius),
          "radius of the removal must not be negative",
          options.on_points->removal_radius,
          " m");
  require(options.on_points->ransac_share >= 0 && options.on_points->ransac_share <= 1,
          "share of a plane must be in [0, 1]",
          options.on_points->ransac_share);
  require(is_weight(options.on_points->color_weight),
          "color importance must be in [0, 1e6]",
          options.on_points->color_weight);
  require(is_weight(options.on_points->fpfh_weight),
          "importance of FPFH must be in [0, 1e6]",
          options.on_points->fpfh_weight);
  if (options.partition == Partition::Pieces && problem.str().empty())
    problem << "On points there are no pieces to join.";
  return problem.str();
}

ObjectSegmentationOptions
withSizes(ObjectSegmentationOptions options)
{
  constexpr double seeds_per_voxel = 4, room_voxel = 0.03, view_voxel = 0.005;
  if (options.voxel_size == 0 && options.seed_size > 0)
    options.voxel_size = options.seed_size / seeds_per_voxel;
  else if (options.voxel_size == 0)
    options.voxel_size =
        options.pieces.scale == JoiningScale::View ? view_voxel : room_voxel;
  if (options.seed_size == 0)
    options.seed_size = seeds_per_voxel * options.voxel_size;
  return options;
}

ObjectSegmentationOptions
singleViewOptions()
{
  ObjectSegmentationOptions options;
  options.min_segment_size = 6;
  options.pieces.scale = JoiningScale::View;
  return options;
}

ObjectSegmentationOptions
partsOptions()
{
  ObjectSegmentationOptions options;
  options.pieces.scale = JoiningScale::Parts;
  return options;
}

ObjectSegmentationOptions
thesisOptions()
{
  ObjectSegmentationOptions options;
  options.voxel_size = 0.03;
  options.seed_size = 0.12;
  options.partition = Partition::FelzenszwalbHuttenlocher;
  options.min_segment_size = 3;
  options.on_points.emplace();
  options.on_points->removal_radius = 0.05; // Sec. 2.1.5.2, points 2 cm apart
  options.on_points->ransac_share = 0.05;
  return options;
}

ObjectSegmentationOptions
thesisKinectOptions()
{
  auto options = thesisOptions();
  options.on_points.emplace();
  options.curvature_threshold = 0.02f;
  options.edges.graph_scale = 5;
  options.seed_size = 0.16;
  options.voxel_size = 0.04;
  return options;
}

} // namespace indoor
} // namespace pcl
