/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/field_rooms.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using pcl::indoor::FieldRooms;
using pcl::indoor::InteriorSpace;
using pcl::indoor::PixelMap;
using pcl::indoor::segmentFieldMap;
using pcl::indoor::thesis::FieldRoomsOptions;

namespace {

/** Two rooms of 4.8 m x 4 m and 3.6 m x 4 m, 2.6 m high, voxels of 20 cm, with a door
 * of 0.8 m x 2 m in the wall between them (x = 25). */
InteriorSpace
twoRooms(int door_width = 4)
{
  InteriorSpace space;
  space.occupancy.voxel_size = space.inside.voxel_size = 0.2;
  space.occupancy.reset({45, 22, 15});
  space.inside.reset({45, 22, 15});
  for (int x = 0; x < 45; ++x)
    for (int y = 0; y < 22; ++y)
      for (int z = 0; z < 15; ++z) {
        const bool door = x == 25 && z <= 10 && y >= 8 && y < 8 + door_width;
        const bool wall = x == 0 || x == 44 || x == 25 || y == 0 || y == 21;
        const bool is_occupied = z == 0 || z == 14 || (wall && !door);
        (is_occupied ? space.occupancy : space.inside).set(x, y, z);
      }
  return space;
}

/** The same with free space above the ceiling, and something in it. */
InteriorSpace
withNoiseAbove(const InteriorSpace& space)
{
  InteriorSpace higher = space;
  higher.occupancy.reset({45, 22, 17});
  higher.inside.reset({45, 22, 17});
  for (int x = 0; x < 45; ++x)
    for (int y = 0; y < 22; ++y)
      for (int z = 0; z < 17; ++z) {
        const bool is_noise = x == 13 && y == 11 && z == 16;
        if (is_noise || (z < 15 && space.occupancy.at(x, y, z)))
          higher.occupancy.set(x, y, z);
        else if (z >= 15 || space.inside.at(x, y, z))
          higher.inside.set(x, y, z);
      }
  return higher;
}

std::set<int>
labelsOf(const PixelMap<int>& labels, int begin, int end)
{
  std::set<int> found;
  for (int x = begin; x < end; ++x)
    for (int y = 1; y < 21; ++y)
      found.insert(labels.at(x, y));
  return found;
}

/** Each side of the wall has one label, and not the same. */
void
expectTwoRooms(const FieldRooms& rooms)
{
  const auto left = labelsOf(rooms.labels, 1, 24);
  const auto right = labelsOf(rooms.labels, 27, 44);
  EXPECT_EQ(left.size(), 1u);
  EXPECT_EQ(right.size(), 1u);
  EXPECT_NE(left, right);
  EXPECT_EQ(left.count(-1) + right.count(-1), 0u);
}

} // namespace

TEST(SegmentFieldMap, PartsTwoRoomsAtADoor)
{
  const FieldRooms rooms = segmentFieldMap(twoRooms());
  expectTwoRooms(rooms);
  // Eq. (3.3) to (3.5): below the ceiling at layer 14, voxels squared
  EXPECT_EQ(rooms.field.at(13, 11), 100.0f); // 10 voxels to the wall at y = 21
  EXPECT_EQ(rooms.field.at(24, 2), 1.0f);
  EXPECT_EQ(rooms.field.at(25, 3), 0.0f);
  EXPECT_EQ(rooms.highest_free.at(25, 9), 10);
}

TEST(SegmentFieldMap, SpaceAboveTheCeilingJoinsNothing)
{
  const InteriorSpace space = twoRooms();
  EXPECT_EQ(segmentFieldMap(withNoiseAbove(space)).labels.values,
            segmentFieldMap(space).labels.values);
}

TEST(SegmentFieldMap, FindsTheCeilingByTheOptionsOfTheSlab)
{
  const InteriorSpace space = withNoiseAbove(twoRooms());
  EXPECT_EQ(segmentFieldMap(space).highest_free.at(14, 11), 13);
  pcl::indoor::CeilingSlabOptions highest;
  highest.step = 0.0;
  highest.level_share = 1.0;
  EXPECT_EQ(segmentFieldMap(space, {}, highest).highest_free.at(14, 11), 16);
}

TEST(SegmentFieldMap, PartsThemWithoutVisibility)
{
  FieldRoomsOptions options;
  options.distance.visibility_weight = 0.0;
  expectTwoRooms(segmentFieldMap(twoRooms(), options));
}

TEST(SegmentFieldMap, DBSCANPartsThemAtADistanceBetween)
{
  FieldRoomsOptions options;
  options.distance = {0.0, 0.0, 1.0, 0.0}; // the field alone: 1 where not connected
  options.dbscan_distance = 0.8;
  const FieldRooms parted = segmentFieldMap(twoRooms(), options);
  expectTwoRooms(parted);
  EXPECT_EQ(parted.clusters.at(13, 11), 0);
  EXPECT_EQ(parted.clusters.at(34, 11), 1);
  options.dbscan_distance = 1.0; // as far as two pixels can be
  const FieldRooms joined = segmentFieldMap(twoRooms(), options);
  EXPECT_EQ(labelsOf(joined.clusters, 1, 24), std::set<int>{0});
  EXPECT_EQ(labelsOf(joined.clusters, 27, 44), std::set<int>{0});
}

TEST(SegmentFieldMap, AMapWithoutRoomForAClusterHasNone)
{
  FieldRoomsOptions options;
  options.min_cluster_area = 1000.0;
  const FieldRooms rooms = segmentFieldMap(twoRooms(), options);
  for (const int cluster : rooms.clusters.values)
    ASSERT_EQ(cluster, -1);
}

TEST(SegmentFieldMap, RejectsBadOptions)
{
  const InteriorSpace space = twoRooms();
  const auto refused = [&space](double FieldRoomsOptions::*option, double value) {
    FieldRoomsOptions options;
    options.*option = value;
    EXPECT_THROW(segmentFieldMap(space, options), pcl::BadArgumentException) << value;
  };
  for (const double value : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    refused(&FieldRoomsOptions::min_cluster_area, value);
    refused(&FieldRoomsOptions::sample_area, value);
  }
  for (const double value : {-0.1, std::nan(""), HUGE_VAL}) {
    refused(&FieldRoomsOptions::landmark_spacing, value); // 0: each pixel
    refused(&FieldRoomsOptions::dbscan_distance, value);
  }
  FieldRoomsOptions options;
  options.distance.field_weight = -1.0;
  EXPECT_THROW(segmentFieldMap(space, options), pcl::BadArgumentException);
}
