/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/region_borders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace pcl::indoor;
using RegionLabels = std::vector<std::int32_t>;

namespace {

constexpr int floor_layer = 0, ceiling_layer = 26; // 2.5 m of free layers between

/** Two spaces side by side, each with its label up to the middle of the wall between
 * them; voxels of 0.1 m. */
struct TwoSpaces {
  VoxelMap<std::uint8_t> occupancy;
  PixelMap<int> ceiling;
  PixelMap<std::int32_t> labels, free_labels;
  PixelMap<std::uint8_t> blocked; ///< the wall's columns

  /** \param[in] faces x of the wall's faces */
  explicit TwoSpaces(const std::vector<int>& faces, int nx = 60, int ny = 30)
  {
    occupancy.shape = {nx, ny, 30};
    occupancy.voxel_size = 0.1;
    occupancy.values.assign(occupancy.shape.size(), 0);
    ceiling = {nx, ny, std::vector<int>(occupancy.shape.size() / 30, ceiling_layer)};
    blocked = PixelMap<std::uint8_t>::filled(nx, ny, 0);
    labels = free_labels = {nx, ny, RegionLabels(ceiling.size(), 0)};
    for (int x = 0; x < nx; ++x)
      for (int y = 0; y < ny; ++y) {
        set(x, x, y, y, floor_layer, floor_layer, 1);
        set(x, x, y, y, ceiling_layer, ceiling_layer, 1);
        labels.at(x, y) = 2 * x <= faces.front() + faces.back() ? 1 : 2;
        if (x < faces.front() || x > faces.back())
          free_labels.at(x, y) = labels.at(x, y);
        else
          blocked.at(x, y) = 1;
      }
    for (const int x : faces)
      set(x, x, 0, ny - 1, floor_layer, ceiling_layer, 1);
  }

  void
  set(int x0, int x1, int y0, int y1, int z0, int z1, std::uint8_t value)
  {
    for (int x = x0; x <= x1; ++x)
      for (int y = y0; y <= y1; ++y)
        for (int z = z0; z <= z1; ++z)
          occupancy.at(x, y, z) = value;
  }

  std::vector<RegionOpening>
  openings() const
  {
    return regionOpenings({occupancy, {0, 30}, ceiling, labels, free_labels, blocked});
  }

  std::vector<RegionBorder>
  borders() const
  {
    return regionBorders({occupancy, {0, 30}, ceiling, labels, free_labels, blocked});
  }
};

RegionBorder
border(std::int32_t a, std::int32_t b, double area, double open)
{
  RegionBorder result;
  result.a = a;
  result.b = b;
  result.border_area = area;
  result.open_area = result.opening_area = open; // from floor to ceiling
  return result;
}

RegionLabels
merged(const std::vector<RegionBorder>& borders,
       const std::vector<double>& section,
       double open_share)
{
  MergeOptions options;
  options.open_share = open_share;
  return mergeOpenRegions(borders, section, options);
}

} // namespace

TEST(RegionBorders, ADoorInAWallInClosedForm)
{
  for (const auto& faces : {std::vector<int>{30}, std::vector<int>{29, 30, 31}}) {
    TwoSpaces spaces(faces);
    spaces.set(faces.front(), faces.back(), 10, 18, 1, 20, 0);
    const auto borders = spaces.borders();
    ASSERT_EQ(borders.size(), 1u);
    EXPECT_EQ(borders[0].a, 1);
    EXPECT_EQ(borders[0].b, 2);
    EXPECT_NEAR(borders[0].border_area, 3.0 * 2.5, 1e-9);
    EXPECT_NEAR(borders[0].open_area, 0.9 * 2.0, 1e-9);
    EXPECT_NEAR(borders[0].opening_area, 0.9 * 2.5, 1e-9);
  }
}

TEST(RegionOpenings, TwoDoorsAndAGapInClosedForm)
{
  TwoSpaces spaces({29, 30, 31});
  spaces.set(29, 31, 3, 10, 1, 20, 0);  // 0.8 m wide, 2 m high
  spaces.set(29, 31, 15, 24, 1, 21, 0); // 1 m wide, 2.1 m high
  spaces.set(29, 31, 27, 28, 1, 20, 0); // 0.2 m: nobody passes
  const auto openings = spaces.openings();
  ASSERT_EQ(openings.size(), 2u);
  for (const auto& opening : openings) {
    EXPECT_EQ(opening.a, 1);
    EXPECT_EQ(opening.b, 2);
    EXPECT_NEAR(std::abs(opening.along.y()), 1.0, 1e-9);
    EXPECT_NEAR(opening.x, 31.0, 1e-9); // labels change between pixels 30 and 31
  }
  EXPECT_NEAR(openings[0].y, 7.0, 1e-9);
  EXPECT_NEAR(openings[0].width, 0.8, 1e-9);
  EXPECT_NEAR(openings[0].area, 1.6, 1e-9);
  EXPECT_NEAR(openings[1].y, 20.0, 1e-9);
  EXPECT_NEAR(openings[1].width, 1.0, 1e-9);
  EXPECT_NEAR(openings[1].area, 2.1, 1e-9);
  EXPECT_NEAR(openings[0].rise, 0.5 * (2.0 - 2.5), 1e-9); // below lintels of 0.5
  EXPECT_NEAR(openings[1].rise, 0.5 * (2.1 - 2.5), 1e-9); // and 0.4 m
}

TEST(RegionOpenings, OverASillTheyRise)
{
  TwoSpaces spaces({30});
  spaces.set(30, 30, 10, 18, 6, 25, 0); // from 0.5 m above the floor to the ceiling
  const auto openings = spaces.openings();
  ASSERT_EQ(openings.size(), 1u);
  EXPECT_NEAR(openings[0].rise, 0.25, 1e-9);
}

TEST(RegionOpenings, AWindowIsNone)
{
  TwoSpaces spaces({30});
  spaces.set(30, 30, 10, 18, 10, 22, 0);
  EXPECT_TRUE(spaces.openings().empty());
}

TEST(RegionOpenings, AnObliqueBorderIsAsWideAsItIsLong)
{
  TwoSpaces spaces({30}, 40, 40);
  spaces.set(0, 39, 0, 39, floor_layer + 1, ceiling_layer - 1, 0); // no wall
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 40; ++y)
      spaces.labels.at(x, y) = spaces.free_labels.at(x, y) = 3 * x > 4 * y ? 2 : 1;
  const auto openings = spaces.openings();
  ASSERT_EQ(openings.size(), 1u);
  // from a corner to (40, 30); half a pixel at each end
  EXPECT_NEAR(openings[0].width, 5.0, 0.1);
  EXPECT_NEAR(openings[0].area, 5.0 * 2.5, 0.25);
  EXPECT_NEAR(std::abs(openings[0].along.dot(Eigen::Vector2d(0.8, 0.6))), 1.0, 1e-3);
  EXPECT_NEAR(openings[0].x, 20.0, 1.0);
  EXPECT_NEAR(openings[0].y, 15.0, 1.0);
}

TEST(RegionBorders, AlongTheOtherAxisItIsTheSame)
{
  TwoSpaces spaces({30});
  spaces.set(30, 30, 5, 12, 1, 20, 0);
  TwoSpaces turned = spaces; // x and y exchanged
  turned.occupancy.shape = {30, 60, 30};
  turned.ceiling.nx = turned.labels.nx = turned.free_labels.nx = 30;
  turned.ceiling.ny = turned.labels.ny = turned.free_labels.ny = 60;
  turned.blocked = PixelMap<std::uint8_t>::filled(30, 60, 0);
  for (int x = 0; x < 60; ++x)
    for (int y = 0; y < 30; ++y) {
      turned.labels.at(y, x) = spaces.labels.at(x, y);
      turned.free_labels.at(y, x) = spaces.free_labels.at(x, y);
      turned.blocked.at(y, x) = spaces.blocked.at(x, y);
      for (int z = 0; z < 30; ++z)
        turned.occupancy.at(y, x, z) = spaces.occupancy.at(x, y, z);
    }
  const auto first = spaces.borders(), second = turned.borders();
  ASSERT_EQ(first.size(), 1u);
  ASSERT_EQ(second.size(), 1u);
  EXPECT_NEAR(first[0].open_area, 0.8 * 2.0, 1e-9);
  EXPECT_NEAR(first[0].open_area, second[0].open_area, 1e-9);
  EXPECT_NEAR(first[0].border_area, second[0].border_area, 1e-9);
}

TEST(RegionBorders, HollowWallsAreClosed)
{
  TwoSpaces spaces({28, 33});
  auto borders = spaces.borders();
  ASSERT_EQ(borders.size(), 1u);
  EXPECT_NEAR(borders[0].border_area, 7.5, 1e-9);
  EXPECT_EQ(borders[0].open_area, 0.0);

  spaces.set(28, 28, 2, 8, 1, 25, 0); // a hole in one face, a niche
  borders = spaces.borders();
  EXPECT_EQ(borders[0].open_area, 0.0);

  spaces.set(28, 33, 15, 24, 1, 20, 0); // a door
  borders = spaces.borders();
  EXPECT_NEAR(borders[0].open_area, 1.0 * 2.0, 1e-9);
  EXPECT_NEAR(borders[0].opening_area, 1.0 * 2.5, 1e-9);
}

TEST(RegionBorders, LowOpeningsLetNobodyPass)
{
  TwoSpaces spaces({30});
  spaces.set(30, 30, 3, 7, 1, 15, 0);   // 1.5 m high, as below a counter
  spaces.set(30, 30, 20, 24, 9, 22, 0); // an inner window
  const auto borders = spaces.borders();
  ASSERT_EQ(borders.size(), 1u);
  EXPECT_NEAR(borders[0].open_area, 0.5 * 1.5 + 0.5 * 1.4, 1e-9);
  EXPECT_EQ(borders[0].opening_area, 0.0);
}

TEST(RegionBorders, WithoutAWallItIsOpen)
{
  TwoSpaces spaces({30});
  spaces.set(30, 30, 0, 29, 1, 25, 0);
  const auto borders = spaces.borders();
  ASSERT_EQ(borders.size(), 1u);
  EXPECT_NEAR(borders[0].open_area, borders[0].border_area, 1e-9);
  EXPECT_NEAR(borders[0].opening_area, 3.0 * 2.5, 1e-9);
}

TEST(RegionBorders, FurnitureAndPeopleAreNoWalls)
{
  const auto openTo = [](int low, int high, bool is_blocked) {
    TwoSpaces spaces({30});
    spaces.set(30, 30, 0, 29, 1, 25, 0);
    spaces.set(30, 30, 0, 29, low, high, 1);
    for (int y = 0; y < 30; ++y)
      spaces.blocked.at(30, y) = is_blocked;
    return spaces.borders()[0].open_area;
  };
  EXPECT_NEAR(openTo(1, 10, false), 3.0 * 2.5, 1e-9); // a sideboard of 1 m
  EXPECT_NEAR(openTo(9, 17, false), 3.0 * 2.5, 1e-9); // the trail of somebody's trunk
  EXPECT_NEAR(openTo(9, 17, true), 3.0 * 1.6, 1e-9);  // below a wall or a lintel
  EXPECT_NEAR(openTo(1, 17, false), 3.0 * 0.8, 1e-9); // a wall seen up to 1.7 m
}

TEST(RegionOpenings, FurnitureIsInTheWay)
{
  TwoSpaces spaces({30});
  spaces.set(30, 30, 0, 29, 1, 25, 0);
  spaces.set(30, 30, 0, 29, 1, 10, 1); // a sideboard
  for (int y = 0; y < 30; ++y)
    spaces.blocked.at(30, y) = 0;
  EXPECT_TRUE(spaces.openings().empty()); // nobody passes
}

TEST(RegionBorders, OnlyTheStoreyCounts)
{
  TwoSpaces spaces({30});
  spaces.set(30, 30, 10, 18, 1, 20, 0);
  const auto all = spaces.borders();
  spaces.set(0, 59, 0, 29, 27, 29, 1); // what is above the ceiling
  const auto same = spaces.borders();
  EXPECT_EQ(all[0].open_area, same[0].open_area);
  EXPECT_EQ(all[0].border_area, same[0].border_area);
}

TEST(RegionBorders, PairsInOrderAndNoneWithoutRegions)
{
  TwoSpaces spaces({30});
  for (int x = 0; x < 60; ++x) // 3 | 1 over 2, 4 far from all
    for (int y = 0; y < 30; ++y) {
      std::int32_t label = x <= 20 ? 3 : y <= 15 ? 2 : 1;
      label = x > 50 ? 4 : x > 45 ? 0 : label;
      spaces.labels.at(x, y) = spaces.free_labels.at(x, y) = label;
    }
  const auto borders = spaces.borders();
  ASSERT_EQ(borders.size(), 3u);
  const std::vector<std::pair<int, int>> pairs{{1, 2}, {1, 3}, {2, 3}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(borders[i].a, pairs[i].first);
    EXPECT_EQ(borders[i].b, pairs[i].second);
  }
  EXPECT_NEAR(borders[1].border_area, 1.4 * 2.5, 1e-9);
  EXPECT_NEAR(borders[2].border_area, 1.6 * 2.5, 1e-9);

  spaces.labels.values.assign(spaces.labels.size(), 0);
  spaces.free_labels = spaces.labels;
  EXPECT_TRUE(spaces.borders().empty());
  const VoxelBits no_voxels;
  const PixelMap<int> nothing;
  const PixelMap<std::uint8_t> no_walls;
  EXPECT_TRUE(
      regionBorders({no_voxels, {}, nothing, nothing, nothing, no_walls}).empty());
}

TEST(MergeOpenRegions, AtTheThreshold)
{
  const std::vector<RegionBorder> borders{border(1, 2, 4.0, 3.0)};
  // 3 m^2 of the smaller section, 6 m^2
  EXPECT_EQ(merged(borders, {0, 6, 9}, 0.49), (RegionLabels{0, 1, 1}));
  EXPECT_EQ(merged(borders, {0, 6, 9}, 0.50), (RegionLabels{0, 1, 2}));
  EXPECT_EQ(merged(borders, {0, 9, 6}, 0.49), (RegionLabels{0, 1, 1}));
  EXPECT_EQ(merged(borders, {0, 9, 6}, 0.51), (RegionLabels{0, 1, 2}));
}

TEST(MergeOpenRegions, NotBelowALintel)
{
  RegionBorder wide = border(1, 2, 10.0, 7.0); // 70 % of the border is open ...
  wide.opening_area = 10.0;                    // ... all of it below a lintel
  MergeOptions options;
  options.open_share = 0.5;
  options.open_height = 0.71;
  EXPECT_EQ(mergeOpenRegions({wide}, {0, 10, 10}, options), (RegionLabels{0, 1, 2}));
  options.open_height = 0.69; // as below a beam
  EXPECT_EQ(mergeOpenRegions({wide}, {0, 10, 10}, options), (RegionLabels{0, 1, 1}));
}

TEST(MergeOpenRegions, ABeamOfAFifthOfTheHeightPartsNothing)
{
  RegionBorder wide = border(1, 2, 10.0, 8.1);
  wide.opening_area = 10.0;
  EXPECT_EQ(mergeOpenRegions({wide}, {0, 10, 10}, {}), (RegionLabels{0, 1, 1}));
  wide.open_area = 7.9;
  EXPECT_EQ(mergeOpenRegions({wide}, {0, 10, 10}, {}), (RegionLabels{0, 1, 2}));
}

TEST(MergeOpenRegions, DoorsNeedALargerShare)
{
  RegionBorder narrow = border(1, 2, 4.0, 3.0); // 0.6 of the smaller section, 5 m^2
  narrow.opening_run = {0.6, 0.8};              // 1 m wide
  MergeOptions options;
  options.open_share = 0.5;
  options.door_share = 0.59;
  EXPECT_EQ(mergeOpenRegions({narrow}, {0, 5, 9}, options, 1.1),
            (RegionLabels{0, 1, 1}));
  options.door_share = 0.61;
  EXPECT_EQ(mergeOpenRegions({narrow}, {0, 5, 9}, options, 1.1),
            (RegionLabels{0, 1, 2}));
  EXPECT_EQ(mergeOpenRegions({narrow}, {0, 5, 9}, options, 0.9),
            (RegionLabels{0, 1, 1}));
}

TEST(MergeOpenRegions, HeightsOfOpeningsAddUp)
{
  // The lintel between 1 and 3 counts for the space that 1 and 2 make.
  RegionBorder low = border(1, 3, 5.0, 2.0);
  low.opening_area = 5.0;
  const std::vector<RegionBorder> borders{
      border(1, 2, 5.0, 5.0), low, border(2, 3, 5.5, 5.0)};
  MergeOptions options;
  options.open_share = 0.6;
  options.open_height = 0.75; // 7 of 10 m^2 after 1 and 2 are joined
  EXPECT_EQ(mergeOpenRegions(borders, {0, 9, 5, 9}, options),
            (RegionLabels{0, 1, 1, 3}));
  options.open_height = 0.65;
  EXPECT_EQ(mergeOpenRegions(borders, {0, 9, 5, 9}, options),
            (RegionLabels{0, 1, 1, 1}));
}

TEST(MergeOpenRegions, NothingToMerge)
{
  EXPECT_EQ(merged({}, {}, 0.5), RegionLabels{});
  EXPECT_EQ(merged({}, {0, 1, 1}, 0.5), (RegionLabels{0, 1, 2}));
  EXPECT_EQ(merged({border(1, 2, 4, 0)}, {0, 1, 1}, 0.0), (RegionLabels{0, 1, 2}));
}

TEST(MergeOpenRegions, BordersOfJoinedRegionsAddUp)
{
  // 1 and 2 are one space; only together are they open enough to 3
  const std::vector<RegionBorder> borders{
      border(1, 2, 5.0, 5.0), border(1, 3, 2.0, 2.0), border(2, 3, 2.0, 2.0)};
  const std::vector<double> section{0, 5, 5, 5};
  EXPECT_EQ(merged(borders, section, 0.6), (RegionLabels{0, 1, 1, 1}));
  EXPECT_EQ(merged({borders[1], borders[2]}, section, 0.6), (RegionLabels{0, 1, 2, 3}));
  EXPECT_EQ(merged({borders[0], borders[1]}, section, 0.6), (RegionLabels{0, 1, 1, 3}));
}

TEST(MergeOpenRegions, ASmallSpaceBecomesPartOfTheLargeOne)
{
  // A niche (2) is open to a hall (1); a door of 2 m^2 leads from it to a room (3).
  // The door is large for the niche, but small for the hall and the room.
  const std::vector<RegionBorder> borders{border(1, 2, 2.5, 2.5),
                                          border(2, 3, 2.5, 2.0)};
  EXPECT_EQ(merged(borders, {0, 10, 2.5, 8}, 0.7), (RegionLabels{0, 1, 1, 3}));
  // the same with the niche numbered first
  EXPECT_EQ(
      merged({border(1, 2, 2.5, 2.5), border(1, 3, 2.5, 2.0)}, {0, 2.5, 10, 8}, 0.7),
      (RegionLabels{0, 1, 1, 3}));
}

TEST(MergeOpenRegions, TheOrderOfBordersDoesNotMatter)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 100; ++trial) {
    const int count = 2 + rng() % 7;
    std::vector<RegionBorder> borders;
    for (int a = 1; a <= count; ++a)
      for (int b = a + 1; b <= count; ++b)
        if (rng() % 2) {
          const double area = 1.0 + 0.001 * static_cast<double>(rng() % 5000);
          borders.push_back(border(a, b, area, area * 0.0001 * (rng() % 10000)));
        }
    std::vector<double> section{0.0};
    for (int a = 1; a <= count; ++a)
      section.push_back(1.0 + 0.001 * static_cast<double>(rng() % 5000));
    const auto first = merged(borders, section, 0.5);
    for (std::size_t i = borders.size(); i > 1; --i)
      std::swap(borders[i - 1], borders[rng() % i]);
    EXPECT_EQ(merged(borders, section, 0.5), first) << "trial " << trial;
    for (std::size_t i = 0; i < first.size(); ++i) {
      ASSERT_LE(first[i], static_cast<std::int32_t>(i)); // the smallest member's
      ASSERT_EQ(first[first[i]], first[i]);
    }
  }
}
