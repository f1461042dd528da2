/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/object_segmentation.h>

#include "objects/extent_along.h"

#include <pcl/indoor/point_resolution.h>

#include <Eigen/Geometry>

namespace pcl {
namespace indoor {

bool
isTableTop(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& up)
{
  constexpr std::size_t enough = 1000;
  constexpr float tallest = 0.7f; // metres: a chair with its back has 0.8
  constexpr float widest = 1.5f;  // metres: of tables, and less than rooms have
  if (points.size() < enough || extentAlong(up, points) > tallest)
    return false;
  const Eigen::Vector3f across = up.unitOrthogonal();
  return extentAlong(across, points) <= widest &&
         extentAlong(up.cross(across), points) <= widest &&
         raisedToResolution(points, withSizes(singleViewOptions()).voxel_size) <
             withSizes(ObjectSegmentationOptions()).voxel_size;
}

} // namespace indoor
} // namespace pcl
