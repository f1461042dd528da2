/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/object_seams.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** The points of a segment along one level direction, counted in thin slices. */
class SeamProfile {
public:
  static constexpr std::ptrdiff_t per_voxel = 8; // slices

  /** \param[in] places whose first two coordinates are level. REQUIRES: points. */
  SeamProfile(const std::vector<Eigen::Vector3f>& places,
              const Eigen::Vector2f& direction,
              const ObjectSeamOptions& options);

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

  /** Where slice i begins. */
  float
  placeOf(std::ptrdiff_t i) const
  {
    return static_cast<float>(low_ + static_cast<double>(i) * width());
  }

  std::ptrdiff_t
  sliceAt(float place) const
  {
    return static_cast<std::ptrdiff_t>((place - low_) / width());
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
  width() const
  {
    return options_.voxel_size / per_voxel;
  }

  std::ptrdiff_t
  size() const
  {
    return static_cast<std::ptrdiff_t>(sums_.size()) - 1;
  }

  double
  held(std::ptrdiff_t begin, std::ptrdiff_t end) const;

  double
  sheet(std::ptrdiff_t i) const;

  double
  before(std::ptrdiff_t i) const;

  double
  behind(std::ptrdiff_t i) const;

  bool
  isPeak(std::ptrdiff_t i) const;

  const ObjectSeamOptions& options_;
  Eigen::Vector2f direction_;
  double low_ = 0;
  std::vector<float> along_;
  std::vector<std::uint64_t> sums_; // of all slices before
};

} // namespace indoor
} // namespace pcl
