/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "model/simulated_walls.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor;

namespace {

WallCell
cellAt(const WallImage& image, double along, double height)
{
  return image.cells.at(static_cast<int>(along / image.cell),
                        static_cast<int>((height - image.floor) / image.cell));
}

} // namespace

TEST(WallImage, ShowsFaceRecessLeafObjectAndNothing)
{
  auto points = simulatedSide(4.0,
                              2.5,
                              {{rectangle(0.5, 1.0, 1.0, 1.5), -0.1},
                               {rectangle(1.5, 1.0, 2.0, 1.5), 0.05},
                               {rectangle(2.5, 1.0, 3.0, 1.5), 0.0},
                               {rectangle(3.2, 1.0, 3.7, 1.5), 0.4}});
  for (auto& point : points)
    point.height += 3.0f; // the floor is not at 0
  const auto image = wallImage(points, 4.0, 3.0, 2.5);
  EXPECT_DOUBLE_EQ(image.cell, 0.02);
  EXPECT_EQ(cellAt(image, 0.25, 4.25), WallCell::Face);
  EXPECT_EQ(cellAt(image, 0.75, 4.25), WallCell::Recess);
  EXPECT_EQ(cellAt(image, 1.75, 4.25), WallCell::Proud);
  EXPECT_EQ(cellAt(image, 2.75, 4.25), WallCell::Empty);
  EXPECT_EQ(cellAt(image, 3.45, 4.25), WallCell::Front);
  // medians move edges by no more than the spacing: 2.5 cm on 50 cm, on each side
  EXPECT_NEAR(
      image.share(rectangle(0.4, 3.9, 1.1, 4.6), WallCell::Recess), 0.25 / 0.49, 0.1);
  EXPECT_DOUBLE_EQ(image.share(rectangle(0.1, 3.1, 0.4, 3.9), WallCell::Face), 1.0);
}

TEST(WallImage, UnevenWallsHaveNoHoles)
{
  auto points = simulatedSide(4.0, 2.5, {{rectangle(2.5, 1.0, 3.0, 1.5), -0.15}});
  for (auto& point : points)
    point.before += 0.03f * std::sin(4.0f * point.along);
  const auto image = wallImage(points, 4.0, 0.0, 2.5);
  EXPECT_EQ(image.share(rectangle(0.0, 0.0, 2.4, 2.5), WallCell::Face), 1.0);
  EXPECT_EQ(cellAt(image, 2.75, 1.25), WallCell::Recess);
}

TEST(WallImage, CellsFollowTheSpacing)
{
  std::vector<WallPoint> sparse;
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k < 25; ++k)
      sparse.push_back({0.1f * static_cast<float>(i) + 0.05f,
                        0.0f,
                        0.1f * static_cast<float>(k) + 0.05f});
  const auto image = wallImage(sparse, 4.0, 0.0, 2.5);
  EXPECT_NEAR(image.cell, 0.06, 1e-9); // six tenths of 0.1 m
  EXPECT_EQ(image.share(rectangle(0.0, 0.0, 4.0, 2.5), WallCell::Face), 1.0);
}

TEST(WallImage, WithoutPointsNothingIsSeen)
{
  const auto image = wallImage({}, 1.0, 0.0, 2.0);
  EXPECT_EQ(image.cells.nx, 50);
  EXPECT_EQ(image.cells.ny, 100);
  EXPECT_EQ(image.share(rectangle(0.0, 0.0, 1.0, 2.0), WallCell::Empty), 1.0);
}

TEST(WallImage, WhatIsSeenBehindAFaceFromTheOtherSideIsNoRecess)
{
  auto points = simulatedSide(4.0, 2.5, {{rectangle(0.5, 1.0, 1.5, 2.0), -0.4}});
  const auto other_side = simulatedSide(4.0, 2.5, {});
  for (int layer = 0; layer < 3; ++layer) // more points than the face has
    for (auto point : other_side)
      if (point.along > 2.5f) {
        point.before -= 0.4f + 0.01f * static_cast<float>(layer);
        points.push_back(point);
      }
  const auto image = wallImage(points, 4.0, 0.0, 2.5);
  EXPECT_EQ(cellAt(image, 1.0, 1.5), WallCell::Recess); // no face before it
  EXPECT_EQ(image.share(rectangle(2.6, 0.1, 3.9, 2.4), WallCell::Face), 1.0);
}
