/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "features/eppf_clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace pcl::indoor::test;

namespace {

TEST(EPPFEstimation, PointsTooFarToComputeWithAreSkipped)
{
  auto cloud = boxCloud(500, 3);
  const auto expected = describe(cloud);
  for (const float far : {1e10f, 1e20f, 3e38f}) {
    auto damaged = *cloud;
    damaged.push_back(damaged.front());
    damaged.back().x = far;
    const auto output = describe(damaged.makeShared());
    ASSERT_EQ(output.size(), 1u);
    EXPECT_TRUE(isSame(output[0], expected[0])) << far;
    for (auto& point : damaged)
      point.getVector3fMap() *= far;
    if (far > 1e15f) { // else a few points near the axes stay
      EXPECT_FALSE(describe(damaged.makeShared()).is_dense) << far;
    }
  }
}

TEST(EPPFEstimation, TinyObjectsTakeNoLongerThanOthers)
{
  for (const float size : {1e-18f, 1e-20f, 1e-22f, 1e-40f}) {
    auto cloud = boxCloud(500, 3); // squares of such lengths are denormal or 0
    for (auto& point : *cloud)
      point.getVector3fMap() *= size;
    EXPECT_EQ(describe(cloud).size(), 1u);
  }
}

TEST(EPPFEstimation, SkipsPointsThatAreNotFinite)
{
  const auto cloud = boxCloud(400, 7);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  auto broken = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  for (std::size_t k = 0; k < cloud->size(); ++k) {
    auto bad = (*cloud)[k];
    if (k % 3 == 0)
      bad.y = nan;
    else if (k % 3 == 1)
      bad.normal_z = std::numeric_limits<float>::infinity();
    else
      bad.normal_x = bad.normal_y = bad.normal_z = 0.0f;
    broken->push_back(bad);
    broken->push_back((*cloud)[k]);
  }
  broken->is_dense = false;
  EXPECT_TRUE(isSame(describe(broken)[0], describe(cloud)[0]));
}

TEST(EPPFEstimation, NoPairGivesNaN)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const std::size_t count : {1u, 2u, 50u}) {
    auto cloud = boxCloud(count, 8);
    if (count > 1)
      for (auto& point : *cloud)
        point.x = nan;
    const auto output = describe(cloud);
    ASSERT_EQ(output.size(), 1u);
    EXPECT_FALSE(output.is_dense);
    for (const float value : output[0].histogram)
      EXPECT_TRUE(std::isnan(value));
  }
}

void
expectRefused(Estimation& estimation)
{
  Descriptors output;
  output.resize(3);
  estimation.compute(output);
  EXPECT_TRUE(output.empty());
}

TEST(EPPFEstimation, RefusesUnusableInput)
{
  const auto cloud = boxCloud(10, 11);
  Estimation estimation;
  expectRefused(estimation); // no cloud
  estimation.setInputCloud(cloud);
  expectRefused(estimation); // no normals
  estimation.setInputNormals(boxCloud(9, 11));
  expectRefused(estimation); // another number of them
  estimation.setInputNormals(cloud);
  estimation.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{0, 10}));
  expectRefused(estimation); // outside the cloud
  estimation.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{-1}));
  expectRefused(estimation);
  estimation.setIndices(pcl::make_shared<pcl::Indices>());
  expectRefused(estimation); // none
  estimation.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{0, 9}));
  Descriptors output;
  estimation.compute(output);
  EXPECT_EQ(output.size(), 1u);
  const auto empty = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  Estimation fresh;
  fresh.setInputCloud(empty);
  fresh.setInputNormals(empty);
  expectRefused(fresh);
}

TEST(EPPFEstimation, RefusesParametersOutOfRange)
{
  const auto cloud = boxCloud(10, 12);
  const auto refuses = [&](auto change) {
    Estimation estimation;
    estimation.setInputCloud(cloud);
    estimation.setInputNormals(cloud);
    change(estimation);
    expectRefused(estimation);
  };
  refuses([](auto& e) { e.setPairCount(0); });
  refuses([](auto& e) { e.setScale(-1.0); });
  refuses([](auto& e) { e.setScale(std::nan("")); });
  refuses([](auto& e) { e.setWeightingConstant(1.0); });
  refuses([](auto& e) { e.setGridSize(65); });
  refuses([](auto& e) { e.setBins({20, 10, 6, 2}); }); // 2,400 bins
}

} // namespace
