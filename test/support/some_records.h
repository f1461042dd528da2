/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// What the pipeline keeps of its work, for tests of its files.
#pragma once

#include "rooms/scene_record.h"

namespace pcl::indoor {
namespace test {

/** A finished room of two objects with their classes. */
inline tool::FinishedRoom
someRoom()
{
  tool::FinishedRoom room;
  room.objects.object_of_point = {1, 1, 0, 2};
  room.objects.structure_of_point = {0, 0, 4, 2};
  room.objects.voxel_size = 0.03;
  room.measures.resize(2);
  room.measures[1].point_count = 1;
  room.measures[1].upper = {1, 2, 3};
  room.measures[1].upright.yaw = 0.5;
  room.classes = {{3, 0.5f, {{3, 0.5f}, {1, 0.25f}}}, {1, 1.0f, {}}};
  return room;
}

/** A scene of one room on one storey. */
inline Scene
someScene()
{
  Scene scene;
  scene.room_of_point = {1, 0, 1};
  scene.rooms.resize(1);
  scene.rooms[0].label = 1;
  scene.rooms[0].area = 12.5;
  scene.rooms[0].footprint = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {}};
  scene.building.heights = {{0.0, 2.5}};
  scene.building.maps.resize(1);
  scene.building.maps[0].labels = {1, 2, {1, -1}};
  scene.building.room_of = {{0, 1}};
  scene.frame.pose.translation() = Eigen::Vector3d(4, 5, 6);
  scene.frame.offset = Eigen::Vector3d(7, 8, 9);
  scene.frame.metres_per_unit = 0.5;
  scene.report.warnings = {"a warning", ""};
  scene.report.outside = {1};
  return scene;
}

} // namespace test
} // namespace pcl::indoor
