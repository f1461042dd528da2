/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "support/labelled_points.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace pcl::indoor {
namespace test {

/** The free space of a room, or of a part of it; the points of its faces get the
 * room's number. */
struct RoomBox {
  Eigen::Vector3f low;
  Eigen::Vector3f high;
  std::uint32_t room;
};

/** A part of walls without points: a doorway, or where two parts of a room meet. */
using Opening = Eigen::AlignedBox3f;

/** A doorway seen from above: all of the wall it cuts, and its height. */
inline Opening
doorway(float x0, float x1, float y0, float y1, float height)
{
  // It starts above the floor's noise, so that the floor stays whole.
  return {Eigen::Vector3f(x0, y0, 0.05f), Eigen::Vector3f(x1, y1, height)};
}

/** Where two parts of one room meet: nothing is left of the wall, from below the floor
 * to above the ceiling. */
inline Opening
junction(float x0, float x1, float y0, float y1)
{
  return {Eigen::Vector3f(x0, y0, -1.0f), Eigen::Vector3f(x1, y1, 9.0f)};
}

/** Six faces of every box; LabelledPoints::objects holds the rooms. */
inline LabelledPoints
rooms(const std::vector<RoomBox>& boxes,
      const std::vector<Opening>& openings,
      float spacing = 0.04f,
      float noise = 0.005f,
      unsigned seed = 1)
{
  std::mt19937 rng(seed);
  LabelledPoints all;
  for (const auto& box : boxes) {
    const Eigen::Vector3f size = box.high - box.low;
    all.addBox(box.low, size, box.room, spacing, noise, rng);
    all.addRectangle(box.low,
                     {size.x(), 0, 0},
                     {0, size.y(), 0},
                     {0, 0, -1},
                     box.room,
                     spacing,
                     noise,
                     rng);
  }
  LabelledPoints kept;
  for (std::size_t i = 0; i < all.points.size(); ++i) {
    bool open = false;
    for (const auto& opening : openings)
      open = open || opening.contains(all.points[i]);
    if (open)
      continue;
    kept.points.push_back(all.points[i]);
    kept.normals.push_back(-all.normals[i]); // a room is seen from within
    kept.objects.push_back(all.objects[i]);
  }
  return kept;
}

/** The doorway of twoRooms(): 0.9 m wide, 2 m high, below a lintel. */
inline Opening
doorOfTwoRooms()
{
  return doorway(3.95f, 4.15f, 1.2f, 2.1f, 2.0f);
}

/** Rooms of 4 m x 3 m (1) and 3 m x 3 m (2), 2.5 m high, with a door in the wall of 10
 * cm between them; a table stands in the first and a cabinet in the second. */
inline LabelledPoints
twoRooms(float noise = 0.005f, float spacing = 0.04f)
{
  auto scene = rooms({{{0, 0, 0}, {4, 3, 2.5f}, 1}, {{4.1f, 0, 0}, {7.1f, 3, 2.5f}, 2}},
                     {doorOfTwoRooms()},
                     spacing,
                     noise);
  std::mt19937 rng(2);
  scene.addBox({1, 1, 0}, {1.4f, 0.8f, 0.75f}, 1, spacing, noise, rng);
  scene.addBox({5.5f, 2.4f, 0}, {1.2f, 0.5f, 1.8f}, 2, spacing, noise, rng);
  return scene;
}

/** The doorways of bentCorridorWithThreeRooms(). */
inline std::vector<Opening>
bentCorridorDoors()
{
  return {doorway(1.5f, 2.4f, 1.55f, 1.75f, 2.0f),
          doorway(5.5f, 6.4f, 1.55f, 1.75f, 2.0f),
          doorway(9.65f, 9.85f, 3.0f, 3.9f, 2.0f)};
}

/** A corridor bent to an L (4) with three rooms (1, 2, 3) along it, a door to each. */
inline LabelledPoints
bentCorridorWithThreeRooms(float noise = 0.005f, float spacing = 0.05f)
{
  auto openings = bentCorridorDoors();
  openings.push_back(junction(8.05f, 9.75f, 1.55f, 1.65f));
  return rooms({{{0, 1.7f, 0}, {4, 5.2f, 2.5f}, 1},
                {{4.1f, 1.7f, 0}, {8, 5.2f, 2.5f}, 2},
                {{9.8f, 1.7f, 0}, {13, 5.2f, 2.5f}, 3},
                {{0, 0, 0}, {9.7f, 1.6f, 2.5f}, 4},
                {{8.1f, 1.6f, 0}, {9.7f, 7, 2.5f}, 4}},
               openings,
               spacing,
               noise);
}

/** Points turned about the z axis, radians, counter-clockwise. */
inline std::vector<Eigen::Vector3f>
turned(const std::vector<Eigen::Vector3f>& points, double yaw)
{
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  std::vector<Eigen::Vector3f> result;
  result.reserve(points.size());
  for (const auto& point : points)
    result.push_back((rotation * point.cast<double>()).cast<float>());
  return result;
}

} // namespace test
} // namespace pcl::indoor
