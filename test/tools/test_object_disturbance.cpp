/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "object_disturbance.h"

#include <gtest/gtest.h>

#include <cmath>

using pcl::PointCloud;
using pcl::PointNormal;
using pcl::indoor::tool::disturb;
using pcl::indoor::tool::Disturbance;
using pcl::indoor::tool::neighborsUnderNoise;

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
