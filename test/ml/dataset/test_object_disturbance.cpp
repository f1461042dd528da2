/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/object_disturbance.h"

#include <gtest/gtest.h>

#include <cmath>

using pcl::PointCloud;
using pcl::PointNormal;
using pcl::indoor::tool::disturb;
using pcl::indoor::tool::Disturbance;
using pcl::indoor::tool::hideFromView;
using pcl::indoor::tool::neighborsUnderNoise;
using pcl::indoor::tool::placeBeforeCamera;

namespace {

/** A square plate of 1 m, 32 x 32 points, whose normals are wrong: along x. */
PointCloud<PointNormal>
plateWithWrongNormals()
{
  PointCloud<PointNormal> plate;
  for (int row = 0; row < 32; ++row)
    for (int column = 0; column < 32; ++column) {
      PointNormal point;
      point.x = static_cast<float>(column) / 31.0f;
      point.y = static_cast<float>(row) / 31.0f;
      point.z = 0.0f;
      point.normal_x = 1.0f;
      plate.push_back(point);
    }
  return plate;
}

/** Mean of the normals' part along z, 1 where all are the plate's. */
double
meanUprightness(const PointCloud<PointNormal>& plate)
{
  double sum = 0.0;
  for (const auto& point : plate)
    sum += std::abs(point.normal_z);
  return sum / static_cast<double>(plate.size());
}

/** Points of a sphere of radius 1 around (5, -3, 2), with outward normals. */
PointCloud<PointNormal>
sphere()
{
  constexpr int count = 4000;
  PointCloud<PointNormal> points;
  for (int k = 0; k < count; ++k) { // a spiral of equal steps in height
    const double height = (2.0 * k + 1.0) / count - 1.0;
    const double radius = std::sqrt(1.0 - height * height);
    PointNormal point;
    point.normal_x = static_cast<float>(radius * std::cos(2.399963 * k));
    point.normal_y = static_cast<float>(radius * std::sin(2.399963 * k));
    point.normal_z = static_cast<float>(height);
    point.x = 5.0f + point.normal_x;
    point.y = -3.0f + point.normal_y;
    point.z = 2.0f + point.normal_z;
    points.push_back(point);
  }
  return points;
}

} // namespace

TEST(ObjectDisturbance, NeighborsCoverTheRadiusInDeviationsOfNoise)
{
  Disturbance disturbance;
  disturbance.normal_radius = 4.0;
  disturbance.noise_percent = 10.0;
  // A disc of radius 0.4 is 0.5027 of a surface of 3: 0.16755 of all points.
  EXPECT_EQ(neighborsUnderNoise(disturbance, 2048, 20), 343);
  EXPECT_EQ(neighborsUnderNoise(disturbance, 2048, 500), 500);
  disturbance.noise_percent = 0.0;
  EXPECT_EQ(neighborsUnderNoise(disturbance, 2048, 20), 20);
  disturbance.noise_percent = 100.0;
  EXPECT_EQ(neighborsUnderNoise(disturbance, 2048, 20), 2048);
}

TEST(ObjectDisturbance, NormalsStayAsGivenUnlessAskedFor)
{
  auto plate = plateWithWrongNormals();
  Disturbance disturbance;
  disturb(plate, disturbance, 20, 1);
  EXPECT_EQ(meanUprightness(plate), 0.0);
  disturbance.estimates_normals = true;
  disturb(plate, disturbance, 20, 1);
  EXPECT_NEAR(meanUprightness(plate), 1.0, 1e-5);
  EXPECT_EQ(plate[33].z, 0.0f) << "no noise, no movement";
}

TEST(ObjectDisturbance, WideNeighborhoodsKeepNormalsUnderNoise)
{
  Disturbance disturbance;
  disturbance.noise_percent = 6.0;
  auto wide = plateWithWrongNormals();
  disturb(wide, disturbance, 20, 1);
  disturbance.normal_radius = 0.0; // 20 neighbours: within 1.3 deviations
  auto narrow = plateWithWrongNormals();
  disturb(narrow, disturbance, 20, 1);
  EXPECT_GT(meanUprightness(wide), 0.9);
  EXPECT_LT(meanUprightness(narrow), 0.75);
}

TEST(ObjectDisturbance, CameraLooksAlongZAtTheSideThatItSees)
{
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    auto seen = sphere();
    hideFromView(seen, 50.0, seed);
    placeBeforeCamera(seen, seed);
    ASSERT_EQ(seen.size(), 2000u);
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& point : seen) {
      normal += point.getNormalVector3fMap().cast<double>() / 2000.0;
      middle += point.getVector3fMap().cast<double>() / 2000.0;
    }
    // A half sphere's normals have the mean 1 / 2. Pixels of 2 * 2 / sqrt(4000) = 0.06
    // hide a little of what is this near to its edge, and show as much beyond it.
    EXPECT_LT((normal - Eigen::Vector3d(0.0, 0.0, -0.5)).norm(), 0.07);
    EXPECT_NEAR(middle.x(), 0.0, 1e-4);
    EXPECT_NEAR(middle.y(), 0.0, 1e-4);
    EXPECT_NEAR(middle.z(), 3.0 * 2.0, 0.01); // of an extent of 2
  }
}

TEST(ObjectDisturbance, CameraTellsNothingOfThePoseInTheFile)
{
  // A direction of the plate, of 64 views: random ones have a mean of 1 / sqrt(64) and
  // a mean square along z of 1 / 3, with a deviation of sqrt(4 / 45 / 64) = 0.037.
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float along_view = 0.0f;
  for (std::uint32_t seed = 0; seed < 64; ++seed) {
    auto plate = plateWithWrongNormals();
    const auto before = plate;
    placeBeforeCamera(plate, seed);
    sum += plate[0].getNormalVector3fMap() / 64.0f;
    along_view += plate[0].normal_z * plate[0].normal_z / 64.0f;
    EXPECT_NEAR((plate[0].getVector3fMap() - plate[700].getVector3fMap()).norm(),
                (before[0].getVector3fMap() - before[700].getVector3fMap()).norm(),
                1e-5);
    const Eigen::Vector3f side = plate[31].getVector3fMap() - plate[0].getVector3fMap();
    EXPECT_NEAR(side.dot(plate[0].getNormalVector3fMap()), 1.0f, 1e-5)
        << "the normal turns with the points";
  }
  EXPECT_LT(sum.norm(), 3.0f / 8.0f);
  EXPECT_NEAR(along_view, 1.0f / 3.0f, 4 * 0.037f);
}
