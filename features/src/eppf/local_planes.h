/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Coordinates of at most 4096 points, evenly along a space-filling order. */
struct PointColumns {
  /** \brief The box of points that follow each other in one of 8^3 cells. */
  struct Block {
    Eigen::Array3f lower, upper;
    std::size_t first = 0, last = 0;
  };

  std::vector<std::uint32_t> indices;
  std::vector<float> x, y, z;
  std::vector<Block> blocks;

  PointColumns(const std::vector<OrientedPoint>& points,
               const std::vector<std::uint32_t>& order);

  std::size_t
  size() const
  {
    return x.size();
  }

  Eigen::Vector3f
  at(std::size_t k) const
  {
    return {x[k], y[k], z[k]};
  }

private:
  void
  makeBlocks();
};

/** \brief The plane of a neighbourhood. */
struct LocalPlane {
  Eigen::Vector3f offset; // from the place to the neighbours' mean
  Eigen::Vector3f normal;
  Eigen::Vector3f variances; // ascending, along the normal first

  LocalPlane(const Eigen::Vector3f& mean, const Eigen::Matrix3f& second_moment);

  /** \brief 0 for a plane, 1 for a ball or a round rod. */
  float
  thickness() const
  {
    return variances[1] > 0.0f ? variances[0] / variances[1] : 0.0f;
  }
};

/** \brief Points that a window may reach, side by side. */
struct Nearby {
  std::vector<float> x, y, z;

  /** \brief The points of all blocks within 3 widths of a box; farther ones have a
   * weight below 0.011. */
  void
  gather(const PointColumns& points, const PointColumns::Block& box, float width);
};

/** \brief The plane of the points around a place, weighted by nearly exp(-d^2 / (2
 * width^2)). */
LocalPlane
planeAround(const Nearby& points, const Eigen::Vector3f& place, float width);

/** \brief The plane of the 16 nearest points, itself among them.
 * \param[in] points at least 16
 * \param[in] radius where they are looked for first
 */
LocalPlane
planeOfNearest(const PointColumns& points, std::size_t center, float radius);

/** \brief From 0 at one value to 1 at another one. */
inline float
ramp(float value, float from, float to)
{
  return std::clamp((value - from) / (to - from), 0.0f, 1.0f);
}

/** \brief Mean distance of the points, if their object's surface is a usual one: 3
 * squares of its extent. */
inline float
usualSpacing(std::size_t point_count, float extent)
{
  return extent * std::sqrt(3.0f / static_cast<float>(point_count));
}

} // namespace pcl::indoor
