/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/labelled_cloud.h"
#include "support/labelled_points.h"

#include <pcl/exceptions.h>
#include <pcl/filters/scan_outlier_removal.h>
#include <pcl/indoor/neighbor_distance.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

using namespace pcl::indoor;
using pcl::indoor::test::cloudOf;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using OutlierRemoval = pcl::ScanOutlierRemoval<pcl::PointXYZ>;

/** A wall, and points in the air before it; wall points are the first ones. */
std::vector<Eigen::Vector3f>
wallWithOutliers(std::size_t& wall_size)
{
  std::mt19937 rng(3);
  test::LabelledPoints wall;
  wall.addRectangle({0, 0, 0}, {2, 0, 0}, {0, 0, 2}, {0, 1, 0}, 1, 0.03f, 0.004f, rng);
  wall_size = wall.points.size();
  for (int i = 0; i < 60; ++i)
    wall.points.emplace_back(static_cast<float>(rng() % 2000) / 1000,
                             0.5f + static_cast<float>(rng() % 5000) / 1000,
                             static_cast<float>(rng() % 2000) / 1000);
  wall.points.emplace_back(0.0f, 700.0f, 0.0f); // a reflection
  wall.points.emplace_back(0.01f, 700.0f, 0.0f);
  return wall.points;
}

/** Both tests by brute force. */
std::vector<std::uint8_t>
outliersBruteForce(const std::vector<Eigen::Vector3f>& points,
                   const ScanOutlierOptions& options)
{
  std::vector<std::uint8_t> outliers(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    int near = 0;
    for (std::size_t j = 0; j < points.size(); ++j)
      near += j != i && (points[j] - points[i]).norm() <= options.radius;
    outliers[i] = near < options.min_neighbors;
  }
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!outliers[i])
      left.push_back(i);
  std::vector<double> means;
  for (const auto i : left) {
    std::vector<double> distances;
    for (const auto j : left)
      if (j != i)
        distances.push_back((points[j] - points[i]).norm());
    std::sort(distances.begin(), distances.end());
    means.push_back(
        std::accumulate(distances.begin(), distances.begin() + options.mean_k, 0.0) /
        options.mean_k);
  }
  const auto count = static_cast<double>(means.size());
  const double mean = std::accumulate(means.begin(), means.end(), 0.0) / count;
  double squares = 0;
  for (const auto value : means)
    squares += (value - mean) * (value - mean);
  const double limit =
      std::max(mean + options.deviations * std::sqrt(squares / (count - 1)),
               options.least_ratio * mean);
  for (std::size_t i = 0; i < left.size(); ++i)
    outliers[left[i]] = means[i] > limit;
  return outliers;
}

} // namespace

TEST(ScanOutliers, AreThoseOfBruteForce)
{
  std::mt19937 rng(4);
  std::size_t found = 0;
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<Eigen::Vector3f> points;
    for (int i = 0; i < 150; ++i) {
      const auto uniform = [&] { return static_cast<float>(rng() % 10000) / 10000; };
      const float spread = i < 120 ? 1 : 6;
      points.emplace_back(spread * uniform(), spread * uniform(), 0.1f * uniform());
    }
    ScanOutlierOptions options;
    options.radius = 0.3;
    options.min_neighbors = 3;
    options.mean_k = 5;
    options.deviations = 2;
    options.least_ratio = 1 + 0.1 * trial; // either limit decides
    const auto expected = outliersBruteForce(points, options);
    EXPECT_EQ(scanOutliers(points, options), expected) << trial;
    found += std::accumulate(expected.begin(), expected.end(), 0u);
  }
  EXPECT_GT(found, 100u);
}

TEST(ScanOutlierRemoval, TheDefaultsKeepTheWall)
{
  std::size_t wall_size = 0;
  const auto points = wallWithOutliers(wall_size);
  OutlierRemoval removal(true);
  removal.setInputCloud(cloudOf(points));
  pcl::Indices kept;
  removal.filter(kept);
  std::size_t of_wall = 0;
  for (const auto index : kept)
    of_wall += static_cast<std::size_t>(index) < wall_size;
  EXPECT_GT(of_wall, 0.99 * static_cast<double>(wall_size));
  EXPECT_EQ(kept.size(), of_wall) << "no outlier is left";
  EXPECT_EQ(kept.size() + removal.getRemovedIndices()->size(), points.size());
  pcl::Indices outliers;
  removal.setNegative(true);
  removal.filter(outliers);
  EXPECT_EQ(outliers.size(), points.size() - kept.size());
  Cloud filtered;
  removal.setNegative(false);
  removal.filter(filtered);
  EXPECT_EQ(filtered.size(), kept.size());
}

TEST(ScanOutlierRemoval, EitherTestCanBeLeftOut)
{
  std::size_t wall_size = 0;
  const auto cloud = cloudOf(wallWithOutliers(wall_size));
  const auto kept = [&](int min_neighbors, double deviations) {
    OutlierRemoval removal;
    removal.setInputCloud(cloud);
    removal.setMinNeighborsInRadius(min_neighbors);
    removal.setStddevMulThresh(deviations);
    pcl::Indices indices;
    removal.filter(indices);
    return indices.size();
  };
  const double none = std::numeric_limits<double>::infinity();
  EXPECT_EQ(kept(0, none), cloud->size());
  EXPECT_LT(kept(2, none), cloud->size());
  // The reflection is so far that the standard deviation covers all else.
  EXPECT_EQ(kept(0, 3), cloud->size() - 2);
}

TEST(ScanOutlierRemoval, IndicesAndBadPointsAreRespected)
{
  std::size_t wall_size = 0;
  auto points = wallWithOutliers(wall_size);
  points[5].x() = std::nanf("");
  const auto cloud = cloudOf(points);
  cloud->is_dense = false;
  const auto indices = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 1000; i-- > 0;)
    indices->push_back(static_cast<pcl::index_t>(i));
  indices->push_back(static_cast<pcl::index_t>(points.size() - 1));
  OutlierRemoval removal(true);
  removal.setInputCloud(cloud);
  removal.setIndices(indices);
  pcl::Indices kept;
  removal.filter(kept);
  ASSERT_GT(kept.size(), 900u);
  EXPECT_EQ(kept.front(), 999); // in the order of the indices
  EXPECT_EQ(removal.getRemovedIndices()->back(), indices->back());
  EXPECT_EQ(std::count(kept.begin(), kept.end(), 5), 0);
  removal.setNegative(true);
  removal.filter(kept);
  EXPECT_EQ(std::count(kept.begin(), kept.end(), 5), 0);
}

TEST(ScanOutlierRemoval, LargeCoordinatesDoNotMatter)
{
  std::size_t wall_size = 0;
  auto points = wallWithOutliers(wall_size);
  // A step of a float of this size is 1/16 m.
  for (auto& point : points)
    point = (16 * 8 * point.array()).round() / 16;
  const auto kept = [&](float shift) {
    auto moved = points;
    for (auto& point : moved)
      point.x() += shift;
    OutlierRemoval removal;
    removal.setInputCloud(cloudOf(moved));
    pcl::Indices indices;
    removal.filter(indices);
    return indices;
  };
  EXPECT_EQ(kept(0), kept(524288));
}

TEST(ScanOutlierRemoval, SmallInput)
{
  for (int count = 0; count < 4; ++count) {
    OutlierRemoval removal;
    removal.setInputCloud(cloudOf(std::vector<Eigen::Vector3f>(count, {1, 2, 3})));
    pcl::Indices kept;
    removal.filter(kept);
    EXPECT_EQ(kept.size(), static_cast<std::size_t>(count));
  }
}

TEST(ScanOutlierRemoval, SettersAndBadValues)
{
  OutlierRemoval removal;
  removal.setInputCloud(cloudOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  removal.setRadiusSearch(2);
  removal.setMinNeighborsInRadius(1);
  removal.setMeanK(2);
  removal.setStddevMulThresh(4);
  removal.setNumberOfThreads(1);
  EXPECT_EQ(removal.getRadiusSearch(), 2);
  EXPECT_EQ(removal.getMinNeighborsInRadius(), 1);
  EXPECT_EQ(removal.getMeanK(), 2);
  EXPECT_EQ(removal.getStddevMulThresh(), 4);
  const auto expectNothing = [&](auto change) {
    auto bad = removal;
    change(bad);
    pcl::Indices kept{1};
    bad.filter(kept);
    EXPECT_TRUE(kept.empty());
  };
  pcl::Indices kept;
  removal.filter(kept);
  EXPECT_EQ(kept.size(), 3u);
  expectNothing([](auto& r) { r.setRadiusSearch(-1); });
  expectNothing([](auto& r) { r.setRadiusSearch(std::nan("")); });
  expectNothing([](auto& r) { r.setMinNeighborsInRadius(-1); });
  expectNothing([](auto& r) { r.setMeanK(0); });
  expectNothing([](auto& r) { r.setStddevMulThresh(0); });
  expectNothing(
      [](auto& r) { r.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{7})); });
  ScanOutlierOptions options;
  options.mean_k = 0;
  EXPECT_THROW(scanOutliers({}, options), pcl::BadArgumentException);
  options = {};
  options.least_ratio = 0.5;
  EXPECT_THROW(scanOutliers({}, options), pcl::BadArgumentException);
}
