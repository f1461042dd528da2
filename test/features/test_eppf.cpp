/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "features/eppf_clouds.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace pcl::indoor::test;

namespace {

TEST(EPPFEstimation, OneObjectGivesOneDescriptor)
{
  const auto cloud = boxCloud(2000, 1);
  cloud->header.frame_id = "room";
  const auto output = describe(cloud);
  ASSERT_EQ(output.size(), 1u);
  EXPECT_EQ(output.width, 1u);
  EXPECT_EQ(output.height, 1u);
  EXPECT_TRUE(output.is_dense);
  EXPECT_EQ(output.header.frame_id, "room");
  EXPECT_NEAR(
      std::accumulate(output[0].histogram, output[0].histogram + 1200, 0.0), 1.0, 1e-6);
}

TEST(EPPFEstimation, CallThroughTheBaseGivesTheSame)
{
  const auto cloud = boxCloud(500, 2);
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(cloud);
  Descriptors own, base;
  estimation.compute(own);
  static_cast<pcl::Feature<pcl::PointNormal, Signature>&>(estimation).compute(base);
  ASSERT_EQ(own.size(), 1u);
  ASSERT_EQ(base.size(), 1u);
  EXPECT_TRUE(isSame(own[0], base[0]));
  estimation.compute(own); // a second run on the same object
  ASSERT_EQ(own.size(), 1u);
  EXPECT_TRUE(isSame(own[0], base[0]));
}

TEST(EPPFEstimation, SeparateNormalsOfAnyLengthWillDo)
{
  const auto cloud = boxCloud(500, 4);
  auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  for (const auto& point : *cloud) {
    points->push_back({point.x, point.y, point.z});
    normals->push_back({4 * point.normal_x, 4 * point.normal_y, 4 * point.normal_z});
  }
  pcl::EPPFEstimation<pcl::PointXYZ, pcl::Normal, Signature> estimation;
  estimation.setInputCloud(points);
  estimation.setInputNormals(normals);
  Descriptors output;
  estimation.compute(output);
  ASSERT_EQ(output.size(), 1u);
  EXPECT_TRUE(isSame(output[0], describe(cloud)[0]));
}

TEST(EPPFEstimation, OnlyTheIndicesAreRead)
{
  const auto cloud = boxCloud(400, 5);
  auto more = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>(*cloud);
  *more += *boxCloud(300, 6);
  auto indices = pcl::make_shared<pcl::Indices>(400);
  std::iota(indices->begin(), indices->end(), 0);
  Estimation estimation;
  estimation.setInputCloud(more);
  estimation.setInputNormals(more);
  estimation.setIndices(indices);
  Descriptors output;
  estimation.compute(output);
  ASSERT_EQ(output.size(), 1u);
  EXPECT_TRUE(isSame(output[0], describe(cloud)[0]));
}

TEST(EPPFEstimation, LargeCoordinatesChangeLittle)
{
  // At 2^22 m (UTM) a float has steps of 0.5 m: positions that are whole metres lose
  // nothing, so that any difference would be the estimator's own loss.
  auto cloud = boxCloud(1000, 9);
  for (auto& point : *cloud)
    for (int axis = 0; axis < 3; ++axis)
      point.data[axis] = std::round(1000.0f * point.data[axis]);
  auto far = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>(*cloud);
  for (auto& point : *far) {
    point.x += 4194304.0f;
    point.y += 4194304.0f;
  }
  EXPECT_TRUE(isSame(describe(far)[0], describe(cloud)[0]));
}

TEST(EPPFEstimation, TurnedObjectLooksLikeItselfAndUnlikeOthers)
{
  const auto cloud = boxCloud(2000, 10);
  auto turned = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(0.7f, Eigen::Vector3f(1.0f, -1.0f, 0.5f).normalized())
          .toRotationMatrix();
  for (auto point : *cloud) {
    point.getVector3fMap() = turn * point.getVector3fMap();
    point.getNormalVector3fMap() = turn * point.getNormalVector3fMap();
    turned->push_back(point);
  }
  const auto original = describe(cloud)[0];
  auto cube = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  for (const auto& point : pcl::indoor::boxSurface({1.0f, 1.0f, 1.0f}, 2000, 10)) {
    cube->emplace_back();
    cube->back().getVector3fMap() = point.position;
    cube->back().getNormalVector3fMap() = point.normal;
  }
  // Sampling error is about sqrt(2 * bins / pairs) = 0.2 with the 500 bins a box fills,
  // and the voxel grid turns with the axes; another shape changes several times as
  // much.
  EXPECT_LT(2 * difference(describe(turned)[0], original),
            difference(describe(cube)[0], original));
}

TEST(EPPFEstimation, SettersAreKept)
{
  Estimation estimation;
  estimation.setPairCount(17);
  estimation.setBins({10, 6, 5, 4});
  estimation.setScale(2.5);
  estimation.setSeed(4);
  estimation.setNumberOfThreads(3);
  estimation.setWeightingConstant(1.5);
  estimation.setSurfaceAngleRule(pcl::indoor::SurfaceAngleRule::Mean);
  estimation.setNormalSides(pcl::indoor::NormalSides::Given);
  estimation.setPairSampling(pcl::indoor::PairSampling::Uniform);
  estimation.setFeatures({true, false, true, false});
  estimation.setGridSize(32);
  EXPECT_EQ(estimation.getPairCount(), 17u);
  EXPECT_EQ(estimation.getBins().surface_angle, 6);
  EXPECT_EQ(estimation.getScale(), 2.5);
  EXPECT_EQ(estimation.getSeed(), 4u);
  EXPECT_EQ(estimation.getNumberOfThreads(), 3u);
  EXPECT_EQ(estimation.getWeightingConstant(), 1.5);
  EXPECT_EQ(estimation.getSurfaceAngleRule(), pcl::indoor::SurfaceAngleRule::Mean);
  EXPECT_EQ(estimation.getNormalSides(), pcl::indoor::NormalSides::Given);
  EXPECT_EQ(estimation.getPairSampling(), pcl::indoor::PairSampling::Uniform);
  EXPECT_FALSE(estimation.getFeatures().surface_angle);
  EXPECT_EQ(estimation.getGridSize(), 32);
  const auto options = estimation.getOptions();
  Estimation other;
  other.setOptions(options);
  EXPECT_EQ(other.getScale(), 2.5);
}

} // namespace
