/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/indoor/distinct_points.h>
#include <pcl/point_cloud.h>
#include <pcl/types.h> // for Indices

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief For each of some points of a cloud, the first of them in the same place.
 *
 * What follows from the neighbours alone can be found once per place: where there are
 * thousands of equal points, each finds all others as neighbours.
 * \return one per index, a place among the indices; points that are not finite are
 * alone
 */
template <typename PointT>
std::vector<std::ptrdiff_t>
firstInPlace(const PointCloud<PointT>& cloud, const Indices& indices)
{
  std::vector<std::ptrdiff_t> finite, first(indices.size());
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    first[i] = static_cast<std::ptrdiff_t>(i);
    if (isFinite(cloud[indices[i]])) {
      finite.push_back(first[i]);
      points.emplace_back(cloud[indices[i]].getVector3fMap());
    }
  }
  const auto distinct = distinctPoints(points);
  for (std::size_t k = 0; k < finite.size(); ++k)
    first[finite[k]] = finite[distinct.first[distinct.place[k]]];
  return first;
}

} // namespace pcl::indoor
