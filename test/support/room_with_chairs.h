/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {
namespace test {

/** All six faces of a box, a point per 3 cm; LabelledPoints::addBox() has no lower one.
 */
inline void
addFaces(const Eigen::Vector3f& low,
         const Eigen::Vector3f& size,
         std::vector<Eigen::Vector3f>& points)
{
  constexpr float step = 0.03f;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (float a = 0; a <= size[u]; a += step)
      for (float b = 0; b <= size[v]; b += step)
        for (const float side : {0.0f, size[axis]}) {
          Eigen::Vector3f point = low;
          point[axis] += side;
          point[u] += a;
          point[v] += b;
          points.push_back(point);
        }
  }
}

/** Floor, ceiling and walls of a room of 4 x 4 m whose corner is at a place. */
inline std::vector<Eigen::Vector3f>
emptyRoom(const Eigen::Vector3f& place)
{
  std::vector<Eigen::Vector3f> points;
  addFaces(place, {4.0f, 4.0f, 2.5f}, points);
  return points;
}

/** The same with four chairs: too few objects for furniture to tell which end is up. */
inline std::vector<Eigen::Vector3f>
roomWithChairs(const Eigen::Vector3f& place)
{
  auto points = emptyRoom(place);
  const auto add = [&](float x, float y, float z, float dx, float dy, float dz) {
    addFaces(place + Eigen::Vector3f(x, y, z), {dx, dy, dz}, points);
  };
  for (const float x : {1.0f, 2.4f})
    for (const bool is_far : {false, true}) {
      const float y = is_far ? 2.6f : 0.9f;
      add(x, y, 0.43f, 0.42f, 0.42f, 0.03f);
      add(x, is_far ? y + 0.4f : y - 0.02f, 0.43f, 0.42f, 0.03f, 0.45f);
      for (const float dx : {0.0f, 0.38f})
        for (const float dy : {0.0f, 0.38f})
          add(x + dx, y + dy, 0.0f, 0.04f, 0.04f, 0.43f);
    }
  return points;
}

/** The other way up. */
inline std::vector<Eigen::Vector3f>
upsideDown(std::vector<Eigen::Vector3f> points)
{
  for (auto& point : points)
    point = {point.x(), -point.y(), -point.z()};
  return points;
}

} // namespace test
} // namespace pcl::indoor
