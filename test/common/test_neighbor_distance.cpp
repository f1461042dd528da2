/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/exceptions.h>
#include <pcl/indoor/neighbor_distance.h>

#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace pcl::indoor;

namespace {

std::vector<Eigen::Vector3f>
randomPoints(int count, std::mt19937& rng)
{
  const auto uniform = [&] { return static_cast<float>(rng() % 10000) / 1000; };
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(uniform(), uniform(), uniform());
  return points;
}

/** The others by distance, nearest first. */
std::vector<std::pair<float, std::uint32_t>>
others(const std::vector<Eigen::Vector3f>& points, std::size_t i)
{
  std::vector<std::pair<float, std::uint32_t>> result;
  for (std::uint32_t j = 0; j < points.size(); ++j)
    if (j != i)
      result.emplace_back((points[j] - points[i]).norm(), j);
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

TEST(NeighborDistance, IsEq21)
{
  std::mt19937 rng(1);
  for (const unsigned k : {1u, 4u, 8u}) {
    auto points = randomPoints(60, rng);
    points[3] = points[4];                                          // duplicates
    std::fill(points.begin() + 20, points.begin() + 40, points[7]); // more than k
    for (const unsigned threads : {1u, 3u}) {
      const auto distances = meanNeighborDistances(points, k, threads);
      ASSERT_EQ(distances.size(), points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto expected = others(points, i);
        float sum = 0;
        for (unsigned j = 0; j < k; ++j)
          sum += expected[j].first;
        EXPECT_NEAR(distances[i], sum / static_cast<float>(k), 1e-5f) << i;
      }
    }
  }
}

TEST(NeighborDistance, TheRadiusIsEq29)
{
  // A grid of 2 cm: in the middle four neighbours at 2 cm and four at 2.83 cm.
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j)
      cloud.emplace_back(
          0.02f * static_cast<float>(i), 0.02f * static_cast<float>(j), 0.0f);
  const double expected = 2.5 * 0.02 * (1 + std::sqrt(2.0)) / 2;
  EXPECT_NEAR(neighborhoodRadius(cloud), expected, 1e-6);
  cloud.emplace_back(1000.0f, 0.0f, 0.0f);
  cloud.emplace_back(std::nanf(""), 0.0f, 0.0f);
  EXPECT_NEAR(neighborhoodRadius(cloud), expected, 1e-6);
}

TEST(NeighborDistance, NeighborsAreMutual)
{
  std::mt19937 rng(2);
  const auto points = randomPoints(50, rng);
  const auto adjacency = nearestNeighbors(points, 3);
  ASSERT_EQ(adjacency.offsets.size(), points.size() + 1);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t j = 0; j < points.size(); ++j) {
      const auto of_i = others(points, i), of_j = others(points, j);
      const auto among = [](const auto& list, std::uint32_t wanted) {
        return std::any_of(list.begin(), list.begin() + 3, [&](const auto& entry) {
          return entry.second == wanted;
        });
      };
      if (i != j && (among(of_i, j) || among(of_j, i)))
        expected.push_back(j);
    }
    const std::vector<std::uint32_t> found(
        adjacency.targets.begin() + adjacency.offsets[i],
        adjacency.targets.begin() + adjacency.offsets[i + 1]);
    EXPECT_EQ(found, expected) << i;
  }
}

TEST(NeighborDistance, SmallAndBadInput)
{
  EXPECT_TRUE(meanNeighborDistances({}, 3).empty());
  EXPECT_EQ(meanNeighborDistances({{1, 2, 3}}, 3), std::vector<float>{0});
  EXPECT_EQ(meanNeighborDistances({{1, 2, 3}, {1, 2, 5}}, 3),
            (std::vector<float>{2, 2}));
  EXPECT_EQ(neighborhoodRadius(std::vector<Eigen::Vector3f>{{1, 2, 3}}), 0);
  EXPECT_EQ(nearestNeighbors({}, 3).offsets.size(), 1u);
  EXPECT_EQ(nearestNeighbors({{1, 2, 3}}, 3).targets.size(), 0u);
  EXPECT_THROW(meanNeighborDistances({{1, 2, 3}}, 0), pcl::BadArgumentException);
}
