/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/object_segmentation_options.h>

#include "internal/option_check.h"

namespace pcl::indoor {

std::string
findProblem(const ObjectSegmentationOptions& options)
{
  constexpr float highest_curvature = 1.0f / 3;
  const double least_seed = options.seed_size == 0 ? 0 : options.voxel_size;
  OptionCheck check;
  check.finite("voxel resolution", options.voxel_size, " m");
  check.between(
      least_seed, OptionCheck::endless, "seed resolution", options.seed_size, " m");
  check.between(
      0, highest_curvature, "curvature threshold", options.curvature_threshold, "");
  check.share("ratio threshold", options.ratio_threshold);
  check.weight("spatial importance", options.spatial_weight);
  check.weight("normal importance", options.normal_weight);
  check.share("joining level", options.pieces.joining_level.value_or(0));
  return check.problem();
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

} // namespace pcl::indoor
