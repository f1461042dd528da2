/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/table_top.h"

#include <pcl/segmentation/object_segmentation.h>

#include "internal/extent_along.h"

#include <pcl/indoor/point_resolution.h>

#include <Eigen/Geometry>

namespace pcl::indoor {

bool
isTableTop(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& up)
{
  constexpr float tallest = 0.7f; // metres: a chair with its back has 0.8
  if (points.size() < fewest_points_of_table || extentAlong(up, points) > tallest)
    return false;
  const Eigen::Vector3f across = up.unitOrthogonal();
  return extentAlong(across, points) <= widest_table &&
         extentAlong(up.cross(across), points) <= widest_table &&
         raisedToResolution(points, withSizes(singleViewOptions()).voxel_size) <
             withSizes(ObjectSegmentationOptions()).voxel_size;
}

} // namespace pcl::indoor
