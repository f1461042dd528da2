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
    std::vector<PairFeatures> pairs(50);
    std::vector<double> columns[4];
    for (auto& pair : pairs) {
      const double shared = number(rng);
      for (std::size_t f = 0; f < 4; ++f) {
        pair[f] = number(rng) + static_cast<double>(f) * shared;
        columns[f].push_back(pair[f]);
      }
    }
    const auto found = pearsonCorrelations(pairs);
    std::size_t k = 0;
    for (std::size_t f = 0; f < 4; ++f)
      for (std::size_t g = f + 1; g < 4; ++g)
        EXPECT_NEAR(found[k++], pearson(columns[f], columns[g]), 1e-12);
  }
  EXPECT_EQ(pearsonCorrelations({{1, 2, 3, 4}, {2, 2, 5, 4}})[0], 0); // f2 is constant
}

TEST(FeatureCorrelation, OnASphereByTheAngleBetweenItsPoints)
{
  // With the angle t between two points, of density sin(t) / 2: f1 = 2 r sin(t / 2), f2
  // = t / 2, f3 = t or pi - t.
  std::vector<double> f1, f2, f3;
  constexpr int steps = 4000;
  for (int i = 0; i < steps; ++i) {
    const double t = std::acos(1 - 2 * (i + 0.5) / steps); // equally likely
    f1.push_back(2 * 3 * std::sin(t / 2));
    f2.push_back(t / 2);
    f3.push_back(std::min(t, M_PI - t));
  }
  EPPFOptions options;
  options.pair_count = 100000;
  const auto found = featureCorrelation({sphere(3000, 3.0f)}, options);
  EXPECT_NEAR(found[0], std::abs(pearson(f1, f2)), 0.01);
  EXPECT_NEAR(found[1], std::abs(pearson(f1, f3)), 0.02);
  EXPECT_NEAR(found[3], std::abs(pearson(f2, f3)), 0.02);
}

TEST(FeatureCorrelation, MeansOverObjectsThatHaveFeatures)
{
  EPPFOptions options;
  options.pair_count = 2000;
  const auto one = featureCorrelation({sphere(500, 1.0f)}, options);
  const auto empty = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  EXPECT_EQ(featureCorrelation({sphere(500, 1.0f), empty}, options), one);
  EXPECT_EQ(featureCorrelation({empty}, options)[0], 0);
  EXPECT_NEAR(extentOf(*sphere(2000, 1.5f)), 3.0, 0.05);
  EXPECT_EQ(correlationText({1, 0, 1, 0, 1, 0})
                .find("correlation of features, mean |r| "
                      "0.500: f1 f2 1.000, f1 f3 0.000"),
            0u);
}
