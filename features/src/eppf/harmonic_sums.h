/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/surface_harmonics.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Adds up the coefficients of surfaceHarmonics(), block after block. */
class HarmonicSums {
public:
  static constexpr std::size_t block_size = 128; ///< points that are worked on together

  HarmonicSums(const PrincipalFrame& frame, double scale, const HarmonicBins& bins);

  /** \brief Add some points.
   * \param[in] points all of them
   * \param[in,out] sums first of bins.size() sums, in units of 2^-20: integers, whose
   * order does not matter. Those of both signs are two's complements.
   */
  void
  add(const std::vector<OrientedPoint>& points,
      std::size_t first,
      std::size_t last,
      std::uint64_t* sums) const;

  /** \brief The values of surfaceHarmonics().
   * \param[in] sums first of bins.size() sums of all points
   * \param[in] point_count number of points, at least 1
   */
  std::vector<double>
  values(const std::uint64_t* sums, std::size_t point_count) const;

private:
  Eigen::Vector3f center_;
  Eigen::Matrix3f axes_;
  HarmonicBins bins_;
  float shells_per_metre_;
  float distances_per_metre_;
};

} // namespace pcl::indoor
