/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/point_cloud.h>
#include <pcl/types.h> // for Indices

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl {
namespace indoor {

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
  std::vector<std::ptrdiff_t> order, first(indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    first[i] = static_cast<std::ptrdiff_t>(i);
    if (isFinite(cloud[indices[i]])) // the others have no order
      order.push_back(first[i]);
  }
  const auto place = [&](std::ptrdiff_t i) {
    const PointT& point = cloud[indices[i]];
    return std::make_tuple(point.x, point.y, point.z);
  };
  std::sort(order.begin(), order.end(), [&](std::ptrdiff_t a, std::ptrdiff_t b) {
    return std::make_pair(place(a), a) < std::make_pair(place(b), b);
  });
  for (std::size_t k = 1; k < order.size(); ++k)
    if (place(order[k]) == place(order[k - 1]))
      first[order[k]] = first[order[k - 1]];
  return first;
}

} // namespace indoor
} // namespace pcl
