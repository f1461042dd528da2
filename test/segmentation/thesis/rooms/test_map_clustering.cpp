/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/map_clustering.h"
#include "thesis/rooms/potential_field.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

using pcl::indoor::DBSCANOptions;
using pcl::indoor::FieldConnectivity;
using pcl::indoor::HDBSCANOptions;
using pcl::indoor::MapDistance;
using pcl::indoor::PixelMap;
using pcl::indoor::VisibilityVectors;
using pcl::indoor::VoxelMap;
using pcl::indoor::thesis::MapDistanceOptions;

namespace {

/** Random walls or random rooms; the field, its pixels and their views. */
struct Map {
  PixelMap<float> field;
  std::vector<std::size_t> pixels;
  VisibilityVectors visibility;

  Map(int nx, int ny, bool rooms, std::mt19937& rng)
  {
    VoxelMap<std::uint8_t> walls;
    walls.shape = {nx, ny, 1};
    walls.values.assign(walls.shape.size(), 0);
    const int step = 6 + static_cast<int>(rng() % 6);
    for (int x = 0; x < nx; ++x)
      for (int y = 0; y < ny; ++y) {
        const bool wall = x % step == 0 || y % step == 0;
        walls.at(x, y, 0) = rooms ? wall && rng() % 8 != 0 : rng() % 30 == 0;
      }
    field = {nx, ny, {}};
    for (const auto value : pcl::indoor::potentialField(walls).values)
      field.values.push_back(
          value == pcl::indoor::kNoObstacle ? 0.0f : static_cast<float>(value));
    std::vector<Eigen::Vector3i> voxels, landmarks;
    for (int x = 0; x < nx; ++x)
      for (int y = 0; y < ny; ++y)
        if (field.at(x, y) > 0.0f && rng() % 20 != 0) {
          pixels.push_back(field.index(x, y));
          voxels.emplace_back(x, y, 0);
          if (rng() % 8 == 0)
            landmarks.emplace_back(x, y, 0);
        }
    visibility = pcl::indoor::visibilityVectors(walls, voxels, landmarks);
  }
};

double
randomWeight(std::mt19937& rng)
{
  return rng() % 4 == 0 ? 0.0 : static_cast<double>(rng() % 100) / 100.0;
}

} // namespace

TEST(ClusterMap, EqualsTheDenseComputation)
{
  std::mt19937 rng(1);
  int clusters = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const Map map(1 + rng() % 30, 1 + rng() % 30, trial % 2, rng);
    std::vector<float> thresholds;
    if (trial % 3 == 0) // many ties
      thresholds = {1.0f, 4.0f, 9.0f};
    const FieldConnectivity connectivity(map.field, thresholds);
    MapDistanceOptions weights;
    if (trial % 5 != 0) {
      weights.visibility_weight = randomWeight(rng);
      weights.euclidean_weight = randomWeight(rng);
      weights.field_weight = randomWeight(rng);
      weights.euclidean_scale = static_cast<double>(rng() % 30);
    }
    const MapDistance distance(map.field.nx,
                               map.field.ny,
                               map.pixels,
                               connectivity,
                               trial % 7 ? map.visibility : VisibilityVectors(),
                               weights);
    HDBSCANOptions options;
    options.min_cluster_size = 2 + rng() % 20;
    options.min_samples = 1 + rng() % 15;
    options.allow_single_cluster = rng() % 2;
    const auto result = pcl::indoor::clusterMap(distance, options);
    const auto expected = pcl::indoor::hdbscan(distance.size(), distance, options);
    ASSERT_EQ(result.labels, expected.labels) << "trial " << trial;
    ASSERT_EQ(result.probabilities, expected.probabilities) << "trial " << trial;
    ASSERT_EQ(result.outlier_scores, expected.outlier_scores) << "trial " << trial;
    clusters += static_cast<int>(result.stabilities.size());
    DBSCANOptions cut;
    cut.epsilon = static_cast<double>(rng() % 100) / 200.0;
    cut.min_samples = options.min_samples;
    ASSERT_EQ(pcl::indoor::dbscanMap(distance, cut),
              pcl::indoor::dbscan(distance.size(), distance, cut))
        << "trial " << trial;
  }
  EXPECT_GT(clusters, 150); // there was something to compare
}

TEST(ClusterMap, DoesNotDependOnThreads)
{
  std::mt19937 rng(2);
  const Map map(90, 70, true, rng);
  const FieldConnectivity connectivity(map.field);
  const MapDistance distance(90, 70, map.pixels, connectivity, map.visibility, {});
  HDBSCANOptions options;
  options.min_cluster_size = 20;
  options.threads = 1;
  const auto one = pcl::indoor::clusterMap(distance, options);
  options.threads = 8;
  const auto eight = pcl::indoor::clusterMap(distance, options);
  EXPECT_EQ(one.labels, eight.labels);
  EXPECT_EQ(one.probabilities, eight.probabilities);
  EXPECT_EQ(one.stabilities, eight.stabilities);
}

TEST(MapDistance, IsTheWeightedSumOfItsParts)
{
  std::mt19937 rng(3);
  const Map map(25, 31, true, rng);
  const FieldConnectivity connectivity(map.field);
  MapDistanceOptions weights;
  const MapDistance distance(25, 31, map.pixels, connectivity, map.visibility, weights);
  const auto euclidean = [&](std::size_t i, std::size_t j) {
    return std::hypot(distance.x(i) - distance.x(j), distance.y(i) - distance.y(j));
  };
  double diameter = 0.0;
  for (std::size_t i = 0; i < distance.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      diameter = std::max(diameter, euclidean(i, j));
  for (std::size_t i = 0; i < distance.size(); ++i) {
    EXPECT_EQ(map.pixels[i], map.field.index(distance.x(i), distance.y(i)));
    for (std::size_t j = 0; j < i; ++j) {
      const double field = connectivity.distance(map.pixels[i], map.pixels[j]);
      const double expected =
          0.05 * pcl::indoor::visibilityDistance(map.visibility, i, j) +
          0.7 * euclidean(i, j) / diameter + 0.25 * field / connectivity.maximum();
      ASSERT_NEAR(distance(i, j), expected, 1e-12); // rounding of the reordered terms
      ASSERT_EQ(distance(i, j), distance(j, i));
    }
  }
}

TEST(MapDistance, RejectsBadInput)
{
  const PixelMap<float> field{2, 2, {1.0f, 1.0f, 1.0f, 1.0f}};
  const FieldConnectivity connectivity(field);
  const VisibilityVectors blind;
  const auto make = [&](int nx,
                        const std::vector<std::size_t>& pixels,
                        const VisibilityVectors& visibility,
                        const MapDistanceOptions& options) {
    return MapDistance(nx, 2, pixels, connectivity, visibility, options).size();
  };
  EXPECT_EQ(make(2, {0, 3}, blind, {}), 2u);
  EXPECT_THROW(make(3, {0, 3}, blind, {}), pcl::BadArgumentException);
  EXPECT_THROW(make(2, {0, 4}, blind, {}), pcl::BadArgumentException);
  EXPECT_THROW(make(2, {3, 0}, blind, {}), pcl::BadArgumentException);
  VisibilityVectors one;
  one.count = 1;
  EXPECT_THROW(make(2, {0, 3}, one, {}), pcl::BadArgumentException);
  MapDistanceOptions negative;
  negative.field_weight = -1.0;
  EXPECT_THROW(make(2, {0, 3}, blind, negative), pcl::BadArgumentException);
}

TEST(ClusterMap, HandlesLittleInput)
{
  const PixelMap<float> field{1, 3, {1.0f, 2.0f, 0.0f}};
  const FieldConnectivity connectivity(field);
  const VisibilityVectors blind;
  for (const std::vector<std::size_t>& pixels :
       {std::vector<std::size_t>{}, {1}, {0, 1}, {0, 1, 2}}) {
    const MapDistance distance(1, 3, pixels, connectivity, blind, {});
    EXPECT_EQ(pcl::indoor::clusterMap(distance, {}).labels,
              std::vector<int>(pixels.size(), -1));
    const std::vector<double> endless(pixels.size(),
                                      std::numeric_limits<double>::infinity());
    EXPECT_TRUE(pcl::indoor::mapSpanningTree(distance, endless).empty());
  }
}
