/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/eppf.h>
#include <pcl/indoor/exports.h>

#include <string>
#include <type_traits>
#include <vector>

namespace pcl {

template <typename PointInT, typename PointNT, typename PointOutT>
EPPFEstimation<PointInT, PointNT, PointOutT>::EPPFEstimation()
: indoor::PairHistogramEstimation<PointInT, PointNT, PointOutT>("EPPFEstimation")
{
  if (std::is_same<PointOutT, EPPFSignature540>::value)
    options_ = indoor::shortEPPFOptions();
  if (std::is_same<PointOutT, PairHarmonicsSignature1200>::value)
    options_ = indoor::pairHarmonicsOptions();
}

template <typename PointInT, typename PointNT, typename PointOutT>
std::string
EPPFEstimation<PointInT, PointNT, PointOutT>::findOptionsProblem() const
{
  const auto problem = indoor::findProblem(options_);
  if (!problem.empty())
    return problem;
  const auto size = static_cast<std::size_t>(PointOutT::descriptorSize());
  if (options_.bins.size() != size)
    return std::to_string(options_.bins.size()) + " bins do not fit an output of " +
           std::to_string(size) + ".";
  constexpr bool is_for_harmonics =
      std::is_same<PointOutT, PairHarmonicsSignature1200>::value;
  if (!is_for_harmonics && options_.bins.harmonics.size() > 0)
    return "An EPPF signature holds pairs alone, no harmonics.";
  return {};
}

template <typename PointInT, typename PointNT, typename PointOutT>
std::vector<float>
EPPFEstimation<PointInT, PointNT, PointOutT>::histogramOf(
    const std::vector<indoor::OrientedPoint>& points) const
{
  return indoor::eppfHistogram(points, options_);
}

} // namespace pcl

#define PCL_INSTANTIATE_EPPFEstimation(T, NT, OutT)                                    \
  template class PCL_INDOOR_EXPORTS pcl::EPPFEstimation<T, NT, OutT>;
