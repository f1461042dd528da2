/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/split/slice_counts.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl {
namespace indoor {

constexpr double min_seam_side = 0.35; ///< of a segment beside a seam, metres

/** The points of a segment along one level direction, counted in thin slices. */
class SeamProfile {
public:
  static constexpr std::ptrdiff_t per_voxel = 8; // slices

  /** \param[in] places whose first two coordinates are level. REQUIRES: points. */
  SeamProfile(const std::vector<Eigen::Vector3f>& places,
              const Eigen::Vector2f& direction,
              double voxel_size);

  const Eigen::Vector2f&
  direction() const
  {
    return direction_;
  }

  float
  along(std::size_t point) const
  {
    return along_[point];
  }

  const SliceGrid&
  grid() const
  {
    return counts_.grid();
  }

  /** Points that the sheet about the beginning of slice i, one voxel wide, has more
   * than the slices of its width beside it. */
  double
  excess(std::ptrdiff_t i) const;

  /** Beginnings of slices about which a sheet lies that the options allow. */
  std::vector<std::ptrdiff_t>
  peaks() const;

private:
  double
  sheet(std::ptrdiff_t i) const;

  double
  before(std::ptrdiff_t i) const;

  double
  behind(std::ptrdiff_t i) const;

  bool
  isPeak(std::ptrdiff_t i) const;

  Eigen::Vector2f direction_;
  std::vector<float> along_;
  SliceCounts counts_;
};

} // namespace indoor
} // namespace pcl
