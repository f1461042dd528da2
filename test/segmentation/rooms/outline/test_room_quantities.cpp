/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

// Areas, heights and door widths of rooms that are known exactly.

#include "support/room_labels.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor::test;
using Segmentation = pcl::RoomSegmentation<pcl::PointXYZ>;

namespace {

constexpr float spacing = 0.03f, noise = 0.02f;

struct TwoRooms {
  float floor = 0.0f, ceiling = 2.57f;
  float thickness = 0.2f; ///< of the wall between them
  float width = 0.86f;    ///< of the door
  LabelledPoints points;
  std::mt19937 rng{3};

  void
  add(const Eigen::Vector3f& corner,
      const Eigen::Vector3f& u,
      const Eigen::Vector3f& v,
      const Eigen::Vector3f& normal)
  {
    points.addRectangle(corner, u, v, normal, 1, spacing, noise, rng);
  }

  /** Rooms of 4.13 m x 3.04 m and 3.27 m x 3.04 m with a door that has posts and a
   * lintel. */
  void
  build()
  {
    const float x = 4.13f, end = x + thickness + 3.27f, y = 1.1f, head = floor + 2.03f;
    points = rooms({{{0, 0, floor}, {x, 3.04f, ceiling}, 1},
                    {{x + thickness, 0, floor}, {end, 3.04f, ceiling}, 2}},
                   {{Eigen::Vector3f(x - 0.06f, y, floor + 0.05f),
                     Eigen::Vector3f(x + thickness + 0.06f, y + width, head)}},
                   spacing,
                   noise);
    add({x, y, floor}, {thickness, 0, 0}, {0, 0, 2.03f}, {0, 1, 0});
    add({x, y + width, floor}, {thickness, 0, 0}, {0, 0, 2.03f}, {0, 1, 0});
    add({x, y, head}, {thickness, 0, 0}, {0, width, 0}, {0, 0, 1});
    add({x, y, floor}, {thickness, 0, 0}, {0, width, 0}, {0, 0, 1});
  }

  Segmentation
  segmented(float degrees) const
  {
    const float angle = degrees * static_cast<float>(M_PI) / 180.0f;
    const Eigen::Matrix3f turn =
        Eigen::AngleAxisf(angle, Eigen::Vector3f::UnitZ()).toRotationMatrix();
    auto turned = points.points;
    for (auto& point : turned)
      point = turn * point + Eigen::Vector3f(0.37f, -1.21f, 0.043f);
    Segmentation result;
    result.setInputCloud(cloudOf(turned));
    Labels labels;
    result.segment(labels);
    return result;
  }

  void
  expectExact(const Segmentation& result) const
  {
    ASSERT_EQ(result.getRooms().size(), 2u);
    double areas[2] = {result.getRooms()[0].area, result.getRooms()[1].area};
    if (areas[0] < areas[1])
      std::swap(areas[0], areas[1]);
    EXPECT_NEAR(areas[0], 4.13 * 3.04, 0.01 * areas[0]);
    EXPECT_NEAR(areas[1], 3.27 * 3.04, 0.01 * areas[1]);
    for (const auto& room : result.getRooms()) {
      EXPECT_NEAR(room.height, ceiling - floor, 0.01);
      EXPECT_NEAR(room.volume, room.area * room.height, 1e-9);
      for (const auto& corner : room.footprint.at(0))
        EXPECT_NEAR(corner.z(), floor + 0.043, 0.01);
    }
    ASSERT_EQ(result.getOpenings().size(), 1u);
    EXPECT_NEAR(result.getOpenings()[0].width, width, 0.02);
  }
};

} // namespace

TEST(RoomQuantities, AreExactWhereverTheGridLies)
{
  for (const float degrees : {0.0f, 17.0f, 45.0f, 71.0f})
    for (const float shift : {0.0f, 0.05f}) {
      SCOPED_TRACE(degrees);
      TwoRooms scene;
      scene.ceiling += shift;
      scene.width += shift;
      scene.build();
      scene.expectExact(scene.segmented(degrees));
    }
}

TEST(RoomQuantities, FurnitureChangesNothing)
{
  TwoRooms scene;
  scene.build();
  auto& points = scene.points;
  const auto box = [&](const Eigen::Vector3f& corner, const Eigen::Vector3f& size) {
    points.addBox(corner, size, 1, spacing, noise, scene.rng);
  };
  box({0.02f, 0.5f, 0}, {1.9f, 2.0f, 0.5f});       // a bed
  box({0.02f, 2.68f, 1.4f}, {1.5f, 0.35f, 0.95f}); // a cupboard in a corner
  box({6.0f, 0.02f, 1.4f}, {0.8f, 0.35f, 0.95f});  // one on a wall
  box({2.5f, 1.2f, 2.1f}, {0.5f, 0.5f, 0.3f});     // a lamp
  box({5.0f, 2.5f, 0.0f}, {1.2f, 0.5f, 1.8f});     // a bookcase
  for (const float degrees : {0.0f, 28.0f}) {
    SCOPED_TRACE(degrees);
    scene.expectExact(scene.segmented(degrees));
  }
}

TEST(RoomQuantities, ALeafThatStandsOpenDoesNotNarrowTheDoor)
{
  for (const float degrees : {0.0f, 33.0f}) {
    TwoRooms scene;
    scene.build();
    // at right angles to the wall, its hinge at the post, 6 cm thick
    scene.points.addBox(
        {4.13f - 0.8f, 1.1f, 0.01f}, {0.8f, 0.06f, 2.0f}, 1, spacing, noise, scene.rng);
    scene.expectExact(scene.segmented(degrees));
  }
}

TEST(RoomQuantities, AThinWallAndAThinCeilingSeenFromAboveDoNotMatter)
{
  TwoRooms scene;
  scene.thickness = 0.1f;
  scene.build();
  for (const float x : {0.0f, 4.23f}) // the upper side of the ceiling
    scene.add({x, 0, 2.69f}, {x > 0 ? 3.27f : 4.13f, 0, 0}, {0, 3.04f, 0}, {0, 0, 1});
  scene.expectExact(scene.segmented(0.0f));
}

TEST(RoomQuantities, ASlopedCeilingIsAsHighAsItsMiddle)
{
  TwoRooms scene;
  scene.build();
  scene.points.removeIf([](const auto& point) { return point.z() > 2.5f; });
  for (auto& point : scene.points.points) // the walls follow
    if (point.z() > 2.1f)
      point.z() = 2.1f + (point.z() - 2.1f) * (2.57f + 0.1f * point.x() - 2.1f) / 0.4f;
  scene.add({0, 0, 2.57f}, {7.6f, 0, 0.76f}, {0, 3.04f, 0}, {0, 0, 1});
  const auto result = scene.segmented(0.0f);
  ASSERT_EQ(result.getRooms().size(), 2u);
  for (const auto& room : result.getRooms()) {
    const bool is_first = room.centroid.x() < 4.5;
    EXPECT_NEAR(room.height, 2.57 + 0.1 * (is_first ? 2.065 : 5.965), 0.03);
  }
}
