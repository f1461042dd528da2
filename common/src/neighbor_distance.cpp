/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/indoor/neighbor_distance.h>

#include <pcl/exceptions.h>
#include <pcl/indoor/distinct_points.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/quantile.h>
#include <pcl/indoor/threads.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace {

/** At most some points of each place: with many points in one place, each search would
 * visit all of them. */
struct ThinnedPoints {
  std::vector<std::uint32_t> kept; ///< in the order of the points
  std::vector<std::uint32_t>
      first_of_left;                 ///< for one that is left out, where in
                                     ///< places those of its place begin, else none
  std::vector<std::uint32_t> places; ///< all points, by place
};

constexpr std::uint32_t none = 0xffffffffu;

ThinnedPoints
thinned(const std::vector<Eigen::Vector3f>& points, std::size_t most)
{
  ThinnedPoints result;
  auto& places = result.places;
  places.resize(points.size());
  std::iota(places.begin(), places.end(), 0u);
  const auto key = [&points](std::uint32_t i) {
    return std::make_tuple(points[i].x(), points[i].y(), points[i].z(), i);
  };
  std::sort(places.begin(), places.end(), [&key](std::uint32_t a, std::uint32_t b) {
    return key(a) < key(b);
  });
  result.first_of_left.assign(points.size(), none);
  for (std::size_t first = 0, i = 0; i < places.size(); ++i) {
    if (points[places[i]] != points[places[first]])
      first = i;
    if (i - first >= most)
      result.first_of_left[places[i]] = static_cast<std::uint32_t>(first);
  }
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (result.first_of_left[i] == none)
      result.kept.push_back(i);
  return result;
}

/** Call visit(point, indices, squared distances) for each point with its closest
 * points, itself among them unless duplicates displace it; unsorted. */
template <typename Visit>
void
visitNearest(const std::vector<Eigen::Vector3f>& points,
             unsigned neighbors,
             unsigned threads,
             const Visit& visit)
{
  if (neighbors < 1)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException, "At least one neighbour is needed.");
  if (points.size() < 2)
    return;
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  const auto wanted = static_cast<int>(
      std::min<std::size_t>(points.size(), static_cast<std::size_t>(neighbors) + 1));
  const auto thin = thinned(points, static_cast<std::size_t>(wanted));
  cloud->reserve(thin.kept.size());
  for (const auto i : thin.kept)
    cloud->emplace_back(points[i].x(), points[i].y(), points[i].z());
  pcl::search::KdTree<pcl::PointXYZ> tree(true);
  tree.setInputCloud(cloud);
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  struct State {
    pcl::Indices found;
    std::vector<float> squared;
  };
  pcl::indoor::parallelFor(
      count,
      static_cast<int>(threads),
      1024,
      [] { return State(); },
      [&](State& state, std::ptrdiff_t i) {
        auto& [found, squared] = state;
        const auto first = thin.first_of_left[i];
        if (first == none) {
          tree.nearestKSearch(
              pcl::PointXYZ(points[i].x(), points[i].y(), points[i].z()),
              wanted,
              found,
              squared);
          for (auto& index : found)
            index = static_cast<pcl::index_t>(thin.kept[index]);
        }
        else {
          const auto begin = thin.places.begin() + first;
          found.assign(begin, begin + wanted);
          squared.assign(found.size(), 0.0f);
        }
        visit(static_cast<std::uint32_t>(i), found, squared);
      });
}

} // namespace

namespace pcl::indoor {

std::vector<float>
meanNeighborDistances(const std::vector<Eigen::Vector3f>& points,
                      unsigned neighbors,
                      unsigned threads)
{
  std::vector<float> distances(points.size(), 0.0f);
  visitNearest(points, neighbors, threads, [&](auto i, const auto&, auto& squared) {
    std::sort(squared.begin(), squared.end()); // a fixed order of the sum
    float sum = 0;
    for (const auto distance : squared)
      sum += std::sqrt(distance);
    distances[i] = sum / static_cast<float>(squared.size() - 1);
  });
  return distances;
}

Adjacency
nearestNeighbors(const std::vector<Eigen::Vector3f>& points,
                 unsigned neighbors,
                 unsigned threads)
{
  std::vector<std::vector<std::uint32_t>> lists(points.size());
  visitNearest(points, neighbors, threads, [&](auto i, const auto& found, const auto&) {
    for (const auto other : found)
      if (static_cast<std::uint32_t>(other) != i)
        lists[i].push_back(static_cast<std::uint32_t>(other));
  });
  Adjacency result;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t i = 0; i < lists.size(); ++i)
    for (const auto other : lists[i]) {
      pairs.emplace_back(i, other);
      pairs.emplace_back(other, i);
    }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  result.offsets.assign(points.size() + 1, 0);
  for (const auto& pair : pairs) {
    ++result.offsets[pair.first + 1];
    result.targets.push_back(pair.second);
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    result.offsets[i + 1] += result.offsets[i];
  return result;
}

double
neighborhoodRadius(const std::vector<Eigen::Vector3f>& points, unsigned threads)
{
  if (const auto places = placesOfCopies(points))
    return neighborhoodRadius(places->once(points), threads);
  if (points.size() < 2)
    return 0;
  auto distances = meanNeighborDistances(points, closest_neighbors, threads);
  return radius_factor * median(distances);
}

} // namespace pcl::indoor
