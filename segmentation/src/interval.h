/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "quantile.h"

#include <algorithm>
#include <vector>

namespace pcl {
namespace indoor {

/** From where to where something reaches along an axis. */
struct Interval {
  double low = 0, high = 0;

  double
  length() const
  {
    return high - low;
  }

  bool
  holds(double place) const
  {
    return place > low && place < high;
  }

  Interval
  widened(double by) const
  {
    return {low - by, high + by};
  }
};

/** Negative if they have nothing in common. */
inline Interval
commonPart(const Interval& a, const Interval& b)
{
  return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/** What two intervals have in common, over the length of both together. */
inline double
commonShare(const Interval& a, const Interval& b)
{
  return commonPart(a, b).length() /
         (std::max(a.high, b.high) - std::min(a.low, b.low));
}

/** Share of a segment's voxels that is cut off at either end. */
constexpr double outlier_share = 0.03;

/** The range of some places without the outermost of them.
 * \param[in,out] places at least one; put into another order */
inline Interval
trimmedRange(std::vector<double>& places)
{
  const double low = quantile(places, outlier_share);
  return {low, quantile(places, 1 - outlier_share)};
}

} // namespace indoor
} // namespace pcl
