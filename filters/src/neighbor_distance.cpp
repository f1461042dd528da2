/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/filters/neighbor_distance.h>

#include <pcl/exceptions.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace {

constexpr double radius_factor = 2.5;     // Eq. (2.9)
constexpr unsigned closest_neighbors = 8; // k of Eq. (2.1), which gives no value

} // namespace

namespace pcl {
namespace indoor {

std::vector<float>
meanNeighborDistances(const std::vector<Eigen::Vector3f>& points,
                      unsigned neighbors,
                      unsigned threads)
{
  if (neighbors < 1)
    PCL_THROW_EXCEPTION(BadArgumentException, "At least one neighbour is needed.");
  std::vector<float> distances(points.size(), 0.0f);
  if (points.size() < 2)
    return distances;
  const auto cloud = pcl::make_shared<PointCloud<PointXYZ>>();
  cloud->reserve(points.size());
  for (const auto& point : points)
    cloud->emplace_back(point.x(), point.y(), point.z());
  search::KdTree<PointXYZ> tree(true);
  tree.setInputCloud(cloud);
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  // With the point itself, which duplicates may displace: its distance is 0, too.
  const auto wanted = static_cast<int>(
      std::min<std::size_t>(points.size(), static_cast<std::size_t>(neighbors) + 1));
#ifdef _OPENMP
  const int team = threads > 0 ? static_cast<int>(threads) : omp_get_max_threads();
#else
  (void)threads;
#endif
#pragma omp parallel num_threads(team)
  {
    Indices found;
    std::vector<float> squared;
#pragma omp for schedule(dynamic, 1024)
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      tree.nearestKSearch((*cloud)[i], wanted, found, squared);
      std::sort(squared.begin(), squared.end());
      float sum = 0;
      for (const auto distance : squared)
        sum += std::sqrt(distance);
      distances[i] = sum / static_cast<float>(wanted - 1);
    }
  }
  return distances;
}

double
neighborhoodRadius(const std::vector<Eigen::Vector3f>& points, unsigned threads)
{
  if (points.size() < 2)
    return 0;
  auto distances = meanNeighborDistances(points, closest_neighbors, threads);
  const auto middle =
      distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return radius_factor * *middle;
}

} // namespace indoor
} // namespace pcl
