/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/split/laden_top.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace pcl::indoor;

namespace {

using Points = std::vector<Eigen::Vector3f>;

const Eigen::Vector3f z = Eigen::Vector3f::UnitZ();

/** Points of a level rectangle, one per centimetre, with 2 mm of noise. */
void
addLevel(const Eigen::Vector3f& corner, float width, float depth, Points& points)
{
  std::mt19937 rng(static_cast<std::uint32_t>(points.size()));
  std::normal_distribution<float> noise(0, 0.002f);
  for (float x = 0; x < width; x += 0.01f)
    for (float y = 0; y < depth; y += 0.01f)
      points.push_back(corner + Eigen::Vector3f(x, y, noise(rng)));
}

/** A table's top 0.7 m high, with the tops of four boxes that stand on it. */
Points
ladenTable(float width, float depth, float height_of_boxes)
{
  Points points;
  addLevel({0, 0, 0.7f}, width, depth, points);
  for (int box = 0; box < 4; ++box)
    addLevel({0.1f + 0.2f * static_cast<float>(box), 0.1f, 0.7f + height_of_boxes},
             0.1f,
             0.1f,
             points);
  return points;
}

} // namespace

TEST(LadenTop, IsTheLevelThatCoversMost)
{
  const auto top = ladenTop(ladenTable(1.2f, 0.6f, 0.2f), z);
  ASSERT_TRUE(top);
  EXPECT_LT(top->lower, 0.7f);
  EXPECT_GT(top->upper, 0.7f);
  EXPECT_LT(top->upper - top->lower, 0.03f);
}

TEST(LadenTop, TurnsWithTheDirectionUp)
{
  const Eigen::Quaternionf turn =
      Eigen::Quaternionf(0.3f, -0.5f, 0.7f, 0.2f).normalized();
  auto points = ladenTable(1.0f, 0.6f, 0.2f);
  for (auto& point : points)
    point = turn * point;
  const auto top = ladenTop(points, turn * z);
  ASSERT_TRUE(top);
  EXPECT_NEAR(top->lower, 0.69f, 0.011f);
}

TEST(LadenTop, SizesOfTablesTell)
{
  EXPECT_FALSE(ladenTop(ladenTable(1.7f, 0.6f, 0.2f), z)) << "a bed, a counter";
  EXPECT_FALSE(ladenTop(ladenTable(1.0f, 0.25f, 0.2f), z)) << "a board on the wall";
  EXPECT_FALSE(ladenTop(ladenTable(1.0f, 0.6f, 0.55f), z)) << "a cabinet's inside";
  EXPECT_FALSE(ladenTop({}, z));
}

TEST(LadenTop, AnEmptyTableHasNothingOnIt)
{
  Points points;
  addLevel({0, 0, 0.7f}, 1, 0.6f, points);
  EXPECT_FALSE(ladenTop(points, z));
}

TEST(LadenTop, LeavesHaveNoLevel)
{
  std::mt19937 rng(1);
  std::uniform_real_distribution<float> place(-0.4f, 0.4f);
  Points points;
  while (points.size() < 20000)
    if (const Eigen::Vector3f point(place(rng), place(rng), place(rng) / 2);
        point.norm() < 0.4f)
      points.push_back(point);
  EXPECT_FALSE(ladenTop(points, z));
}

TEST(LadenTop, HeightsInWholeCentimetresAreNoHarm)
{
  for (int height = -80; height <= 80; ++height) {
    auto points = ladenTable(1.0f, 0.6f, 0.2f);
    for (auto& point : points)
      point.z() = std::round(100 * point.z() + static_cast<float>(height)) / 100;
    EXPECT_TRUE(ladenTop(points, z)) << height;
  }
}
