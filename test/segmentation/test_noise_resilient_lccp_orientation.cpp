/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/labelled_points.h"

#include "objects/object_steps.h"

#include <pcl/segmentation/noise_resilient_lccp.h>

#include <gtest/gtest.h>

using namespace pcl::indoor;

namespace {

using Segmentation = pcl::NoiseResilientLCCP<pcl::PointXYZ>;

/** A wall at y = 0; its points may be seen from either side. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
wall()
{
  std::mt19937 rng(3);
  test::LabelledPoints scene;
  scene.addRectangle(
      {0, 0, 0}, {2, 0, 0}, {0, 0, 2}, {0, 1, 0}, 1, 0.015f, 0.002f, rng);
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const auto& point : scene.points)
    cloud->emplace_back(point.x(), point.y(), point.z());
  return cloud;
}

/** Share of the normals that point to positive y. */
double
shareForwards(const Segmentation& segmentation)
{
  const auto& normals = stepsOf(segmentation.getResult()).scene.voxels.normals;
  std::size_t forwards = 0;
  for (const auto& normal : normals)
    forwards += normal.y() > 0;
  return static_cast<double>(forwards) / static_cast<double>(normals.size());
}

} // namespace

TEST(NoiseResilientLCCP, OrientationIsAChoice)
{
  Segmentation segmentation;
  EXPECT_EQ(segmentation.getNormalOrientation(), NormalOrientation::Automatic);
  segmentation.setInputCloud(wall());
  std::vector<std::uint32_t> labels;
  for (const double side : {-1.0, 1.0}) {
    segmentation.setViewPoint(1, 3 * side, 1);
    for (const auto way : {NormalOrientation::Automatic,
                           NormalOrientation::Viewpoint,
                           NormalOrientation::Graph}) {
      segmentation.setNormalOrientation(way);
      EXPECT_EQ(segmentation.getNormalOrientation(), way);
      segmentation.segment(labels);
      EXPECT_EQ(shareForwards(segmentation), side > 0 ? 1 : 0);
    }
  }
  // The viewpoint plays no part.
  segmentation.setNormalOrientation(NormalOrientation::FreeSpace);
  segmentation.segment(labels);
  const double forwards = shareForwards(segmentation);
  segmentation.setViewPoint(1, -3, 1);
  segmentation.segment(labels);
  EXPECT_EQ(shareForwards(segmentation), forwards);
}

TEST(NoiseResilientLCCP, AViewpointThatIsNotKnownIsAnError)
{
  Segmentation segmentation;
  segmentation.setInputCloud(wall());
  segmentation.setNormalOrientation(NormalOrientation::Viewpoint);
  std::vector<std::uint32_t> labels{1};
  segmentation.segment(labels);
  EXPECT_TRUE(labels.empty());
}
