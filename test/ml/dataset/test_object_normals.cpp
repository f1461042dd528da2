/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/object_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using pcl::PointCloud;
using pcl::PointNormal;
using namespace pcl::indoor::tool;

namespace {

/** Points drawn on the cube from -1 to 1, far from the origin, with the faces' normals.
 */
PointCloud<PointNormal>
cube(std::size_t count)
{
  std::mt19937 rng(7);
  std::uniform_real_distribution<float> place(-1, 1);
  PointCloud<PointNormal> points;
  for (std::size_t k = 0; k < count; ++k) {
    const auto axis = static_cast<Eigen::Index>(k % 3);
    const float side = k % 2 == 0 ? 1.0f : -1.0f;
    Eigen::Vector3f position(place(rng), place(rng), place(rng));
    position[axis] = side;
    PointNormal point;
    point.getVector3fMap() = position + Eigen::Vector3f(30, -20, 10);
    point.getNormalVector3fMap() = side * Eigen::Vector3f::Unit(axis);
    points.push_back(point);
  }
  return points;
}

/** How many normals are within 5 degrees of the inner side of their face. */
double
shareOfRight(const PointCloud<PointNormal>& found, const PointCloud<PointNormal>& truth)
{
  double right = 0;
  for (std::size_t k = 0; k < truth.size(); ++k)
    right += found[k].getNormalVector3fMap().dot(truth[k].getNormalVector3fMap()) <
             -std::cos(5 * M_PI / 180);
  return right / static_cast<double>(truth.size());
}

} // namespace

TEST(ObjectNormals, HoughNormalsStaySharpWherePlanesAreBlurred)
{
  const auto truth = cube(2048);
  auto planes = truth, hough = truth;
  for (auto* cloud : {&planes, &hough})
    for (auto& point : *cloud)
      point.getNormalVector3fMap().setZero();
  estimateNormals(planes, 30);
  estimateHoughNormals(hough);
  EXPECT_LT(shareOfRight(planes, truth), 0.75); // within a neighbourhood of edges
  EXPECT_GT(shareOfRight(hough, truth), 0.95);
}

TEST(ObjectNormals, PointsWithoutAPlaneHaveNone)
{
  auto points = cube(500);
  points[3].x = std::numeric_limits<float>::quiet_NaN();
  points.is_dense = false;
  estimateHoughNormals(points);
  EXPECT_TRUE(std::isnan(points[3].normal_x));
  PointCloud<PointNormal> two;
  two.resize(2);
  two[1].x = 1;
  estimateHoughNormals(two);
  EXPECT_TRUE(std::isnan(two[0].normal_x));
}
