/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/room_preparation.h"
#include "support/labelled_points.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

using Flags = std::vector<std::uint8_t>;

/** A closed room with a box in it. */
test::LabelledPoints
closedRoom()
{
  std::mt19937 rng(1);
  test::LabelledPoints scene;
  scene.addBox({0, 0, 0}, {4, 3, 2.5f}, 1, 0.03f, 0.003f, rng);
  for (auto& normal : scene.normals)
    normal = -normal;
  scene.addBox({1.5f, 1, 0.01f}, {0.8f, 0.6f, 0.7f}, 2, 0.03f, 0.003f, rng);
  return scene;
}

/** A floor with two boxes, and points in the air above it. */
class PreparedRoom : public ::testing::Test {
protected:
  RoomPoints
  room(bool with_strays, const Eigen::Vector3f& by = Eigen::Vector3f::Zero()) const
  {
    RoomPoints points;
    for (const auto& position : scene_.points)
      points.positions.push_back(position + by);
    for (int i = 0; with_strays && i < strays_; ++i)
      points.positions.push_back(
          by + Eigen::Vector3f(0.4f * static_cast<float>(i), 1, 1.5f + 0.1f * (i % 3)));
    return points;
  }

  /** Share of the normals that point to the side they should. */
  double
  shareOfRight(const RoomPoints& points) const
  {
    std::size_t right = 0;
    for (std::size_t i = 0; i < scene_.points.size(); ++i)
      right += points.normals[i].dot(scene_.normals[i]) > 0.5f;
    return static_cast<double>(right) / static_cast<double>(scene_.points.size());
  }

  static constexpr int strays_ = 9;
  test::LabelledPoints scene_ = test::floorWithTwoBoxes(0.003f, 0.025f);
};

} // namespace

TEST_F(PreparedRoom, IsLeftAsItIsUnlessAskedFor)
{
  auto points = room(true);
  EXPECT_TRUE(prepareRoom({}, points).empty());
  EXPECT_EQ(points.positions, room(true).positions);
  EXPECT_TRUE(points.normals.empty());
}

TEST_F(PreparedRoom, OutliersAreTakenOutAndHaveNoObject)
{
  auto points = room(true);
  points.given.resize(points.positions.size());
  std::iota(points.given.begin(), points.given.end(), 1);
  const auto removed = prepareRoom({true, "voxels"}, points);
  ASSERT_EQ(removed.size(), scene_.points.size() + strays_);
  for (std::size_t i = 0; i < removed.size(); ++i)
    EXPECT_EQ(removed[i] != 0, i >= scene_.points.size()) << i;
  EXPECT_EQ(points.positions, scene_.points);
  EXPECT_TRUE(points.normals.empty());

  RoomObjects objects;
  objects.object_of_point = points.given;
  objects.structure_of_point.assign(points.given.size(), 2);
  putBack(removed, objects);
  ASSERT_EQ(objects.object_of_point.size(), removed.size());
  ASSERT_EQ(objects.structure_of_point.size(), removed.size());
  for (std::size_t i = 0; i < removed.size(); ++i) {
    EXPECT_EQ(objects.object_of_point[i], removed[i] ? 0u : i + 1);
    EXPECT_EQ(objects.structure_of_point[i], removed[i] ? 0u : 2u);
  }
}

TEST_F(PreparedRoom, NormalsFaceTheFreeSpace)
{
  scene_ = closedRoom();
  for (const std::string method : {"rrht", "multi_scale"}) {
    auto points = room(false);
    prepareRoom({false, method}, points);
    ASSERT_EQ(points.normals.size(), scene_.points.size()) << method;
    for (const auto& normal : points.normals)
      ASSERT_NEAR(normal.norm(), 1, 1e-4f) << method;
    EXPECT_GT(shareOfRight(points), 0.9) << method;
  }
}

TEST_F(PreparedRoom, NormalsAreTheSameFarFromTheOrigin)
{
  for (auto& position : scene_.points) // so that the shift loses nothing
    position = (256 * position.array()).round() / 256;
  for (const std::string method : {"rrht", "multi_scale"}) {
    auto near = room(false), far = room(false, {16384, -8192, 512});
    prepareRoom({false, method}, near);
    prepareRoom({false, method}, far);
    EXPECT_EQ(near.normals, far.normals) << method;
  }
}

TEST_F(PreparedRoom, NormalsThatAreThereStay)
{
  auto points = room(false);
  points.normals.assign(points.positions.size(), Eigen::Vector3f::UnitX());
  EXPECT_TRUE(prepareRoom({false, "rrht"}, points).empty());
  EXPECT_EQ(
      points.normals,
      std::vector<Eigen::Vector3f>(scene_.points.size(), Eigen::Vector3f::UnitX()));
}

TEST(PreparedRooms, MayHaveHardlyAnyPoints)
{
  for (const std::string method : {"voxels", "rrht", "multi_scale"})
    for (const std::size_t count : {0, 1, 2, 3, 1000}) {
      RoomPoints points;
      points.positions.assign(count, Eigen::Vector3f(1, 2, 3));
      const auto removed = prepareRoom({true, method}, points);
      EXPECT_EQ(removed.size(), count);
      EXPECT_EQ(points.positions.size() + static_cast<std::size_t>(std::accumulate(
                                              removed.begin(), removed.end(), 0)),
                count);
      EXPECT_TRUE(points.normals.empty() ||
                  points.normals.size() == points.positions.size());
      auto objects = segmentRoomObjects(points);
      putBack(removed, objects);
      EXPECT_EQ(objects.object_of_point.size(), count);
    }
}
