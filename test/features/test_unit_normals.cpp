/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/unit_normals.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <random>

using namespace pcl::indoor;

namespace {

using Vectors = std::vector<Eigen::Vector3f>;

struct RoomPoints {
  Vectors points, normals;
};

/** The six sides of an empty room of 5 x 4 x 2.5 m, with 3 mm of noise. */
RoomPoints
emptyRoom(std::size_t count, std::uint32_t seed = 1)
{
  std::mt19937 rng(seed);
  std::uniform_real_distribution<float> share(0.0f, 1.0f);
  std::normal_distribution<float> noise(0.0f, 0.003f);
  const Eigen::Vector3f size(5, 4, 2.5f);
  RoomPoints room;
  for (std::size_t i = 0; i < count; ++i) {
    const int axis = static_cast<int>(i % 3);
    const bool far = i % 2 == 0;
    Eigen::Vector3f place(share(rng), share(rng), share(rng));
    place[axis] = far ? 1.0f : 0.0f;
    place = place.cwiseProduct(size);
    place[axis] += noise(rng);
    room.points.push_back(place);
    room.normals.push_back((far ? -1.0f : 1.0f) * Eigen::Vector3f::Unit(axis));
  }
  return room;
}

Vectors
replaced(Vectors normals, std::size_t stride, const Eigen::Vector3f& by)
{
  for (std::size_t i = 0; i < normals.size(); i += stride)
    normals[i] = by;
  return normals;
}

} // namespace

TEST(UnitNormals, AreNearlyAllOfLengthOne)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto room = emptyRoom(3000);
  EXPECT_TRUE(areUnitNormals({}));
  EXPECT_TRUE(areUnitNormals(room.normals));
  for (const Eigen::Vector3f& none :
       {Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(nan, nan, nan)}) {
    EXPECT_TRUE(areUnitNormals(replaced(room.normals, 50, none)));
    EXPECT_FALSE(areUnitNormals(replaced(room.normals, 10, none)));
    EXPECT_FALSE(areUnitNormals(replaced(room.normals, 1, none)));
  }
}

TEST(NormalsProblem, ThoseOfThePointsHaveNone)
{
  for (const std::size_t count : {1, 10, 300, 20000, 300000}) {
    const auto room = emptyRoom(count);
    EXPECT_EQ(findNormalsProblem(room.points, room.normals), "") << count;
    const auto inward = replaced(room.normals, 30, Eigen::Vector3f::Zero());
    if (count > 100) {
      EXPECT_EQ(findNormalsProblem(room.points, inward), "") << count;
    }
  }
  EXPECT_EQ(findNormalsProblem({}, {}), "");
  EXPECT_EQ(findNormalsProblem(emptyRoom(10).points, {}), "");
}

TEST(NormalsProblem, ASingleWallMayHaveTheSameEverywhere)
{
  auto room = emptyRoom(30000);
  RoomPoints wall;
  for (std::size_t i = 0; i < room.points.size(); i += 6) {
    wall.points.push_back(room.points[i]);
    wall.normals.push_back(room.normals[i]);
  }
  EXPECT_EQ(findNormalsProblem(wall.points, wall.normals), "");
}

TEST(NormalsProblem, ColoursZerosAndNormalsOfOtherFramesAreNone)
{
  for (const std::size_t count : {20000, 300000}) {
    const auto room = emptyRoom(count);
    const auto problem = [&](const Vectors& normals) {
      return findNormalsProblem(room.points, normals);
    };
    const auto number = std::to_string(count);
    EXPECT_EQ(problem(Vectors(count, Eigen::Vector3f::Zero())),
              "0 of " + number + " have length 1");
    EXPECT_EQ(problem(replaced(room.normals, 2, Eigen::Vector3f::Zero())),
              std::to_string(count / 2) + " of " + number + " have length 1");
    EXPECT_NE(problem(Vectors(count, Eigen::Vector3f(0.5f, 0.6f, 0.4f))), "");
    EXPECT_NE(problem(Vectors(count, Eigen::Vector3f::UnitZ())), "");
    auto turned = room.normals, shuffled = room.normals;
    const Eigen::AngleAxisf turn(1.0f, Eigen::Vector3f(1, 2, 3).normalized());
    for (auto& normal : turned)
      normal = turn * normal;
    EXPECT_NE(problem(turned), "");
    std::rotate(shuffled.begin(), shuffled.begin() + 1, shuffled.end());
    EXPECT_NE(problem(shuffled), "");
  }
}
