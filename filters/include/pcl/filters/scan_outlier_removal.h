/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/filters/filter_indices.h>
#include <pcl/filters/scan_outliers.h>

namespace pcl {

/** \brief Removes the points of a scan that lie alone: reflections, ghost points,
 * noise.
 *
 * What PCL's RadiusOutlierRemoval and StatisticalOutlierRemoval do, one after the
 * other, with parameters that follow from the resolution of the cloud, so that none has
 * to be set. Where the density of a scan varies more than threefold, raise the radius
 * or the deviations, or sparse surfaces are removed. Coordinates may be large (UTM).
 * Cost: a search tree and a search per point for each of three passes.
 * \note The method: D. Bobkov, "Semantic Understanding of 3D Point Clouds of Indoor
 * Environments", TUM 2019, Sec. 2.1.5.1.
 * \ingroup filters
 */
template <typename PointT>
class ScanOutlierRemoval : public FilterIndices<PointT> {
public:
  using Ptr = shared_ptr<ScanOutlierRemoval<PointT>>;
  using ConstPtr = shared_ptr<const ScanOutlierRemoval<PointT>>;

  /** \param[in] extract_removed_indices collect them for getRemovedIndices() */
  explicit ScanOutlierRemoval(bool extract_removed_indices = false);

  /** \brief Set the radius within which a point must have neighbours.
   * \param[in] radius metres, positive; 0 (default) for that of Eq. (2.9), see
   * indoor::neighborhoodRadius(). Larger removes less.
   */
  void
  setRadiusSearch(double radius)
  {
    options_.radius = radius;
  }

  /** \brief Get the radius as it was set, metres; 0 stands for automatic. */
  double
  getRadiusSearch() const
  {
    return options_.radius;
  }

  /** \brief Set how many other points must lie within the radius.
   * \param[in] count default 2; 0 leaves out this test
   */
  void
  setMinNeighborsInRadius(int count)
  {
    options_.min_neighbors = count;
  }

  /** \brief Get how many other points must lie within the radius. */
  int
  getMinNeighborsInRadius() const
  {
    return options_.min_neighbors;
  }

  /** \brief Set over how many neighbours the mean distance is taken, Eq. (2.1).
   * \param[in] count at least 1 (default 8)
   */
  void
  setMeanK(int count)
  {
    options_.mean_k = count;
  }

  /** \brief Get over how many neighbours the mean distance is taken. */
  int
  getMeanK() const
  {
    return options_.mean_k;
  }

  /** \brief Set how far above the mean of all points a point's mean distance may lie.
   * \param[in] deviations standard deviations, positive (default 3); infinity leaves
   * out this test. Lower removes more, but nothing below twice the mean.
   */
  void
  setStddevMulThresh(double deviations)
  {
    options_.deviations = deviations;
  }

  /** \brief Get the number of standard deviations. */
  double
  getStddevMulThresh() const
  {
    return options_.deviations;
  }

  /** \brief Set the number of threads that find the resolution; 0 (default) for as many
   * as OpenMP offers. */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    options_.threads = threads;
  }

protected:
  using Filter<PointT>::filter_name_;
  using Filter<PointT>::removed_indices_;
  using Filter<PointT>::extract_removed_indices_;
  using FilterIndices<PointT>::negative_;
  using PCLBase<PointT>::indices_;
  using PCLBase<PointT>::input_;

  /** \brief Find the points to keep, or with setNegative() the outliers; points that
   * are not finite are neither. Empty after an error. */
  void
  applyFilter(Indices& indices) override;

private:
  indoor::ScanOutlierOptions options_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/filters/impl/scan_outlier_removal.hpp>
#endif
