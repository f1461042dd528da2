/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/filters/filter_indices.h>
#include <pcl/filters/non_convex_points.h>
#include <pcl/point_cloud.h>

#include <string>

namespace pcl {

/** \brief Removes the points of concave and of noisy regions, or keeps only them.
 *
 * A point goes if its curvature is above a threshold and its neighbours do not lie
 * clearly behind its tangent plane: N+ >= alpha * N-, where N+ and N- count the
 * neighbours in front of and behind the plane. This holds in creases between objects,
 * where surfaces touch, and in noise. What remains falls apart at the borders of
 * objects and can be segmented; the removed points are given back afterwards.
 *
 * The normals must point out of the objects, towards the side they were seen from;
 * their curvature field is used. Cost is linear in the number of points above the
 * threshold.
 * \note The method: D. Bobkov et al., "Noise-resistant Unsupervised Object Segmentation
 * in Multi-view Indoor Point Clouds", VISAPP 2017; here Sec. 4.2.1, Eq. (4.2).
 * Deviations are listed in docs/method/objects.md.
 * \ingroup filters
 */
template <typename PointT, typename PointNT>
class NonConvexPointsRemoval : public FilterIndices<PointT> {
public:
  using Ptr = shared_ptr<NonConvexPointsRemoval<PointT, PointNT>>;
  using ConstPtr = shared_ptr<const NonConvexPointsRemoval<PointT, PointNT>>;
  using PointCloudN = PointCloud<PointNT>;
  using PointCloudNConstPtr = typename PointCloudN::ConstPtr;

  /** \brief Construct the filter.
   * \param[in] extract_removed_indices true to make getRemovedIndices() usable
   */
  explicit NonConvexPointsRemoval(bool extract_removed_indices = false);

  /** \brief Set the normals, one per point of the input cloud, with curvatures.
   * Points whose normal or curvature is not finite are kept.
   */
  void
  setInputNormals(const PointCloudNConstPtr& normals)
  {
    normals_ = normals;
  }

  /** \brief Get the normals that were set; null if none were. */
  PointCloudNConstPtr
  getInputNormals() const
  {
    return normals_;
  }

  /** \brief Set the radius of the neighbourhood that is counted.
   * \param[in] radius metres, positive; 0 (default) for that of Eq. (2.9), see
   * indoor::neighborhoodRadius(). Larger is less sensitive to noise and blurs small
   * objects.
   */
  void
  setRadius(double radius)
  {
    options_.radius = radius;
  }

  /** \brief Get the radius, metres, as it was set; 0 stands for automatic. */
  double
  getRadius() const
  {
    return options_.radius;
  }

  /** \brief Set the curvature above which points are looked at, theta_t.
   * \param[in] threshold surface variation of Eq. (2.8), 0 to 1/3 (default 0.03, for
   * laser scans; 0.02 suits Kinect). Lower removes more points.
   */
  void
  setCurvatureThreshold(float threshold)
  {
    options_.curvature_threshold = threshold;
  }

  /** \brief Get the curvature threshold. */
  float
  getCurvatureThreshold() const
  {
    return options_.curvature_threshold;
  }

  /** \brief Set the ratio N+ / N- from which a region is not convex, alpha_t.
   * \param[in] threshold 0 to 1 (default 0.2). Lower removes more points.
   */
  void
  setRatioThreshold(float threshold)
  {
    options_.ratio_threshold = threshold;
  }

  /** \brief Get the ratio threshold. */
  float
  getRatioThreshold() const
  {
    return options_.ratio_threshold;
  }

  /** \brief Set the number of threads; the result does not depend on it.
   * \param[in] threads 0 (default) for as many as OpenMP offers
   */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    options_.threads = threads;
  }

protected:
  using FilterIndices<PointT>::extract_removed_indices_;
  using FilterIndices<PointT>::filter_name_;
  using FilterIndices<PointT>::indices_;
  using FilterIndices<PointT>::input_;
  using FilterIndices<PointT>::negative_;
  using FilterIndices<PointT>::removed_indices_;

  /** \brief Filter; after an error the result is empty. */
  void
  applyFilter(Indices& indices) override;

private:
  /** \brief Say what is wrong with input or parameters: "" if nothing. */
  std::string
  findProblem() const;

  PointCloudNConstPtr normals_;
  indoor::NonConvexityOptions options_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/filters/impl/non_convex_points_removal.hpp>
#endif
