/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/console/print.h>
#include <pcl/features/eppf.h>
#include <pcl/features/impl/oriented_points.hpp>
#include <pcl/indoor/exports.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

namespace pcl {

template <typename PointInT, typename PointNT, typename PointOutT>
EPPFEstimation<PointInT, PointNT, PointOutT>::EPPFEstimation()
{
  feature_name_ = "EPPFEstimation";
  k_ = 1; // the base wants neighbours, although there are none
  if (std::is_same<PointOutT, EPPFSignature540>::value)
    options_ = indoor::shortEPPFOptions();
  if (std::is_same<PointOutT, PairHarmonicsSignature1200>::value)
    options_ = indoor::pairHarmonicsOptions();
}

template <typename PointInT, typename PointNT, typename PointOutT>
void
EPPFEstimation<PointInT, PointNT, PointOutT>::compute(PointCloudOut& output)
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
EPPFEstimation<PointInT, PointNT, PointOutT>::initCompute()
{
  // Not through the base, which would build a search tree that takes longer than all
  // else.
  if (!PCLBase<PointInT>::initCompute()) {
    PCL_ERROR("[pcl::EPPFEstimation::initCompute] No input cloud was given.\n");
    return false;
  }
  auto problem = indoor::findProblem(*input_, normals_.get(), *indices_);
  if (problem.empty())
    problem = indoor::findProblem(options_);
  const auto size = static_cast<std::size_t>(PointOutT::descriptorSize());
  if (problem.empty() && options_.bins.size() != size)
    problem = std::to_string(options_.bins.size()) + " bins do not fit an output of " +
              std::to_string(size);
  constexpr bool is_for_harmonics =
      std::is_same<PointOutT, PairHarmonicsSignature1200>::value;
  if (problem.empty() && !is_for_harmonics && options_.bins.harmonics.size() > 0)
    problem = "An EPPF signature holds pairs alone, no harmonics";
  if (!problem.empty()) {
    PCL_ERROR("[pcl::EPPFEstimation::initCompute] %s.\n", problem.c_str());
    this->deinitCompute();
    return false;
  }
  return true;
}

template <typename PointInT, typename PointNT, typename PointOutT>
void
EPPFEstimation<PointInT, PointNT, PointOutT>::computeFeature(PointCloudOut& output)
{
  const auto points = indoor::orientedPoints(*input_, *normals_, *indices_);
  const auto histogram = indoor::eppfHistogram(points, options_);
  output.resize(1);
  std::copy(histogram.begin(), histogram.end(), output[0].histogram);
  output.is_dense = std::isfinite(histogram.front());
}

} // namespace pcl

#define PCL_INSTANTIATE_EPPFEstimation(T, NT, OutT)                                    \
  template class PCL_INDOOR_EXPORTS pcl::EPPFEstimation<T, NT, OutT>;
