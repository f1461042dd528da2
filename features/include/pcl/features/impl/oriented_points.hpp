/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>
#include <pcl/indoor/index_check.h>
#include <pcl/indoor/usable_point.h>
#include <pcl/point_cloud.h>
#include <pcl/types.h>

#include <cmath>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief Say what is wrong with the input of a descriptor: "" if nothing. */
template <typename PointT, typename PointNT>
std::string
findProblem(const PointCloud<PointT>& cloud,
            const PointCloud<PointNT>* normals,
            const Indices& indices)
{
  if (cloud.empty() || indices.empty())
    return "The input cloud is empty.";
  if (normals == nullptr)
    return "No normals were given.";
  if (normals->size() != cloud.size())
    return std::to_string(normals->size()) + " normals do not fit " +
           std::to_string(cloud.size()) + " points.";
  return findIndexProblem(indices, cloud.size());
}

/** \brief The usable points of a cloud: see isUsable(), with a finite normal that is
 * not zero.
 *
 * Positions are relative to the first usable point, so that large coordinates lose
 * nothing more in what is computed from them.
 */
template <typename PointT, typename PointNT>
std::vector<OrientedPoint>
orientedPoints(const PointCloud<PointT>& cloud,
               const PointCloud<PointNT>& normals,
               const Indices& indices)
{
  std::vector<OrientedPoint> points(indices.size());
  std::size_t count = 0;
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();
  for (const auto index : indices) {
    const Eigen::Vector3f position = cloud[index].getVector3fMap();
    const Eigen::Vector3f normal = normals[index].getNormalVector3fMap();
    const float length = normal.norm();
    if (!isUsable(position) || !std::isfinite(length) || !(length > 0.0f))
      continue;
    if (count == 0)
      origin = position;
    points[count++] = {position - origin, normal / length};
  }
  points.resize(count);
  return points;
}

} // namespace pcl::indoor
