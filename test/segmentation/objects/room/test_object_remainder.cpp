/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/room_objects.h>

#include <gtest/gtest.h>

using namespace pcl::indoor;

TEST(ObjectRemainder, TakesWhatIsSmallAndNumbersTheOthersAgain)
{
  RoomObjects objects;
  objects.object_of_point = {1, 1, 2, 3, 3, 0, 4, 4, 4};
  objects.structure_of_point = {0, 0, 0, 2, 2, 0, 4, 4, 4};
  objects.surfaces.resize(4);
  for (std::size_t i = 0; i < 4; ++i)
    objects.surfaces[i].floor_distance = static_cast<float>(i + 1);
  separateRemainder(objects, 2);
  EXPECT_EQ(objects.object_of_point,
            (std::vector<std::uint32_t>{1, 1, 0, 2, 2, 0, 0, 0, 0}));
  EXPECT_EQ(objects.structure_of_point,
            (std::vector<std::uint32_t>{0, 0, 4, 2, 2, 0, 4, 4, 4}));
  ASSERT_EQ(objects.surfaces.size(), 2u);
  EXPECT_EQ(objects.surfaces[0].floor_distance, 1.0f);
  EXPECT_EQ(objects.surfaces[1].floor_distance, 3.0f);
}

TEST(ObjectRemainder, MayBeAllOrNothing)
{
  RoomObjects objects;
  objects.object_of_point = {1, 1, 2};
  objects.structure_of_point = {0, 0, 1};
  objects.surfaces.resize(2);
  auto kept = objects;
  separateRemainder(kept, 1);
  EXPECT_EQ(kept.object_of_point, objects.object_of_point);
  separateRemainder(objects, 3);
  EXPECT_EQ(objects.object_of_point, (std::vector<std::uint32_t>{0, 0, 0}));
  EXPECT_TRUE(objects.surfaces.empty());
}
