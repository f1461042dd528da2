/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cmath>
#include <vector>

namespace pcl::indoor {

/** \brief The L1 distance of two histograms. */
template <typename A, typename B>
double
difference(const std::vector<A>& a, const std::vector<B>& b)
{
  double sum = 0.0;
  for (std::size_t bin = 0; bin < a.size(); ++bin)
    sum += std::abs(static_cast<double>(a[bin]) - static_cast<double>(b[bin]));
  return sum;
}

/** \brief Mean of the L1 distance between two histograms of n independent pairs each.
 *
 * Each of two counts of a bin of probability p is binomial; their difference over n has
 * the variance 2 p (1 - p) / n and, for its magnitude, at most the square root of it as
 * its mean (Jensen). The weights of Eq. (5.11) differ by at most their ratio.
 */
inline double
samplingBound(const std::vector<float>& histogram, double pair_count)
{
  double sum = 0.0;
  for (const double p : histogram)
    sum += std::sqrt(2.0 * p * (1.0 - p) / pair_count);
  return sum;
}

} // namespace pcl::indoor
