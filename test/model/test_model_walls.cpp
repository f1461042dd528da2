/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "model/simulated_walls.h"

#include <pcl/model/model_walls.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace pcl::indoor;

namespace {

/** The sides of rectangular rooms as they are, counter-clockwise. */
std::vector<WallFace>
exactFaces(const std::vector<Eigen::AlignedBox2d>& rooms)
{
  std::vector<WallFace> faces;
  for (const auto& box : rooms) {
    const Eigen::Vector2d low = box.min(), high = box.max();
    const Eigen::Vector2d corners[] = {
        low, {high.x(), low.y()}, high, {low.x(), high.y()}};
    for (std::size_t i = 0; i < 4; ++i) {
      WallFace face;
      face.room = static_cast<std::uint32_t>(1 + faces.size() / 4);
      face.begin = corners[i];
      face.end = corners[(i + 1) % 4];
      face.ceiling = 2.6;
      face.is_seen = true;
      faces.push_back(face);
    }
  }
  return faces;
}

const ModelWall*
wallOf(const std::vector<ModelWall>& walls, const std::vector<std::uint32_t>& rooms)
{
  for (const auto& wall : walls)
    if (wall.rooms == rooms)
      return &wall;
  return nullptr;
}

} // namespace

TEST(FacePairs, TwoSidesOfAWallFaceEachOther)
{
  const auto faces =
      exactFaces({rectangle(0.0, 0.0, 3.0, 4.0), rectangle(3.12, 1.0, 6.0, 5.0)});
  const auto pairs = facePairs(faces);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].face, 1u);
  EXPECT_EQ(pairs[0].other, 7u);
  EXPECT_NEAR(pairs[0].gap, 0.12, 1e-9);
  EXPECT_NEAR(pairs[0].from, 1.0, 1e-9);
  EXPECT_NEAR(pairs[0].to, 4.0, 1e-9);
  EXPECT_EQ(pairs[1].face, 7u);
  EXPECT_EQ(pairs[1].other, 1u);
}

TEST(FacePairs, SidesOfOneStoreyAloneOrTooFarApartHaveNone)
{
  auto faces =
      exactFaces({rectangle(0.0, 0.0, 3.0, 4.0), rectangle(3.8, 0.0, 6.0, 4.0)});
  EXPECT_TRUE(facePairs(faces).empty());
  faces = exactFaces({rectangle(0.0, 0.0, 3.0, 4.0), rectangle(3.1, 0.0, 6.0, 4.0)});
  for (std::size_t i = 4; i < 8; ++i) {
    faces[i].floor += 2.8;
    faces[i].ceiling += 2.8;
  }
  EXPECT_TRUE(facePairs(faces).empty());
}

TEST(ModelWalls, AWallBetweenTwoRoomsHasAnAxisAndAThickness)
{
  const auto faces =
      exactFaces({rectangle(0.0, 0.0, 3.0, 4.0), rectangle(3.12, 0.0, 6.0, 4.0)});
  const auto walls = modelWalls(faces, facePairs(faces));
  const auto* wall = wallOf(walls, {1, 2});
  ASSERT_NE(wall, nullptr);
  EXPECT_NEAR(wall->thickness, 0.12, 1e-9);
  EXPECT_NEAR(wall->begin.x(), 3.06, 1e-9);
  EXPECT_NEAR(wall->end.x(), 3.06, 1e-9);
  EXPECT_NEAR(std::abs(wall->end.y() - wall->begin.y()), 4.0, 1e-9);
  EXPECT_NEAR(wall->height, 2.6, 1e-9);
  // of the walls around them one side is known
  for (const auto& other : walls)
    if (&other != wall) {
      EXPECT_EQ(other.thickness, 0.0);
    }
}

TEST(ModelWalls, PiecesOnOneLineAreOneWall)
{
  const auto faces = exactFaces({rectangle(0.0, 0.0, 3.0, 4.0),
                                 rectangle(3.1, 0.0, 6.0, 4.0),
                                 rectangle(0.0, 4.2, 6.0, 8.0)});
  const auto walls = modelWalls(faces, facePairs(faces));
  const auto* wall = wallOf(walls, {1, 2, 3});
  ASSERT_NE(wall, nullptr);
  EXPECT_NEAR(wall->thickness, 0.2, 1e-9);
  EXPECT_NEAR((wall->end - wall->begin).norm(), 6.0, 1e-9);
  // what meets it ends on its axis
  const auto* inner = wallOf(walls, {1, 2});
  ASSERT_NE(inner, nullptr);
  EXPECT_NEAR(std::max(inner->begin.y(), inner->end.y()), 4.1, 1e-9);
}

TEST(ModelWalls, ARestOfASideIsPartOfALongerWallOnItsLine)
{
  // the first room is longer than the second one, behind which nothing was seen
  const auto faces =
      exactFaces({rectangle(0.0, 0.0, 3.0, 4.0), rectangle(3.12, 0.0, 6.0, 2.6)});
  const auto walls = modelWalls(faces, facePairs(faces));
  const auto* wall = wallOf(walls, {1, 2});
  ASSERT_NE(wall, nullptr);
  EXPECT_NEAR(wall->thickness, 0.12, 1e-9);
  EXPECT_NEAR((wall->end - wall->begin).norm(), 4.0, 1e-9);
  EXPECT_NEAR(wall->begin.x(), 3.06, 1e-9);
}

TEST(ModelWalls, ARestThatIsLongerThanWhatWasSeenFromBothSidesIsAWallOfItsOwn)
{
  const auto faces =
      exactFaces({rectangle(0.0, 0.0, 3.0, 4.0), rectangle(3.12, 0.0, 6.0, 1.5)});
  const auto walls = modelWalls(faces, facePairs(faces));
  double thick = 0.0, rest = 0.0;
  for (const auto& wall : walls) {
    if (wall.thickness > 0.0)
      thick += (wall.end - wall.begin).norm();
    else if (wall.rooms == std::vector<std::uint32_t>{1} &&
             std::min(wall.begin.x(), wall.end.x()) > 2.9)
      rest += (wall.end - wall.begin).norm();
  }
  EXPECT_NEAR(thick, 1.5, 1e-9);
  EXPECT_NEAR(rest, 2.5, 1e-9);
}

TEST(ModelWalls, AWallGoesOnToHalfOfTheDepthOfWindowsInTheOneThatItMeets)
{
  const auto faces =
      exactFaces({rectangle(0.0, 0.0, 3.0, 4.0), rectangle(3.12, 0.0, 6.0, 4.0)});
  std::vector<double> depths(faces.size(), 0.0);
  const auto ends = [&] {
    const auto walls = modelWalls(faces, facePairs(faces), depths);
    const auto* wall = wallOf(walls, {1, 2});
    return wall ? std::pair(std::min(wall->begin.y(), wall->end.y()),
                            std::max(wall->begin.y(), wall->end.y()))
                : std::pair<double, double>(NAN, NAN);
  };
  EXPECT_NEAR(ends().first, 0.0, 1e-9);
  EXPECT_NEAR(ends().second, 4.0, 1e-9);
  depths[0] = 0.2; // the lower side of the first room
  EXPECT_NEAR(ends().first, -0.1, 1e-9);
  EXPECT_NEAR(ends().second, 4.1, 1e-9) << "the middle of the storey";
  depths[2] = 0.3; // its upper side
  EXPECT_NEAR(ends().second, 4.15, 1e-9);
}

TEST(ModelWalls, OneSideEndsOnTheSideOfTheWallThatItMeets)
{
  const auto faces =
      exactFaces({rectangle(0.0, 0.0, 3.0, 4.0), rectangle(3.12, 0.0, 6.0, 2.6)});
  const auto walls = modelWalls(faces, facePairs(faces));
  const ModelWall* upper = nullptr; // of the second room
  for (const auto& wall : walls)
    if (wall.rooms == std::vector<std::uint32_t>{2} &&
        std::min(wall.begin.y(), wall.end.y()) > 2.5)
      upper = &wall;
  ASSERT_NE(upper, nullptr);
  EXPECT_NEAR(upper->end.x(), 3.12, 1e-9); // not on the axis, 3.06
  EXPECT_NEAR(upper->begin.x(), 6.0, 1e-9);
}

TEST(ModelWalls, TheLineOfAWallIsThatOfAllItsPieces)
{
  auto faces = exactFaces({rectangle(0.0, 0.0, 5.8, 3.0),
                           rectangle(5.9, 0.0, 12.0, 3.0),
                           rectangle(0.0, 3.2, 5.8, 6.0),
                           rectangle(5.9, 3.2, 12.0, 6.0)});
  // both sides of the longer piece are turned by half a degree
  faces[6].begin.y() += 0.06;
  faces[12].end.y() += 0.06;
  const auto walls = modelWalls(faces, facePairs(faces));
  const auto* wall = wallOf(walls, {1, 2, 3, 4});
  ASSERT_NE(wall, nullptr);
  const bool is_turned = wall->begin.x() > wall->end.x();
  const auto& left = is_turned ? wall->end : wall->begin;
  const auto& right = is_turned ? wall->begin : wall->end;
  // 1 cm off, not 4, as the line of the longer piece is
  EXPECT_NEAR(left.y(), 3.1, 0.02);
  EXPECT_NEAR(right.y(), 3.16, 0.02);
  EXPECT_NEAR(right.x() - left.x(), 12.0, 0.01);
}

TEST(ModelWalls, WithoutSidesThereAreNone)
{
  EXPECT_TRUE(facePairs({}).empty());
  EXPECT_TRUE(modelWalls({}, {}).empty());
}
