/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>

#include <random>
#include <vector>

namespace pcl::indoor {

inline const Eigen::Vector3f box_size(1.0f, 0.6f, 0.3f);

inline float
drawBetween(float low, float high, std::mt19937& rng)
{
  return low + (high - low) * (static_cast<float>(rng() % 1000003) / 1000003.0f);
}

/** \brief Points anywhere in the unit cube with normals anyhow. */
inline std::vector<OrientedPoint>
randomSurflets(std::size_t count, std::uint32_t seed)
{
  std::mt19937 rng(seed);
  std::vector<OrientedPoint> points(count);
  for (auto& point : points) {
    for (int axis = 0; axis < 3; ++axis)
      point.position[axis] = drawBetween(0.0f, 1.0f, rng);
    do
      for (int axis = 0; axis < 3; ++axis)
        point.normal[axis] = drawBetween(-1.0f, 1.0f, rng);
    while (!(point.normal.norm() > 0.1f));
    point.normal.normalize();
  }
  return points;
}

/** \brief Points on the faces of a box, each face equally often, normals outwards. */
inline std::vector<OrientedPoint>
boxSurface(const Eigen::Vector3f& size, std::size_t count, std::uint32_t seed)
{
  std::mt19937 rng(seed);
  std::vector<OrientedPoint> points(count);
  for (auto& point : points) {
    for (int axis = 0; axis < 3; ++axis)
      point.position[axis] = drawBetween(0.0f, size[axis], rng);
    const int axis = static_cast<int>(rng() % 3);
    const bool upper = rng() % 2 == 0;
    point.position[axis] = upper ? size[axis] : 0.0f;
    point.normal[axis] = upper ? 1.0f : -1.0f;
  }
  return points;
}

/** \brief The same with nearly Gaussian noise (a sum of twelve) on every coordinate. */
inline std::vector<OrientedPoint>
noisyBox(const Eigen::Vector3f& size,
         float deviation,
         std::size_t count,
         std::uint32_t seed)
{
  auto points = boxSurface(size, count, seed);
  std::mt19937 rng(seed + 1);
  for (auto& point : points)
    for (int axis = 0; axis < 3; ++axis)
      for (int part = 0; part < 12; ++part)
        point.position[axis] += drawBetween(-0.5f, 0.5f, rng) * deviation;
  return points;
}

} // namespace pcl::indoor
