/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/voxel_votes.h"

#include <pcl/indoor/ground_frame.h>

#include <cstddef>

namespace {

using pcl::indoor::StructureKind;
using pcl::indoor::StructurePlane;

/** Whether half as many voxels as of floors, or more, are of ceilings. */
bool
hasCeiling(const std::vector<StructurePlane>& planes, const Eigen::Vector3f& up)
{
  std::size_t floor = 0, ceiling = 0;
  for (const auto& plane : planes) {
    const auto kind = kindOf(plane, up);
    floor += kind == StructureKind::Floor ? plane.voxels.size() : 0;
    ceiling += kind == StructureKind::Ceiling ? plane.voxels.size() : 0;
  }
  return ceiling > 0 && 2 * ceiling >= floor;
}

} // namespace

namespace pcl::indoor {

VoxelClasses
votesFor(const std::vector<Eigen::Vector3f>& points,
         const std::vector<StructurePlane>& planes,
         const Eigen::Vector3f& up,
         const VoxelVoter& voter)
{
  if (!voter.classify || (!voter.in_all_rooms && hasCeiling(planes, up)))
    return {};
  if (up == Eigen::Vector3f::UnitZ())
    return voter.classify(points);
  const Eigen::Matrix3f axes = groundFrame(up).cast<float>();
  auto upright = points;
  for (auto& point : upright)
    point = axes * point;
  auto votes = voter.classify(upright);
  for (auto& middle : votes.to_middle)
    middle = axes.transpose() * middle;
  return votes;
}

} // namespace pcl::indoor
