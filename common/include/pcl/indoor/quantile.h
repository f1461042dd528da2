/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <algorithm>
#include <cstddef>

namespace pcl::indoor {

/** The standard deviation of normal noise over the median of its absolute values. */
constexpr double deviation_per_median = 1.4826;

/** So many standard deviations are chance: of normal noise 0.3 % is farther off. */
constexpr double chance_deviations = 3;

/** \brief Get the value that so many others do not exceed, in linear time.
 * \param[in,out] values more than \a rank; put into another order
 */
template <typename Values>
auto
valueAtRank(Values& values, std::size_t rank)
{
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/** \brief Get the median, of an even number the upper one.
 * \param[in,out] values at least one; put into another order
 */
template <typename Values>
auto
median(Values& values)
{
  return valueAtRank(values, values.size() / 2);
}

/** \brief Get the value that a share of the others does not exceed.
 * \param[in,out] values at least one; put into another order
 * \param[in] share 0 for the smallest, 0.5 for the lower median, 1 for the largest
 */
template <typename Values>
auto
quantile(Values& values, double share)
{
  return valueAtRank(
      values, static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

/** \brief Get the length within which 98 % of the values lie: the others, 1 % at each
 * end, are strays.
 * \param[in,out] values at least one; put into another order
 */
template <typename Values>
auto
extentWithoutStrays(Values& values)
{
  const auto strays = values.size() / 100;
  const auto low = valueAtRank(values, strays);
  return valueAtRank(values, values.size() - 1 - strays) - low;
}

} // namespace pcl::indoor
