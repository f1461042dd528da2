/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/objects/table_top.h>

#include <pcl/indoor/point_resolution.h>
#include <pcl/segmentation/object_segmentation.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace {

/** The length along a direction within which 98 % of the points lie. */
float
extentAlong(const Eigen::Vector3f& direction,
            const std::vector<Eigen::Vector3f>& points)
{
  std::vector<float> places;
  places.reserve(points.size());
  for (const auto& point : points)
    places.push_back(point.dot(direction));
  const auto at = [&places](std::size_t rank) {
    const auto place = places.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(places.begin(), place, places.end());
    return *place;
  };
  const std::size_t strays = places.size() / 100; // at each end
  return at(places.size() - 1 - strays) - at(strays);
}

} // namespace

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
