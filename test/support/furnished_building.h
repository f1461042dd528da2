/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "support/synthetic_scenes.h"

#include <pcl/segmentation/room_objects.h>

#include <limits>

namespace pcl::indoor::test {

inline PointCloud<PointXYZ>::Ptr
cloudOf(const std::vector<Eigen::Vector3f>& positions)
{
  auto cloud = pcl::make_shared<PointCloud<PointXYZ>>();
  for (const auto& position : positions)
    cloud->push_back(PointXYZ(position.x(), position.y(), position.z()));
  return cloud;
}

/** Two furnished rooms and a board 10 m away; every 50th point of the rooms is in none,
 * as are those of the board. */
struct Building {
  Building()
  : scene(twoRooms())
  , room_of_point(scene.objects)
  {
    for (std::size_t i = 0; i < room_of_point.size(); i += 50)
      room_of_point[i] = 0;
    for (int i = 0; i < 40 * 40; ++i) {
      scene.points.emplace_back(0.03f * (i / 40), -10.0f, 1.1f + 0.03f * (i % 40));
      room_of_point.push_back(0);
    }
    group_of_point = withSurroundings(scene.points, room_of_point);
    cloud = cloudOf(scene.points);
    (*cloud)[7].x = std::numeric_limits<float>::quiet_NaN();
  }

  LabelledPoints scene;
  PointCloud<PointXYZ>::Ptr cloud;
  std::vector<std::uint32_t> room_of_point, group_of_point;
};

/** The points of a room with its surroundings; of 0 those in none. */
inline RoomPoints
room(const Building& building, std::uint32_t number)
{
  RoomPoints points;
  for (std::size_t i = 0; i < building.cloud->size(); ++i)
    if (building.group_of_point[i] == number && i != 7)
      points.positions.push_back(building.scene.points[i]);
  return points;
}

} // namespace pcl::indoor::test
