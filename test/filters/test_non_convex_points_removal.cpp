/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/labelled_points.h"

#include <pcl/exceptions.h>
#include <pcl/filters/non_convex_points_removal.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <limits>

using namespace pcl::indoor;

namespace {

using NonConvexRemoval = pcl::NonConvexPointsRemoval<pcl::PointXYZ, pcl::Normal>;

struct Walls {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud{new pcl::PointCloud<pcl::PointXYZ>};
  pcl::PointCloud<pcl::Normal>::Ptr normals{new pcl::PointCloud<pcl::Normal>};
};

/** Two walls that meet, of high curvature along the edge: concave seen from one side,
 * convex from the other. */
Walls
corner(float side)
{
  Walls scene;
  const float diagonal = std::sqrt(0.5f) * side;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) {
      const auto a = 0.01f * static_cast<float>(i), b = 0.01f * static_cast<float>(j);
      scene.cloud->emplace_back(a, 0.0f, b);
      scene.cloud->emplace_back(0.0f, a + 0.005f, b);
      if (a < 0.004f)
        for (int k = 0; k < 2; ++k)
          scene.normals->emplace_back(diagonal, diagonal, 0.0f, 0.1f);
      else {
        scene.normals->emplace_back(0.0f, side, 0.0f, 0.0f);
        scene.normals->emplace_back(side, 0.0f, 0.0f, 0.0f);
      }
    }
  return scene;
}

pcl::Indices
filtered(const Walls& scene, bool negative = false)
{
  NonConvexRemoval removal;
  removal.setInputCloud(scene.cloud);
  removal.setInputNormals(scene.normals);
  removal.setNegative(negative);
  removal.setRadius(0.05);
  pcl::Indices indices;
  removal.filter(indices);
  return indices;
}

} // namespace

TEST(NonConvexPoints, AgreesWithCountingAllPoints)
{
  std::mt19937 rng(3);
  const auto random = [&] { return static_cast<float>(rng() % 1000) / 1000; };
  std::size_t found = 0, all = 0;
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<Eigen::Vector3f> points, normals;
    std::vector<float> curvatures;
    for (int i = 0; i < 300; ++i) {
      const float x = random(), y = random(), z = 0.2f * random();
      points.emplace_back(x, y, z);
      normals.push_back(Eigen::Vector3f(0.1f, random() - 0.5f, 1).normalized());
      curvatures.push_back(0.1f * random());
    }
    NonConvexityOptions options;
    options.radius = 0.15;
    options.ratio_threshold = random();
    const auto result = nonConvexPoints(points, normals, curvatures, options);
    for (std::size_t i = 0; i < points.size(); ++i) {
      int positive = 0, negative = 0;
      for (const auto& other : points) {
        const float height = normals[i].dot(other - points[i]);
        if ((other - points[i]).norm() <= 0.15f)
          ++(height > 0 ? positive : negative);
      }
      --negative; // the point itself is in neither half-space
      const bool expected = curvatures[i] > options.curvature_threshold &&
                            static_cast<float>(positive) >=
                                options.ratio_threshold * static_cast<float>(negative);
      EXPECT_EQ(result[i] != 0, expected) << "trial " << trial << " point " << i;
      found += result[i];
      ++all;
    }
  }
  EXPECT_GT(found, all / 10);
  EXPECT_LT(found, all * 3 / 4);
}

TEST(NonConvexPoints, IsTheSameForAnyNumberOfThreads)
{
  const auto scene = test::floorWithTwoBoxes();
  const std::vector<float> curvatures(scene.points.size(), 0.1f);
  NonConvexityOptions one, two;
  one.threads = 1;
  two.threads = 2;
  EXPECT_EQ(nonConvexPoints(scene.points, scene.normals, curvatures, one),
            nonConvexPoints(scene.points, scene.normals, curvatures, two));
}

TEST(NonConvexPoints, RejectsBadOptions)
{
  NonConvexityOptions options;
  options.radius = -1;
  EXPECT_THROW(nonConvexPoints({}, {}, {}, options), pcl::BadArgumentException);
  options = {};
  options.curvature_threshold = 0.5f;
  EXPECT_THROW(nonConvexPoints({}, {}, {}, options), pcl::BadArgumentException);
  options = {};
  options.ratio_threshold = -1;
  EXPECT_THROW(nonConvexPoints({}, {}, {}, options), pcl::BadArgumentException);
  options = {};
  EXPECT_THROW(nonConvexPoints({{0, 0, 0}}, {}, {}, options),
               pcl::BadArgumentException);
  EXPECT_TRUE(nonConvexPoints({}, {}, {}, options).empty());
}

TEST(NonConvexPointsRemoval, RemovesTheConcaveSideAndKeepsTheConvexOne)
{
  const auto concave = corner(1), convex = corner(-1);
  EXPECT_EQ(filtered(concave, true).size(), 40u); // a column of 20 on each wall
  EXPECT_EQ(filtered(convex, true).size(), 0u);
}

TEST(NonConvexPointsRemoval, NegativeGivesTheOthers)
{
  const auto scene = corner(1);
  auto kept = filtered(scene);
  const auto removed = filtered(scene, true);
  EXPECT_FALSE(removed.empty());
  kept.insert(kept.end(), removed.begin(), removed.end());
  std::sort(kept.begin(), kept.end());
  for (std::size_t i = 0; i < scene.cloud->size(); ++i)
    ASSERT_EQ(kept[i], static_cast<pcl::index_t>(i));
}

TEST(NonConvexPointsRemoval, KeepsPointsOfLowCurvature)
{
  auto scene = corner(1);
  for (auto& normal : *scene.normals)
    normal.curvature = 0.03f; // not above the threshold
  EXPECT_EQ(filtered(scene).size(), scene.cloud->size());
}

TEST(NonConvexPointsRemoval, RespectsIndicesAndReportsTheRemoved)
{
  const auto scene = corner(1);
  const pcl::IndicesPtr half(new pcl::Indices);
  for (std::size_t i = 0; i < scene.cloud->size(); i += 2) // one of the two walls
    half->push_back(static_cast<pcl::index_t>(i));
  NonConvexRemoval removal(true);
  removal.setInputCloud(scene.cloud);
  removal.setInputNormals(scene.normals);
  removal.setIndices(half);
  pcl::Indices kept;
  removal.filter(kept);
  const auto removed = removal.getRemovedIndices();
  EXPECT_EQ(kept.size() + removed->size(), half->size());
  for (const auto index : kept)
    EXPECT_EQ(index % 2, 0);
}

TEST(NonConvexPointsRemoval, DropsPointsThatAreNotFiniteInBothModes)
{
  auto scene = corner(1);
  (*scene.cloud)[3].x = std::numeric_limits<float>::quiet_NaN();
  for (const bool negative : {false, true})
    for (const auto index : filtered(scene, negative))
      EXPECT_NE(index, 3);
}

TEST(NonConvexPointsRemoval, WorksFarFromTheOrigin)
{
  const auto near = corner(1);
  auto far = corner(1);
  for (auto& point : *far.cloud)
    point.x += 64; // floats still resolve 8 micrometres here
  EXPECT_EQ(filtered(near), filtered(far));
}

TEST(NonConvexPointsRemoval, GivesNothingForWrongUse)
{
  const auto scene = corner(1);
  NonConvexRemoval removal;
  pcl::Indices indices;
  removal.setInputCloud(scene.cloud);
  removal.filter(indices);
  EXPECT_TRUE(indices.empty()) << "no normals";
  removal.setInputNormals(scene.normals);
  removal.setRadius(-1);
  removal.filter(indices);
  EXPECT_TRUE(indices.empty()) << "radius";
  removal.setRadius(0.05);
  removal.setCurvatureThreshold(std::nanf(""));
  removal.filter(indices);
  EXPECT_TRUE(indices.empty()) << "curvature";
  removal.setCurvatureThreshold(0.03f);
  removal.setRatioThreshold(2);
  removal.filter(indices);
  EXPECT_TRUE(indices.empty()) << "ratio";
  removal.setRatioThreshold(0.2f);
  removal.setIndices(pcl::IndicesPtr(new pcl::Indices{100000}));
  removal.filter(indices);
  EXPECT_TRUE(indices.empty()) << "index";
  removal.setIndices(pcl::IndicesPtr(new pcl::Indices{0, 1, 2, 3, 4, 5}));
  removal.filter(indices);
  EXPECT_FALSE(indices.empty()) << "usable again";
}

TEST(NonConvexPointsRemoval, OnePointAndEqualPointsStay)
{
  Walls scene;
  for (int i = 0; i < 3; ++i) {
    scene.cloud->emplace_back(1.0f, 1.0f, 1.0f);
    scene.normals->emplace_back(0.0f, 0.0f, 1.0f, 0.0f);
    EXPECT_EQ(filtered(scene).size(), scene.cloud->size());
  }
}

TEST(NonConvexPointsRemoval, ARadiusTooSmallForTheExtentGivesNothing)
{
  const auto scene = corner(1);
  (*scene.cloud)[0].x = 5e8f;
  NonConvexRemoval removal;
  removal.setInputCloud(scene.cloud);
  removal.setInputNormals(scene.normals);
  removal.setRadius(1e-3);
  pcl::Indices indices{1, 2, 3};
  EXPECT_NO_THROW(removal.filter(indices));
  EXPECT_TRUE(indices.empty());
}

TEST(NonConvexPointsRemoval, DefaultsAreAsDocumented)
{
  const NonConvexRemoval removal;
  EXPECT_EQ(removal.getRadius(), 0);
  EXPECT_FLOAT_EQ(removal.getCurvatureThreshold(), 0.03f);
  EXPECT_FLOAT_EQ(removal.getRatioThreshold(), 0.2f);
  EXPECT_FALSE(removal.getInputNormals());
}
