/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief How far places reach in each of the directions of DirectionHulls, metres. */
using HullReach = std::array<float, 50>;

/** \brief Convex hulls as polytopes whose faces have 50 fixed directions.
 * The directions are the normals of a cube's faces, edges and corners, and those
 * half-way between the first two kinds. A hull is then no more than 50 numbers: that of
 * two sets of places has the larger of each two reaches, and what two hulls have in
 * common the smaller. Hulls whose faces
 * have other directions come out too large: cubes turned about an edge by up to a
 * quarter, about any axis by up to two thirds, thin plates by more.
 */
class DirectionHulls {
public:
  /** \param[in] axes three orthogonal unit directions, one per column: boxes along them
   * are exact */
  explicit DirectionHulls(const Eigen::Matrix3f& axes);

  /** \brief Measure how far places reach; of each hundred one is taken for an outlier.
   * \param[in] places at least one, metres
   * \param[in] margin added to each reach, metres
   */
  HullReach
  reachOf(const std::vector<Eigen::Vector3f>& places, float margin) const;

  /** \brief Get the exact volume of the polytope, m^3; 0 if it is empty. Takes about 25
   * microseconds. */
  double
  volume(const HullReach& reach) const;

  /** \brief Get the volume of the box around it, along the axes, m^3. */
  double
  boxVolume(const HullReach& reach) const;

private:
  static constexpr std::size_t count = std::tuple_size<HullReach>::value;

  /** How another face's plane cuts the plane of a face. */
  struct Cut {
    std::size_t face; ///< the other
    double u, v;      ///< its normal in the plane's two directions
    double along;     ///< and along the face's normal
  };

  double
  faceArea(const std::array<double, count>& heights,
           std::size_t face,
           double radius) const;

  Eigen::Matrix3f axes_;
  std::array<Eigen::Vector3d, count> directions_; // in the frame of the axes
  std::array<std::array<Cut, count - 1>, count> cuts_;
};

/** \brief Get the hull of two sets of places. */
HullReach
hullOfBoth(const HullReach& a, const HullReach& b);

/** \brief Get what two hulls have in common; its reaches may be too long. */
HullReach
commonHull(const HullReach& a, const HullReach& b);

} // namespace indoor
} // namespace pcl
