/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/console/print.h>
#include <pcl/features/eppf.h>
#include <pcl/features/impl/oriented_points.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace pcl {

template <typename PointInT, typename PointNT, typename PointOutT>
EPPFEstimation<PointInT, PointNT, PointOutT>::EPPFEstimation()
{
  feature_name_ = "EPPFEstimation";
  k_ = 1; // the base wants neighbours, although there are none
  if (std::is_same<PointOutT, EPPFSignature540>::value)
    options_.bins = {15, 3, 4, 3};
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
  const auto reject = [this](const char* format, auto... values) {
    PCL_ERROR(format, values...);
    this->deinitCompute();
    return false;
  };
  if (input_->empty() || indices_->empty())
    return reject("[pcl::EPPFEstimation::initCompute] The input cloud is empty.\n");
  if (!normals_)
    return reject("[pcl::EPPFEstimation::initCompute] No normals were given.\n");
  if (normals_->size() != input_->size())
    return reject(
        "[pcl::EPPFEstimation::initCompute] %zu normals do not fit %zu points.\n",
        static_cast<std::size_t>(normals_->size()),
        static_cast<std::size_t>(input_->size()));
  const auto outside =
      std::find_if(indices_->begin(), indices_->end(), [this](index_t index) {
        return index < 0 || static_cast<std::size_t>(index) >= input_->size();
      });
  if (outside != indices_->end())
    return reject(
        "[pcl::EPPFEstimation::initCompute] Index %ld is outside the cloud.\n",
        static_cast<long>(*outside));
  if (options_.bins.size() != static_cast<std::size_t>(PointOutT::descriptorSize()))
    return reject(
        "[pcl::EPPFEstimation::initCompute] %zu bins do not fit the output of %d.\n",
        options_.bins.size(),
        PointOutT::descriptorSize());
  const auto problem = indoor::whatIsWrong(options_);
  if (!problem.empty())
    return reject("[pcl::EPPFEstimation::initCompute] %s.\n", problem.c_str());
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
  template class PCL_EXPORTS pcl::EPPFEstimation<T, NT, OutT>;
