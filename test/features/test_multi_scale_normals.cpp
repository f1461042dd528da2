/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "features/known_normals.h"
#include "support/labelled_cloud.h"

#include <pcl/exceptions.h>
#include <pcl/features/multi_scale_normals.h>
#include <pcl/features/normal_3d.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace pcl::indoor;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;

MultiScaleNormalOptions
withRadius(double radius, unsigned scales, unsigned threads = 1)
{
  MultiScaleNormalOptions options;
  options.radius = radius;
  options.scales = scales;
  options.threads = threads;
  return options;
}

/** PCL's plane of all points within a radius, which are searched one by one. */
pcl::Normal
planeWithin(const Cloud& cloud, const pcl::PointXYZ& place, double radius)
{
  pcl::Indices near;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if ((cloud[i].getVector3fMap() - place.getVector3fMap()).norm() <= radius)
      near.push_back(static_cast<pcl::index_t>(i));
  pcl::Normal normal;
  Eigen::Vector4f plane;
  pcl::computePointNormal(cloud, near, plane, normal.curvature);
  normal.getNormalVector3fMap() = plane.head<3>();
  return normal;
}

double
cosine(const pcl::Normal& a, const Eigen::Vector3f& b)
{
  return std::abs(a.getNormalVector3fMap().dot(b));
}

} // namespace

TEST(MultiScaleNormals, OfAllScalesTheFlattestDecides)
{
  const auto cloud = *test::cloudOf(test::noisyBox(0.002f).points);
  const auto normals = multiScaleNormals(cloud, withRadius(0.08, 3));
  ASSERT_EQ(normals.size(), cloud.size());
  for (std::size_t i = 0; i < cloud.size(); i += 37) {
    pcl::Normal flattest;
    flattest.curvature = 1;
    for (const double radius : {0.04, 0.08 / std::sqrt(2.0), 0.08}) {
      const auto plane = planeWithin(cloud, cloud[i], radius);
      if (plane.curvature <= flattest.curvature)
        flattest = plane;
    }
    EXPECT_NEAR(normals[i].curvature, flattest.curvature, 1e-4) << i;
    EXPECT_GT(cosine(normals[i], flattest.getNormalVector3fMap()), 0.999) << i;
  }
}

TEST(MultiScaleNormals, EdgesAreSharperThanAtOneScale)
{
  const auto box = test::noisyBox(0.002f);
  const auto cloud = *test::cloudOf(box.points);
  const auto several = multiScaleNormals(cloud, withRadius(0.08, 4));
  const auto one = multiScaleNormals(cloud, withRadius(0.08, 1));
  EXPECT_LT(test::shareOfBad(several, box.normals),
            0.75 * test::shareOfBad(one, box.normals));
}

TEST(MultiScaleNormals, OneScaleIsNormalEstimation)
{
  const auto cloud = test::cloudOf(test::noisyBox(0.002f).points);
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(0.05);
  Normals upstream;
  estimation.compute(upstream);
  const auto normals = multiScaleNormals(*cloud, withRadius(0.05, 1));
  for (std::size_t i = 0; i < upstream.size(); ++i) {
    EXPECT_GT(cosine(normals[i], upstream[i].getNormalVector3fMap()), 0.9999) << i;
    EXPECT_NEAR(normals[i].curvature, upstream[i].curvature, 1e-4) << i;
  }
}

TEST(MultiScaleNormals, TheRadiusFollowsTheResolution)
{
  const auto box = test::noisyBox(0.002f);
  const auto normals = multiScaleNormals(*test::cloudOf(box.points));
  EXPECT_LT(test::shareOfBad(normals, box.normals), 0.3);
}

TEST(MultiScaleNormals, ThreadsAndCopiesAndUnusablePointsChangeNothing)
{
  const auto points = test::noisyBox(0.002f).points;
  auto cloud = *test::cloudOf(points);
  const auto normals = multiScaleNormals(cloud, withRadius(0.06, 4));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  cloud.emplace_back(nan, 0.0f, 0.0f);
  cloud.emplace_back(0.0f, std::numeric_limits<float>::infinity(), 0.0f);
  const auto more = multiScaleNormals(cloud, withRadius(0.06, 4, 7));
  ASSERT_EQ(more.size(), points.size() + 2);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(more[i].getNormalVector4fMap(), normals[i].getNormalVector4fMap()) << i;
  EXPECT_TRUE(std::isnan(more[points.size()].normal_x));
  EXPECT_TRUE(std::isnan(more[points.size() + 1].curvature));
}

TEST(MultiScaleNormals, NeedAPlane)
{
  Cloud cloud;
  EXPECT_TRUE(multiScaleNormals(cloud).empty());
  cloud.emplace_back(1.0f, 2.0f, 3.0f);
  EXPECT_TRUE(std::isnan(multiScaleNormals(cloud)[0].normal_x));
  for (int i = 0; i < 100000; ++i) // in one place
    cloud.push_back(cloud[0]);
  EXPECT_TRUE(std::isnan(multiScaleNormals(cloud)[500].normal_x));
  Cloud line;
  for (int i = 0; i < 100; ++i)
    line.emplace_back(0.01f * static_cast<float>(i), 0.0f, 0.0f);
  for (const auto& normal : multiScaleNormals(line))
    EXPECT_TRUE(std::isnan(normal.curvature));
}

TEST(MultiScaleNormals, WrongOptionsAreRefused)
{
  const Cloud cloud(3, 1, pcl::PointXYZ(0, 0, 0));
  for (const double radius : {-1.0,
                              std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity()})
    EXPECT_THROW(multiScaleNormals(cloud, withRadius(radius, 3)),
                 pcl::BadArgumentException)
        << radius;
  for (const unsigned scales : {0u, 17u})
    EXPECT_THROW(multiScaleNormals(cloud, withRadius(1, scales)),
                 pcl::BadArgumentException)
        << scales;
}
