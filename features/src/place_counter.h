/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>
#include <pcl/features/surface_places.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Puts the points of an object into the bins of surfacePlaces(). */
class PlaceCounter {
public:
  static constexpr std::size_t block_size = 128; ///< points that are counted together

  PlaceCounter(const PrincipalFrame& frame, double scale, const PlaceBins& bins);

  /** \brief Count some points.
   * \param[in] points all of them
   * \param[in,out] counts first of the bins of places, in units of 2^-16 points
   */
  void
  count(const std::vector<OrientedPoint>& points,
        std::size_t first,
        std::size_t last,
        std::uint64_t* counts) const;

private:
  void
  count(const OrientedPoint& point, std::uint64_t* counts) const;

  Eigen::Vector3f center_;
  Eigen::Matrix3f axes_;
  std::array<int, 3> counts_;
  std::array<std::uint32_t, 3> strides_;
  std::array<float, 3> bins_per_metre_;
};

} // namespace indoor
} // namespace pcl
