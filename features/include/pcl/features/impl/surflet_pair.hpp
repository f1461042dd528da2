/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/console/print.h>
#include <pcl/features/impl/oriented_points.hpp>
#include <pcl/features/surflet_pair.h>
#include <pcl/indoor/exports.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

namespace pcl {

template <typename PointInT, typename PointNT, typename PointOutT>
SurfletPairEstimation<PointInT, PointNT, PointOutT>::SurfletPairEstimation()
{
  feature_name_ = "SurfletPairEstimation";
  k_ = 1; // the base wants neighbours, although there are none
  if (std::is_same<PointOutT, SurfletPairSignature1296>::value)
    options_.bin_count = 6;
}

template <typename PointInT, typename PointNT, typename PointOutT>
void
SurfletPairEstimation<PointInT, PointNT, PointOutT>::compute(PointCloudOut& output)
{
  output.clear();
  if (!initCompute())
    return;
  output.header = input_->header;
  computeFeature(output);
  Feature<PointInT, PointOutT>::deinitCompute();
}

template <typename PointInT, typename PointNT, typename PointOutT>
bool
SurfletPairEstimation<PointInT, PointNT, PointOutT>::initCompute()
{
  // Not through the base, which would build a search tree that takes longer than all
  // else.
  if (!PCLBase<PointInT>::initCompute()) {
    PCL_ERROR("[pcl::SurfletPairEstimation::initCompute] No input cloud was given.\n");
    return false;
  }
  auto problem = indoor::findProblem(*input_, normals_.get(), *indices_);
  if (problem.empty())
    problem = indoor::findProblem(options_);
  if (!problem.empty()) {
    PCL_ERROR("[pcl::SurfletPairEstimation::initCompute] %s.\n", problem.c_str());
    this->deinitCompute();
    return false;
  }
  return true;
}

template <typename PointInT, typename PointNT, typename PointOutT>
void
SurfletPairEstimation<PointInT, PointNT, PointOutT>::computeFeature(
    PointCloudOut& output)
{
  const auto points = indoor::orientedPoints(*input_, *normals_, *indices_);
  const auto histogram = indoor::surfletPairHistogram(points, options_);
  output.resize(1);
  std::copy(histogram.begin(), histogram.end(), output[0].histogram);
  output.is_dense = std::isfinite(histogram.front());
}

} // namespace pcl

#define PCL_INSTANTIATE_SurfletPairEstimation(T, NT, OutT)                             \
  template class PCL_INDOOR_EXPORTS pcl::SurfletPairEstimation<T, NT, OutT>;
