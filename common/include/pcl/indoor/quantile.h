/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl {
namespace indoor {

/** The standard deviation of normal noise over the median of its absolute values. */
constexpr double deviation_per_median = 1.4826;

/** \brief Get the value that a share of the others does not exceed.
 * \param[in,out] values at least one; put into another order
 * \param[in] share 0 for the smallest, 0.5 for the lower median, 1 for the largest
 */
inline double
quantile(std::vector<double>& values, double share)
{
  const auto place =
      values.begin() +
      static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

} // namespace indoor
} // namespace pcl
