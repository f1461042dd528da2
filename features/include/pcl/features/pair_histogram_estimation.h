/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/console/print.h>
#include <pcl/features/feature.h>
#include <pcl/features/impl/oriented_points.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief What EPPFEstimation and SurfletPairEstimation have in common: one histogram
 * of all points in the indices that are usable, with their normals.
 * \ingroup features
 */
template <typename PointInT, typename PointNT, typename PointOutT>
class PairHistogramEstimation
: public FeatureFromNormals<PointInT, PointNT, PointOutT> {
public:
  using PointCloudOut = typename Feature<PointInT, PointOutT>::PointCloudOut;

  /** \brief Compute the descriptor of all points in the indices. Shadows
   * Feature::compute(), which would first allocate one output point per input point.
   * \param[out] output one descriptor; all NaN if no two usable points differ in
   * position; empty after an error
   */
  void
  compute(PointCloudOut& output)
  {
    output.clear();
    if (!initCompute())
      return;
    output.header = input_->header;
    computeFeature(output);
    this->deinitCompute();
  }

protected:
  using Feature<PointInT, PointOutT>::input_;
  using Feature<PointInT, PointOutT>::indices_;
  using Feature<PointInT, PointOutT>::feature_name_;
  using FeatureFromNormals<PointInT, PointNT, PointOutT>::normals_;

  explicit PairHistogramEstimation(const char* name)
  {
    feature_name_ = name;
    this->k_ = 1; // the base wants neighbours, although there are none
  }

  /** \brief Check input, normals and parameters. */
  bool
  initCompute() override
  {
    // Not through the base, which would build a search tree that takes longer than all
    // else.
    std::string problem = "No input cloud was given.";
    if (PCLBase<PointInT>::initCompute())
      problem = findProblem(*input_, normals_.get(), *indices_);
    if (problem.empty())
      problem = findOptionsProblem();
    if (problem.empty())
      return true;
    PCL_ERROR("[pcl::%s::initCompute] %s\n", feature_name_.c_str(), problem.c_str());
    this->deinitCompute();
    return false;
  }

private:
  /** \brief Say what is wrong with the parameters: "" if nothing. */
  virtual std::string
  findOptionsProblem() const = 0;

  /** \brief Get as many numbers as the output has, all NaN if there is no pair. */
  virtual std::vector<float>
  histogramOf(const std::vector<OrientedPoint>& points) const = 0;

  void
  computeFeature(PointCloudOut& output) override
  {
    const auto histogram = histogramOf(orientedPoints(*input_, *normals_, *indices_));
    output.resize(1);
    std::copy(histogram.begin(), histogram.end(), output[0].histogram);
    output.is_dense = std::isfinite(histogram.front());
  }
};

} // namespace pcl::indoor
