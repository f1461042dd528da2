/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/object_segmentation.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <random>

using namespace pcl::indoor;

namespace {

using Points = std::vector<Eigen::Vector3f>;

/** Points within a box that stands on z = 0, its base and its top seen. */
Points
boxOf(const Eigen::Vector3f& sizes, std::size_t count, std::uint32_t seed)
{
  std::mt19937 rng(seed);
  std::uniform_real_distribution<float> share(0, 1);
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.emplace_back(
        share(rng) * sizes.x(), share(rng) * sizes.y(), i % 2 == 0 ? 0 : sizes.z());
  return points;
}

const Eigen::Vector3f z = Eigen::Vector3f::UnitZ();

} // namespace

TEST(TableTop, SizesTell)
{
  EXPECT_TRUE(isTableTop(boxOf({1.2f, 0.8f, 0.3f}, 20000, 1), z));
  EXPECT_TRUE(isTableTop(boxOf({1.5f, 1.5f, 0.69f}, 40000, 2), z));
  EXPECT_FALSE(isTableTop(boxOf({0.5f, 0.5f, 0.8f}, 20000, 3), z)) << "a chair";
  EXPECT_FALSE(isTableTop(boxOf({2.0f, 1.6f, 0.5f}, 80000, 4), z)) << "a bed";
  EXPECT_FALSE(isTableTop(boxOf({1.6f, 2.0f, 0.5f}, 80000, 4), z)) << "a bed, turned";
}

TEST(TableTop, TurnsWithTheDirectionUp)
{
  const Eigen::Quaternionf turn =
      Eigen::Quaternionf(0.3f, -0.5f, 0.7f, 0.2f).normalized();
  for (const float height : {0.5f, 1.0f}) {
    auto points = boxOf({1.0f, 1.0f, height}, 20000, 5);
    for (auto& point : points)
      point = turn * point;
    EXPECT_EQ(isTableTop(points, turn * z), height < 0.7f);
  }
}

TEST(TableTop, AFewStraysDoNotCount)
{
  auto points = boxOf({1.2f, 0.8f, 0.3f}, 20000, 6);
  for (std::size_t i = 0; i < points.size(); i += 200)
    points[i] += Eigen::Vector3f(3, -4, 5);
  EXPECT_TRUE(isTableTop(points, z));
}

TEST(TableTop, FewOrSparsePointsDoNotTell)
{
  EXPECT_FALSE(isTableTop({}, z));
  EXPECT_FALSE(isTableTop(boxOf({0.1f, 0.1f, 0.1f}, 999, 7), z));
  EXPECT_TRUE(isTableTop(boxOf({0.1f, 0.1f, 0.1f}, 1000, 7), z));
  EXPECT_FALSE(isTableTop(boxOf({1.4f, 1.4f, 0.3f}, 1000, 8), z));
}
