/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/indoor/point_cells.h> // for Adjacency
#include <pcl/indoor/usable_point.h>
#include <pcl/point_cloud.h>
#include <pcl/types.h> // for Indices

#include <Eigen/Core>

#include <numeric>
#include <vector>

namespace pcl::indoor {

constexpr double radius_factor = 2.5;     ///< of Eq. (2.9)
constexpr unsigned closest_neighbors = 8; ///< k of Eq. (2.1), which gives no value

/** \brief Mean distance of each point to its closest other points, Eq. (2.1).
 * Cost: one search tree, and a search in it per point.
 * \param[in] points finite points, metres, local frame
 * \param[in] neighbors k, at least 1; fewer where there are fewer other points
 * \param[in] threads 0 = automatic; the result does not depend on it
 * \return metres, one per point; 0 if there is no other
 * \throws pcl::BadArgumentException if neighbors is 0
 */
PCL_INDOOR_EXPORTS std::vector<float>
meanNeighborDistances(const std::vector<Eigen::Vector3f>& points,
                      unsigned neighbors,
                      unsigned threads = 0);

/** \brief Radius of a neighbourhood by the rule of Eq. (2.9): 2.5 times the mean
 * distance of points to their closest neighbours, 8 of them. The median stands for the
 * mean over the points, so that outliers do not matter. Of several points in exactly
 * one place one counts.
 * \param[in] points finite points, metres, local frame
 * \return metres; 0 for less than two different points
 */
PCL_INDOOR_EXPORTS double
neighborhoodRadius(const std::vector<Eigen::Vector3f>& points, unsigned threads = 0);

/** \brief List the closest other points of each point, and each point for those, in
 * ascending order.
 * \param[in] neighbors at least 1; as for meanNeighborDistances()
 */
PCL_INDOOR_EXPORTS Adjacency
nearestNeighbors(const std::vector<Eigen::Vector3f>& points,
                 unsigned neighbors,
                 unsigned threads = 0);

/** \brief Collect the usable ones of some points of a cloud, each minus the first of
 * them: nothing is lost in large coordinates. */
template <typename PointT>
std::vector<Eigen::Vector3f>
finitePoints(const PointCloud<PointT>& cloud, const Indices& indices)
{
  std::vector<Eigen::Vector3f> points;
  points.reserve(indices.size());
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (const auto index : indices) {
    const PointT& point = cloud[index];
    if (!isUsablePoint(point))
      continue;
    const Eigen::Vector3d position = point.getVector3fMap().template cast<double>();
    if (points.empty())
      origin = position;
    points.push_back((position - origin).template cast<float>());
  }
  return points;
}

/** \brief The same radius for the usable points of a cloud. */
template <typename PointT>
double
neighborhoodRadius(const PointCloud<PointT>& cloud, unsigned threads = 0)
{
  Indices all(cloud.size());
  std::iota(all.begin(), all.end(), 0);
  return neighborhoodRadius(finitePoints(cloud, all), threads);
}

} // namespace pcl::indoor
