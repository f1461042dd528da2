/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/filters/point_resolution.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

namespace pcl {
namespace indoor {

double
meanResolution(const std::vector<Eigen::Vector3f>& points)
{
  if (points.size() < 2)
    return 0;
  const auto cloud = pcl::make_shared<PointCloud<PointXYZ>>();
  cloud->reserve(points.size());
  for (const auto& point : points)
    cloud->emplace_back(point.x(), point.y(), point.z());
  search::KdTree<PointXYZ> tree(true);
  tree.setInputCloud(cloud);
  Indices neighbours(2);
  std::vector<float> squared_distances(2);
  double sum = 0;
  for (const auto& point : *cloud) {
    tree.nearestKSearch(point, 2, neighbours, squared_distances);
    sum += std::sqrt(squared_distances[1]);
  }
  return sum / static_cast<double>(points.size());
}

} // namespace indoor
} // namespace pcl
