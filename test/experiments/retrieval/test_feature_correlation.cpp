/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "retrieval/feature_correlation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

/** Eq. (5.9) as it is printed. */
double
pearson(const std::vector<double>& x, const std::vector<double>& y)
{
  const auto n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0, both = 0, squares_x = 0, squares_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / n;
    mean_y += y[i] / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    both += (x[i] - mean_x) * (y[i] - mean_y);
    squares_x += (x[i] - mean_x) * (x[i] - mean_x);
    squares_y += (y[i] - mean_y) * (y[i] - mean_y);
  }
  return both / (std::sqrt(squares_x) * std::sqrt(squares_y));
}

pcl::PointCloud<pcl::PointNormal>::Ptr
sphere(std::size_t count, float radius)
{
  std::mt19937 rng(4);
  std::normal_distribution<float> normal;
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  while (cloud->size() < count) {
    const Eigen::Vector3f direction =
        Eigen::Vector3f(normal(rng), normal(rng), normal(rng)).normalized();
    pcl::PointNormal point;
    point.getVector3fMap() = radius * direction;
    point.getNormalVector3fMap() = direction;
    cloud->push_back(point);
  }
  return cloud;
}

} // namespace

TEST(FeatureCorrelation, IsThatOfTheEquation)
{
  std::mt19937 rng(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 20; ++trial) {
    FeatureMoments moments;
    std::vector<double> columns[4];
    for (int i = 0; i < 50; ++i) {
      PairFeatures pair{};
      const double shared = number(rng);
      for (std::size_t f = 0; f < 4; ++f) {
        pair[f] = number(rng) + static_cast<double>(f) * shared;
        columns[f].push_back(pair[f]);
      }
      moments.add(pair);
    }
    const auto found = moments.correlations();
    std::size_t k = 0;
    for (std::size_t f = 0; f < 4; ++f)
      for (std::size_t g = f + 1; g < 4; ++g)
        EXPECT_NEAR(found[k++], pearson(columns[f], columns[g]), 1e-12);
  }
  FeatureMoments constant; // f2 and f4 are
  constant.add({1, 2, 3, 4});
  constant.add({2, 2, 5, 4});
  const auto found = constant.correlations();
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(found[k], k == 1 ? 1 : 0, 1e-12);
}

TEST(FeatureCorrelation, OnSpheresByTheAngleBetweenTwoPoints)
{
  // With the angle t between two points, of density sin(t) / 2: f1 = 2 r sin(t / 2), f2
  // = t / 2, f3 = t or pi - t. All pairs of all spheres count together.
  EPPFOptions options;
  options.pair_count = 100000;
  for (const auto& radii : {std::vector<float>{3}, {1, 3}, {0.5f, 1, 4}}) {
    std::vector<double> f1, f1_own, f2, f3;
    std::vector<pcl::PointCloud<pcl::PointNormal>::Ptr> spheres;
    constexpr int steps = 4000;
    for (const float r : radii) {
      spheres.push_back(sphere(3000, r));
      for (int i = 0; i < steps; ++i) {
        const double t = std::acos(1 - 2 * (i + 0.5) / steps); // equally likely
        f1.push_back(2 * static_cast<double>(r) * std::sin(t / 2));
        f1_own.push_back(std::sin(t / 2));
        f2.push_back(t / 2);
        f3.push_back(std::min(t, M_PI - t));
      }
    }
    options.scale = 1;
    const auto metres = featureCorrelation(spheres, options);
    EXPECT_NEAR(metres[0], pearson(f1, f2), 0.01) << radii.size();
    EXPECT_NEAR(metres[1], pearson(f1, f3), 0.02);
    EXPECT_NEAR(metres[3], pearson(f2, f3), 0.02);
    options.scale = 0; // of each its own extent: as if there were one
    const auto own = featureCorrelation(spheres, options);
    EXPECT_NEAR(own[0], pearson(f1_own, f2), 0.01) << radii.size();
  }
}

TEST(FeatureCorrelation, ObjectsWithoutPairsAddNothing)
{
  EPPFOptions options;
  options.pair_count = 2000;
  const auto one = featureCorrelation({sphere(500, 1.0f)}, options);
  const auto empty = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  EXPECT_EQ(featureCorrelation({sphere(500, 1.0f), empty}, options), one);
  EXPECT_EQ(featureCorrelation({empty}, options)[0], 0);
  EXPECT_NEAR(extentOf(*sphere(2000, 1.5f)), 3.0, 0.05);
  EXPECT_EQ(correlationText({-1, 0, 1, 0, 1, 0})
                .find("correlation of features, mean |r| "
                      "0.500: f1 f2 -1.000, f1 f3 0.000"),
            0u);
}
