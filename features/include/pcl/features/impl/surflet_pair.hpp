/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/surflet_pair.h>
#include <pcl/indoor/exports.h>

#include <string>
#include <type_traits>
#include <vector>

namespace pcl {

template <typename PointInT, typename PointNT, typename PointOutT>
SurfletPairEstimation<PointInT, PointNT, PointOutT>::SurfletPairEstimation()
: indoor::PairHistogramEstimation<PointInT, PointNT, PointOutT>("SurfletPairEstimation")
{
  if (std::is_same<PointOutT, SurfletPairSignature1296>::value)
    options_.bin_count = 6;
}

template <typename PointInT, typename PointNT, typename PointOutT>
std::string
SurfletPairEstimation<PointInT, PointNT, PointOutT>::findOptionsProblem() const
{
  return indoor::findProblem(options_);
}

template <typename PointInT, typename PointNT, typename PointOutT>
std::vector<float>
SurfletPairEstimation<PointInT, PointNT, PointOutT>::histogramOf(
    const std::vector<indoor::OrientedPoint>& points) const
{
  return indoor::surfletPairHistogram(points, options_);
}

} // namespace pcl

#define PCL_INSTANTIATE_SurfletPairEstimation(T, NT, OutT)                             \
  template class PCL_INDOOR_EXPORTS pcl::SurfletPairEstimation<T, NT, OutT>;
