/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/collected_objects.h"
#include "support/furnished_building.h"

#include <gtest/gtest.h>

#include <utility>

namespace pcl::indoor::tool {
namespace {

using test::Building;

void
ignore(std::size_t /*done*/, std::size_t /*all*/)
{}

CollectedObjects
collected(const PointCloud<PointXYZ>& points,
          const std::vector<std::uint32_t>& room_of_point,
          int threads = 0)
{
  return collectObjects(points, room_of_point, {}, {}, threads, ignore);
}

TEST(CollectedObjects, AreThoseOfTheRoomsOneAfterTheOther)
{
  const Building building;
  const auto all = collected(*building.cloud, building.room_of_point);
  ASSERT_EQ(all.object_of_point.size(), building.cloud->size());
  RoomWork work;
  work.keeps_surfaces = true;
  std::uint32_t before = 0;
  for (const std::uint32_t number : {1u, 2u, 0u}) {
    const auto own = finishRoom(test::room(building, number), work).objects;
    std::size_t k = 0;
    for (std::size_t i = 0; i < building.cloud->size(); ++i) {
      if (building.group_of_point[i] != number || i == 7)
        continue;
      const auto object = own.object_of_point[k++];
      EXPECT_EQ(all.object_of_point[i], object == 0 ? 0 : before + object) << i;
    }
    before += static_cast<std::uint32_t>(own.surfaces.size());
  }
  EXPECT_GT(before, 10u); // two floors, ceilings, walls, a table, a cabinet
  EXPECT_EQ(all.surfaces.size(), before);
  EXPECT_EQ(all.object_of_point[7], 0u); // is not finite
}

TEST(CollectedObjects, PointsKilometresAwayAreInNoneAndChangeNone)
{
  const Building building;
  auto room_of_point = building.room_of_point;
  auto cloud = *building.cloud;
  const auto expected = collected(cloud, room_of_point);
  for (const auto& [far, room] : {std::make_pair(5e6f, 0u), {-3e5f, 0u}, {2e8f, 1u}}) {
    cloud.push_back(PointXYZ(far, -far, 0.5f));
    room_of_point.push_back(room);
  }
  auto found = collected(cloud, room_of_point);
  ASSERT_EQ(found.object_of_point.size(), cloud.size());
  for (int i = 0; i < 3; ++i, found.object_of_point.pop_back())
    EXPECT_EQ(found.object_of_point.back(), 0u);
  EXPECT_EQ(found.object_of_point, expected.object_of_point);
  EXPECT_EQ(found.surfaces.size(), expected.surfaces.size());
}

TEST(CollectedObjects, DoNotDependOnThreads)
{
  const Building building;
  const auto one = collected(*building.cloud, building.room_of_point, 1);
  const auto three = collected(*building.cloud, building.room_of_point, 3);
  EXPECT_EQ(one.object_of_point, three.object_of_point);
}

TEST(CollectedObjects, GivenOnesAreTakenRoomByRoom)
{
  const Building building;
  std::vector<std::uint32_t> given(building.cloud->size(), 0);
  for (std::size_t i = 0; i < given.size(); ++i)
    given[i] = building.scene.points[i].z() > 1.0f ? 70 : 0; // in both rooms
  RoomWork work;
  work.options.fewest_points = 0;
  const auto all =
      collectObjects(*building.cloud, building.room_of_point, given, work, 2, ignore);
  for (std::size_t i = 0; i < given.size(); ++i)
    if (i != 7) {
      const auto number = building.group_of_point[i];
      const auto expected = number == 0 ? 3 : number;
      EXPECT_EQ(all.object_of_point[i], given[i] == 0 ? 0 : expected) << i;
    }
  EXPECT_EQ(all.surfaces.size(), 3u);
}

TEST(CollectedObjects, OfNothingAreNone)
{
  EXPECT_TRUE(collected({}, {}).object_of_point.empty());
}

} // namespace
} // namespace pcl::indoor::tool
