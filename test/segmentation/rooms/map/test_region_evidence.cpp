/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/region_evidence.h"

#include <gtest/gtest.h>

#include <array>

using namespace pcl::indoor;

namespace {

/** What of a room was seen, as shares; it is 2.5 m high. */
struct Seen {
  double walls, floor, ceiling;
};

/** Add a square room with its corner at begin, in pixels. */
void
addRoom(std::int32_t label,
        const std::array<int, 2>& begin,
        int side,
        const Seen& seen,
        StoreySpace& space,
        RoomMap& map)
{
  const auto [left, low] = begin;
  const auto part = [&](double share) { return share * side; };
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      map.free_labels.at(left + x, low + y) = label;
      if (x < part(seen.floor))
        space.occupancy.set(left + x, low + y, 1);
      if (x < part(seen.ceiling))
        space.occupancy.set(left + x, low + y, 26);
    }
    if (x < part(seen.walls))
      for (const int across : {-1, side}) {
        map.blocked.at(left + across, low + x) = 1;
        map.blocked.at(left + x, low + across) = 1;
      }
  }
}

/** A square room of voxels of 0.1 m and a larger one, the hall, and their map. */
class SquareRoom {
public:
  explicit SquareRoom(const Seen& seen, int side)
  {
    const int nx = side + hall + 3 * margin, ny = hall + 2 * margin;
    space_.occupancy.voxel_size = 0.1;
    space_.occupancy.reset({nx, ny, 29});
    space_.range = {2, 26};
    map_.range = space_.range;
    map_.ceiling = {nx, ny, std::vector<int>(nx * ny, 26)};
    map_.blocked = {nx, ny, std::vector<std::uint8_t>(nx * ny, 0)};
    map_.free_labels = {nx, ny, std::vector<std::int32_t>(nx * ny, 0)};
    map_.room_count = 2;
    addRoom(1, {margin, margin}, side, seen, space_, map_);
    addRoom(2, {side + 2 * margin, margin}, hall, {0.0, 0.0, 0.0}, space_, map_);
    map_.labels = map_.free_labels;
  }

  /** Neither floors nor ceilings were seen in the whole scan. */
  SquareRoom&
  withWallsOnly()
  {
    space_.interior.unseen.floor_seen = space_.interior.unseen.ceiling_seen = 0.0;
    return *this;
  }

  double
  closed() const
  {
    return closedBorders(map_, 0.1)[1];
  }

  /** The hall is, always. */
  bool
  isKept() const
  {
    RoomMap map = map_;
    const std::size_t dropped = dropSeenThroughOpenings(space_, map);
    EXPECT_EQ(dropped, static_cast<std::size_t>(2 - map.room_count));
    EXPECT_EQ(map.free_labels.at(margin, margin), map.room_count - 1);
    EXPECT_EQ(map.labels.at(margin, margin), map.room_count - 1);
    EXPECT_EQ(map.labels.at(map.labels.nx - margin - 1, margin), map.room_count);
    return map.room_count == 2;
  }

private:
  static constexpr int margin = 5, hall = 80;

  StoreySpace space_;
  RoomMap map_;
};

} // namespace

TEST(RegionEvidence, TheShareOfTheBorderWithWallsIsCounted)
{
  EXPECT_DOUBLE_EQ(SquareRoom({1.0, 1.0, 1.0}, 30).closed(), 1.0);
  EXPECT_DOUBLE_EQ(SquareRoom({0.4, 1.0, 1.0}, 30).closed(), 0.4);
  EXPECT_DOUBLE_EQ(SquareRoom({0.0, 1.0, 1.0}, 30).closed(), 0.0);
}

TEST(RegionEvidence, ASmallRegionOfWhichLittleWasSeenIsNoRoom)
{
  EXPECT_FALSE(SquareRoom({0.4, 0.1, 0.1}, 20).isKept()); // a part of a garden
  EXPECT_FALSE(SquareRoom({0.1, 0.9, 0.7}, 20).isKept()); // seen through a door
  EXPECT_FALSE(SquareRoom({0.4, 0.9, 0.0}, 20).isKept()); // a yard
  EXPECT_FALSE(SquareRoom({0.0, 1.0, 1.0}, 20).isKept());
}

TEST(RegionEvidence, WallsOrFloorAndCeilingMakeARoom)
{
  EXPECT_TRUE(SquareRoom({1.0, 0.0, 0.0}, 20).isKept()); // full of objects
  EXPECT_TRUE(SquareRoom({0.5, 0.6, 0.6}, 20).isKept());
  EXPECT_TRUE(SquareRoom({0.4, 1.0, 1.0}, 20).isKept()); // an open corner
}

TEST(RegionEvidence, WhatTheWholeScanLacksDoesNotCount)
{
  EXPECT_FALSE(SquareRoom({0.6, 0.0, 0.0}, 20).isKept());
  EXPECT_TRUE(SquareRoom({0.6, 0.0, 0.0}, 20).withWallsOnly().isKept());
  EXPECT_FALSE(SquareRoom({0.4, 0.0, 0.0}, 20).withWallsOnly().isKept());
}

TEST(RegionEvidence, ALargeRegionIsARoomThatWasSeenInPart)
{
  EXPECT_FALSE(SquareRoom({0.2, 0.4, 0.4}, 30).isKept()); // 0.27 of 9 m^2
  EXPECT_TRUE(SquareRoom({0.2, 0.4, 0.4}, 40).isKept());  // 0.27 of 16 m^2
  EXPECT_FALSE(SquareRoom({0.1, 0.5, 0.1}, 40).isKept());
}

TEST(RegionEvidence, ARegionHalfAsLargeAsTheLargestStays)
{
  EXPECT_TRUE(SquareRoom({0.0, 0.1, 0.0}, 60).isKept()); // of the hall's 80
  EXPECT_FALSE(SquareRoom({0.0, 0.1, 0.0}, 55).isKept());
}

TEST(RegionEvidence, ASmallRegionIsARoomIfNearlyAllOfItWasSeen)
{
  EXPECT_FALSE(SquareRoom({0.7, 0.8, 0.8}, 10).isKept()); // 0.73 of 1 m^2
  EXPECT_TRUE(SquareRoom({0.9, 0.8, 0.8}, 10).isKept());  // 0.87, a cupboard
  EXPECT_TRUE(SquareRoom({0.8, 0.9, 0.9}, 5).isKept());   // 0.83, however small
}

namespace {

/** A room of 2 x 2 m with walls and ceiling and a region of 1.5 x 1.5 m in a square of
 * 10 x 10 m, voxels of 0.1 m. */
class Garden {
public:
  /** \param[in] region what bounds the region; its floor does not count
   * \param[in] ground how much of the square has any
   */
  explicit Garden(const Seen& region, double ground = 1.0)
  {
    constexpr int n = 100;
    space_.occupancy.voxel_size = 0.1;
    space_.occupancy.reset({n, n, 60});
    space_.range = {2, 50};
    space_.interior.unseen.ceiling_seen = 1.0;
    map_.range = space_.range;
    map_.ceiling = {n, n, std::vector<int>(n * n, 26)};
    map_.blocked = {n, n, std::vector<std::uint8_t>(n * n, 0)};
    map_.free_labels = {n, n, std::vector<std::int32_t>(n * n, 0)};
    map_.room_count = 2;
    for (int x = 0; x < ground * n; ++x)
      for (int y = 0; y < n; ++y)
        space_.occupancy.set(n - 1 - x, y, 2);
    addRoom(1, {2, 2}, 20, {1.0, 1.0, 1.0}, space_, map_);
    addRoom(2, {30, 2}, 15, region, space_, map_);
    map_.labels = map_.free_labels;
  }

  Garden&
  withoutCeilings()
  {
    space_.interior.unseen.ceiling_seen = 0.0;
    return *this;
  }

  /** The room is, always. */
  bool
  isRegionKept() const
  {
    RoomMap map = map_;
    OpenGround ground;
    dropOutdoors(space_, ground, map);
    EXPECT_EQ(map.free_labels.at(2, 2), 1);
    EXPECT_EQ(map.free_labels.at(30, 2), map.room_count - 1 > 0 ? 2 : 0);
    return map.room_count == 2;
  }

  /** Of an upper storey, without ground, that has the region alone. */
  bool
  isKeptAbove(const Garden& below) const
  {
    RoomMap map_below = below.map_, map = map_;
    OpenGround ground;
    dropOutdoors(below.space_, ground, map_below);
    for (auto& label : map.free_labels.values)
      label = label == 2;
    map.labels = map.free_labels;
    map.room_count = 1;
    dropOutdoors(space_, ground, map);
    return map.room_count == 1;
  }

private:
  StoreySpace space_;
  RoomMap map_;
};

} // namespace

TEST(RegionEvidence, UnderATreeIsOutdoors)
{
  EXPECT_FALSE(Garden({0.4, 1.0, 0.2}).isRegionKept());
  EXPECT_FALSE(Garden({0.0, 1.0, 0.6}).isRegionKept()); // under eaves
  const Seen tree{0.4, 1.0, 0.2};
  EXPECT_FALSE(Garden(tree, 0.0).isKeptAbove(Garden(tree))); // its top
  EXPECT_TRUE(Garden(tree, 0.0).isKeptAbove(Garden(tree, 0.0)));
}

TEST(RegionEvidence, WallsOrACeilingAreEnoughInAGarden)
{
  EXPECT_TRUE(Garden({0.9, 1.0, 0.0}).isRegionKept()); // a shed whose roof was not seen
  EXPECT_TRUE(Garden({0.3, 1.0, 1.0}).isRegionKept());
  EXPECT_TRUE(Garden({0.5, 1.0, 0.5}).isRegionKept());
}

TEST(RegionEvidence, WithoutOpenGroundRoomsMayBeSeenInPart)
{
  EXPECT_TRUE(Garden({0.4, 1.0, 0.2}, 0.03).isRegionKept());
  EXPECT_TRUE(Garden({0.4, 1.0, 0.2}).withoutCeilings().isRegionKept());
}
