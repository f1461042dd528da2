/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/eppf_histogram.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <array>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The four features of a pair, f1 to f4 of Sec. 5.2.1. */
using PairFeatures = std::array<double, 4>;

/** \brief Pearson's correlation of each pair of features, Eq. (5.9), over all pairs of
 * points that were added, in one pass. */
class FeatureMoments {
public:
  void
  add(const PairFeatures& features);

  /** \brief The correlations (f1 f2), (f1 f3), (f1 f4), (f2 f3), (f2 f4), (f3 f4); 0
   * where a feature never changes. */
  std::array<double, 6>
  correlations() const;

private:
  double count_ = 0;
  PairFeatures mean_{};
  std::array<PairFeatures, 4> products_{}; // of differences from the means; upper half
};

/** \brief The correlations over all pairs of all objects together, as the thesis has
 * them. Each object has as many pairs as the options say, drawn uniformly, and the
 * thesis's features on its grid of 64 voxels; f1 is in units of the options' scale, or
 * of the object's extent where that is 0. */
std::array<double, 6>
featureCorrelation(const std::vector<PointCloud<PointNormal>::Ptr>& objects,
                   const EPPFOptions& options);

/** \brief One line with the mean of the magnitudes and each correlation. */
std::string
correlationText(const std::array<double, 6>& correlations);

/** \brief The extent of an object: see objectExtent(). */
double
extentOf(const PointCloud<PointNormal>& object);

} // namespace pcl::indoor::tool
