/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/join/kdop.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief A k-DOP: the support of places, how far they reach, in each of the directions
 * of DirectionHulls, metres. */
using KDop50 = KDop<50>;

/** \brief Convex hulls as polytopes whose faces have 50 fixed directions.
 *
 * The directions are the normals of a cube's faces, edges and corners, and those
 * half-way between faces and edges. So 50 numbers, the supports, are a hull (a discrete
 * oriented polytope, k-DOP, of Klosowski et al. 1998). The hull of two sets of places
 * has the larger of each two supports; the intersection of two hulls has the smaller
 * ones.
 *
 * Bodies whose faces have other directions get too large a hull: a cube turned about an
 * edge by up to a quarter of its volume, a cube turned about any axis by up to two
 * thirds, a thin plate by more.
 */
class DirectionHulls {
public:
  DirectionHulls();

  /** \brief Measure how far places reach; the farthest one in a hundred is left out.
   * \param[in] places at least one, metres
   * \param[in] margin added to each support, metres
   */
  KDop50
  kDopOf(const std::vector<Eigen::Vector3f>& places, float margin) const;

  /** \brief Get the exact volume of the polytope, m^3; 0 if it is empty. Takes about 25
   * microseconds. */
  double
  volume(const KDop50& hull) const;

  /** \brief Get the volume of the box around it, along the axes, m^3. */
  double
  boxVolume(const KDop50& hull) const;

private:
  static constexpr std::size_t count = std::tuple_size<KDop50>::value;

  /** How the plane of another face cuts the plane of a face. */
  struct Cut {
    std::size_t face; ///< number of the other face
    double u, v;      ///< its normal along the two directions within this face's plane
    double along;     ///< its normal along this face's normal
  };

  double
  faceArea(const std::array<double, count>& heights,
           std::size_t face,
           double radius) const;

  std::array<Eigen::Vector3d, count> directions_;
  std::array<std::array<Cut, count - 1>, count> cuts_;
};

} // namespace pcl::indoor
