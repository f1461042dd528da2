/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

namespace pcl::indoor {

/** \brief Largest coordinate that is computed with, metres: the product of four
 * distances within it is finite in a float. */
constexpr float largest_coordinate = 1e9f;

/** \brief Tell whether a point can be computed with: all coordinates are finite and
 * none is beyond the largest. */
inline bool
isUsable(const Eigen::Vector3f& position)
{
  return (position.array().abs() <= largest_coordinate).all(); // false for NaN
}

/** \brief The same of a point with x, y and z. */
template <typename PointT>
bool
isUsablePoint(const PointT& point)
{
  return isUsable(Eigen::Vector3f(point.getVector3fMap()));
}

} // namespace pcl::indoor
