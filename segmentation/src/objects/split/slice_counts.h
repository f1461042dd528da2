/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** Slices of one width along a direction, numbered from 0. */
struct SliceGrid {
  double low = 0;   ///< where slice 0 begins, metres
  double width = 1; ///< metres

  std::ptrdiff_t
  sliceAt(float place) const
  {
    return static_cast<std::ptrdiff_t>((place - low) / width);
  }

  /** Where slice i begins. */
  float
  placeOf(std::ptrdiff_t i) const
  {
    return static_cast<float>(low + static_cast<double>(i) * width);
  }
};

/** How many points lie in slices, from the lowest point to the highest. */
class SliceCounts {
public:
  /** \param[in] along places of the points along the direction. REQUIRES: points. */
  SliceCounts(const std::vector<float>& along, double width)
  {
    const auto [low, high] = std::minmax_element(along.begin(), along.end());
    grid_ = {*low, width};
    sums_.assign(static_cast<std::size_t>(grid_.sliceAt(*high)) + 2, 0);
    for (const auto place : along)
      ++sums_[grid_.sliceAt(place) + 1];
    for (std::size_t i = 1; i < sums_.size(); ++i)
      sums_[i] += sums_[i - 1];
  }

  const SliceGrid&
  grid() const
  {
    return grid_;
  }

  std::ptrdiff_t
  size() const
  {
    return static_cast<std::ptrdiff_t>(sums_.size()) - 1;
  }

  /** Points in slices begin to end, exclusive. REQUIRES: 0 <= begin <= end <= size. */
  double
  held(std::ptrdiff_t begin, std::ptrdiff_t end) const
  {
    return static_cast<double>(sums_[end] - sums_[begin]);
  }

private:
  SliceGrid grid_;
  std::vector<std::uint64_t> sums_; // of all slices before
};

} // namespace pcl::indoor
