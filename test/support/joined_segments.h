/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "support/object_scene.h"

#include <pcl/segmentation/surface_voxels.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {
namespace test {

/** The segments of the points after a join of the segments of voxels; before, those are
 * the objects of the scene. */
template <typename Options, typename Join>
std::vector<std::uint32_t>
joinedSegments(const LabelledPoints& scene,
               const Options& options,
               bool leave_out,
               const Join& join)
{
  const auto voxels = surfaceVoxels(scene.points, {}, options.voxel_size);
  std::vector<std::uint32_t> segments(voxels.size(), 0), labels;
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    segments[voxels.cells.cell_of_point[i]] = scene.objects[i];
  join(voxels, std::vector<std::uint8_t>(voxels.size(), leave_out), options, segments);
  for (const auto voxel : voxels.cells.cell_of_point)
    labels.push_back(segments[voxel]);
  return labels;
}

} // namespace test
} // namespace indoor
} // namespace pcl
