/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/object_segmentation_options.h>

#include "objects/first_problem.h"

namespace pcl {
namespace indoor {

std::string
findProblem(const ObjectSegmentationOptions& options)
{
  FirstProblem problem;
  problem.require(problem.isSize(options.voxel_size),
                  "voxel resolution must not be negative",
                  options.voxel_size,
                  " m");
  problem.require(
      problem.isSize(options.seed_size) &&
          (options.seed_size == 0 || options.seed_size >= options.voxel_size),
      "seed resolution must be at least the voxel resolution",
      options.seed_size,
      " m");
  problem.require(options.curvature_threshold >= 0 &&
                      options.curvature_threshold <= 1.0f / 3,
                  "curvature threshold must be in [0, 1/3]",
                  options.curvature_threshold);
  problem.require(options.ratio_threshold >= 0 && options.ratio_threshold <= 1,
                  "ratio threshold must be in [0, 1]",
                  options.ratio_threshold);
  problem.require(problem.isWeight(options.spatial_weight),
                  "spatial importance must be in [0, 1e6]",
                  options.spatial_weight);
  problem.require(problem.isWeight(options.normal_weight),
                  "normal importance must be in [0, 1e6]",
                  options.normal_weight);
  const float level = options.pieces.joining_level.value_or(0);
  problem.require(level >= 0 && level <= 1, "joining level must be in [0, 1]", level);
  return problem.text();
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

} // namespace indoor
} // namespace pcl
