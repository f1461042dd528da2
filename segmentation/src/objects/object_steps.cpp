/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/object_steps.h"

#include "objects/join/object_joining.h"

#include <memory>
#include <utility>

namespace pcl::indoor {

ObjectSegmentation
published(DetailedSegmentation segmentation)
{
  segmentation.steps = std::make_shared<const ObjectSteps>(
      std::move(static_cast<ObjectSteps&>(segmentation)));
  return std::move(segmentation);
}

const ObjectSteps&
stepsOf(const ObjectSegmentation& segmentation)
{
  static const ObjectSteps none;
  return segmentation.steps ? *segmentation.steps : none;
}

std::vector<std::uint8_t>
removedPoints(const ObjectSegmentation& segmentation)
{
  const auto& steps = stepsOf(segmentation);
  std::vector<std::uint8_t> removed;
  for (const auto voxel : steps.scene.voxels.cells.cell_of_point)
    removed.push_back(steps.removed[voxel]);
  return removed;
}

std::vector<std::uint8_t>
structurePoints(const ObjectSegmentation& segmentation)
{
  const auto& scene = stepsOf(segmentation).scene;
  std::vector<std::uint8_t> structure;
  for (const auto voxel : scene.voxels.cells.cell_of_point)
    structure.push_back(scene.plane_of_voxel[voxel] != 0);
  return structure;
}

std::vector<std::uint32_t>
supervoxelsOfPoints(const ObjectSegmentation& segmentation)
{
  const auto& steps = stepsOf(segmentation);
  std::vector<std::uint32_t> supervoxels;
  for (const auto voxel : steps.scene.voxels.cells.cell_of_point)
    supervoxels.push_back(steps.supervoxels.label_of_voxel[voxel]);
  return supervoxels;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>>
touchingSupervoxels(const ObjectSegmentation& segmentation)
{
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const auto& edge : stepsOf(segmentation).edges)
    pairs.emplace_back(edge.source, edge.target);
  return pairs;
}

std::vector<std::uint32_t>
segmentsAtLevel(const ObjectSegmentation& segmentation, float level)
{
  return segmentsAtLevel(
      stepsOf(segmentation).pieces.pieces.size(), segmentation.joins, level);
}

} // namespace pcl::indoor
