/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/open_plan.h"
#include "rooms/space/distance_map.h"
#include "rooms/space/visibility.h"
#include "support/room_labels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr double pixel = 0.1;

/** A map drawn by hand: letters are regions a = 1, b = 2, ...; # is wall. A letter
 * covers 5 x 5 pixels, which is half a metre. */
struct Plan {
  PixelMap<std::int32_t> labels;
  PixelMap<float> field;

  explicit Plan(const std::vector<std::string>& rows)
  {
    constexpr int scale = 5;
    labels.nx = scale * static_cast<int>(rows.size());
    labels.ny = scale * static_cast<int>(rows[0].size());
    labels.values.resize(labels.size());
    PixelMap<std::uint8_t> walls{labels.nx, labels.ny, {}};
    walls.values.resize(labels.size());
    for (int x = 0; x < labels.nx; ++x)
      for (int y = 0; y < labels.ny; ++y) {
        const char letter = rows[x / scale][y / scale];
        labels.at(x, y) = letter == '#' ? 0 : letter - 'a' + 1;
        walls.at(x, y) = letter == '#';
      }
    const auto squared = squaredDistanceMap(walls);
    field = {labels.nx, labels.ny, {}};
    for (const auto value : squared.values)
      field.values.push_back(static_cast<float>(pixel * std::sqrt(double(value))));
  }

  OpenPlan
  plan(const OpenPlanOptions& options = {}) const
  {
    return OpenPlan(labels, field, pixel, options);
  }
};

/** Two spaces of 12 m^2 that touch at a corner. */
Plan
corners()
{
  return Plan({"###############",
               "#aaaaaaaa######",
               "#aaaaaaaa######",
               "#aaaaaaaa######",
               "#aaaaaaaa######",
               "#aaaaaaaabbbbb#",
               "#aaaaaaaabbbbb#",
               "#######bbbbbbb#",
               "#######bbbbbbb#",
               "#######bbbbbbb#",
               "#######bbbbbbb#",
               "###############"});
}

/** Two spaces of 10 m^2 side by side. */
Plan
sideBySide()
{
  return Plan({"################",
               "#aaaaaaabbbbbbb#",
               "#aaaaaaabbbbbbb#",
               "#aaaaaaabbbbbbb#",
               "#aaaaaaabbbbbbb#",
               "#aaaaaaabbbbbbb#",
               "#aaaaaaabbbbbbb#",
               "################"});
}

/** Two arms of a corridor, around a corner. */
Plan
bentCorridor()
{
  return Plan({"##############",
               "#aaaaaaaaaaaa#",
               "#aaaaaaaaaaaa#",
               "###########bb#",
               "###########bb#",
               "###########bb#",
               "###########bb#",
               "###########bb#",
               "###########bb#",
               "###########bb#",
               "###########bb#",
               "###########bb#",
               "###########bb#",
               "###########bb#",
               "###########bb#",
               "###########bb#",
               "##############"});
}

} // namespace

TEST(OpenPlan, SharedViewIsThatOfAllPairsOfPixels)
{
  for (const Plan& drawn : {corners(), sideBySide(), bentCorridor()}) {
    VoxelMap<std::uint8_t> walls;
    walls.shape = {drawn.labels.nx, drawn.labels.ny, 1};
    std::vector<Eigen::Vector3i> pixels[3];
    for (int x = 0; x < drawn.labels.nx; ++x)
      for (int y = 0; y < drawn.labels.ny; ++y) {
        walls.values.push_back(drawn.labels.at(x, y) == 0);
        pixels[drawn.labels.at(x, y)].emplace_back(x, y, 0);
      }
    std::size_t open = 0, lines = 0;
    for (std::size_t i = 0; i < pixels[1].size(); i += 3)
      for (const auto& q : pixels[2]) {
        ++lines;
        open += lineOfSight(walls, pixels[1][i], q);
      }
    const double expected = static_cast<double>(open) / static_cast<double>(lines);
    EXPECT_NEAR(drawn.plan().sharedView({1}, {2}), expected, 0.05);
    EXPECT_EQ(drawn.plan().sharedView({1}, {2}), drawn.plan().sharedView({2}, {1}));
  }
  EXPECT_EQ(sideBySide().plan().sharedView({1}, {2}), 1.0);
}

TEST(OpenPlan, AreasAddUp)
{
  const OpenPlan plan = sideBySide().plan();
  EXPECT_NEAR(plan.area({1}), 6 * 7 * 0.25, 1e-9);
  EXPECT_NEAR(plan.area({1, 2}), 6 * 14 * 0.25, 1e-9);
  EXPECT_EQ(plan.area({}), 0.0);
}

TEST(OpenPlan, WhatIsAroundTheCornerIsAnotherRoom)
{
  EXPECT_TRUE(corners().plan().separates({1}, {2}));
  EXPECT_FALSE(sideBySide().plan().separates({1}, {2}));   // all of it is seen
  EXPECT_FALSE(bentCorridor().plan().separates({1}, {2})); // nobody lives in it
}

TEST(OpenPlan, EachConditionCounts)
{
  const auto separates = [](const OpenPlanOptions& options) {
    return corners().plan(options).separates({1}, {2});
  };
  OpenPlanOptions options;
  options.habitable_area = 13.0;
  EXPECT_FALSE(separates(options));
  options = {};
  options.max_elongation = 1.0;
  EXPECT_FALSE(separates(options));
  options = {};
  options.max_shared_view = 0.1;
  EXPECT_FALSE(separates(options));
}

TEST(FillIslands, AreWhatOneRoomSurrounds)
{
  // a wall from the edge, an island in room 1, one between two rooms, one at a corner
  PixelMap<std::int32_t> rooms{7, 9, {0, 0, 0, 0, 0, 0, 0, 0, 0, //
                                      0, 1, 1, 1, 1, 2, 2, 2, 0, //
                                      0, 1, 0, 1, 1, 2, 2, 2, 0, //
                                      0, 1, 0, 1, 1, 0, 2, 2, 0, //
                                      0, 1, 1, 1, 0, 2, 2, 2, 0, //
                                      0, 1, 1, 1, 1, 2, 0, 2, 0, //
                                      0, 0, 0, 0, 0, 0, 0, 0, 0}};
  const auto filled = fillIslands(rooms);
  for (const std::size_t pixel : {20u, 29u})
    rooms.values[pixel] = 1;
  // that at (5, 6) touches the outer wall, which reaches the edge
  EXPECT_EQ(filled.values, rooms.values);
}

TEST(FillIslands, AnIslandOfTheEdgeIsNone)
{
  PixelMap<std::int32_t> rooms{3, 3, {1, 1, 1, 1, 0, 1, 1, 1, 1}};
  EXPECT_EQ(fillIslands(rooms).at(1, 1), 1);
  rooms = {3, 2, {1, 1, 1, 0, 1, 1}};
  EXPECT_EQ(fillIslands(rooms).at(1, 1), 0);
  EXPECT_TRUE(fillIslands({}).values.empty());
}

TEST(OpenPlan, RoomSegmentationDividesIt)
{
  // 12 m^2 and 11 m^2 that touch at a corner, open to each other up to the ceiling
  const auto scene =
      rooms({{{0, 0, 0}, {4, 3, 2.5f}, 1},
             {{4, 2, 0}, {7, 5, 2.5f}, 2},
             {{3, 3, 0}, {4, 5, 2.5f}, 2}},
            {junction(3.9f, 4.1f, 2.05f, 4.95f), junction(3.05f, 3.95f, 2.9f, 3.1f)});
  pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  Labels labels;
  segmentation.segment(labels);
  ASSERT_EQ(segmentation.getRooms().size(), 2u);
  std::size_t agree = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    agree += labels[i] == scene.objects[i];
  EXPECT_GT(agree, 0.95 * labels.size());

  segmentation.setHabitableArea(std::numeric_limits<double>::infinity());
  segmentation.segment(labels);
  EXPECT_EQ(segmentation.getRooms().size(), 1u);
}

TEST(OpenPlan, PillarsDivideNothing)
{
  auto scene = rooms({{{0, 0, 0}, {6, 8, 3}, 1}}, {});
  std::mt19937 rng(3);
  for (const float x : {1.5f, 3.7f}) // leave 1.5 m, 1.4 m and 1.5 m
    scene.addBox({x, 3.7f, 0}, {0.8f, 0.8f, 3}, 1, 0.04f, 0.005f, rng);
  const Labels labels = segmented(cloudOf(scene.points));
  EXPECT_EQ(roomCount(labels), 1u);
}
