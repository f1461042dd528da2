/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl_indoor_ros/occupancy_grid.h>

#include "ros2/messages.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

using namespace pcl::indoor;

TEST(OccupancyGrid, HasTheCellsOfTheStoreyInItsPlace)
{
  const auto maps = storeyMaps(test::SmallScene::json().dump(), 0.1, false);
  ASSERT_EQ(maps.size(), 2u);
  test::Header header;
  header.frame_id = "map";
  header.stamp.sec = 7;
  const auto grid = pcl_indoor_ros::occupancyGrid<test::OccupancyGrid>(
      maps[1], Eigen::Vector3d(100, 200, 10), header);
  EXPECT_EQ(grid.header.frame_id, "map");
  EXPECT_EQ(grid.info.map_load_time.sec, 7);
  EXPECT_FLOAT_EQ(grid.info.resolution, 0.1f);
  EXPECT_EQ(grid.data, maps[1].cells);
  EXPECT_EQ(grid.data.size(), std::size_t(grid.info.width) * grid.info.height);
  EXPECT_NEAR(grid.info.origin.position.x, -0.5, 1e-9); // half a metre around the room
  EXPECT_NEAR(grid.info.origin.position.y, -0.5, 1e-9);
  EXPECT_NEAR(grid.info.origin.position.z, 3.0, 1e-9); // the upper storey
  EXPECT_NEAR(grid.info.origin.orientation.w, 1.0, 1e-9);
  // the middle of the room is free
  const auto cell = [&](double x, double y) {
    const auto row = static_cast<std::size_t>((y + 0.5) / 0.1);
    return grid.data[row * grid.info.width + static_cast<std::size_t>((x + 0.5) / 0.1)];
  };
  EXPECT_EQ(cell(2.0, 1.5), 0);
  EXPECT_EQ(cell(-0.05, 1.5), 100);
  EXPECT_EQ(cell(-0.4, 1.5), -1);
}
