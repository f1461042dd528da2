/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/filters/non_convex_points_removal.h>
#include <pcl/indoor/exports.h>
#include <pcl/indoor/index_check.h>
#include <pcl/indoor/neighbor_distance.h> // for finitePoints
#include <pcl/indoor/plain_message.h>
#include <pcl/indoor/usable_point.h>

#include <string>
#include <vector>

namespace pcl {

template <typename PointT, typename PointNT>
NonConvexPointsRemoval<PointT, PointNT>::NonConvexPointsRemoval(
    bool extract_removed_indices)
: FilterIndices<PointT>(extract_removed_indices)
{
  filter_name_ = "NonConvexPointsRemoval";
}

template <typename PointT, typename PointNT>
std::string
NonConvexPointsRemoval<PointT, PointNT>::findProblem() const
{
  if (!normals_ || normals_->size() != input_->size())
    return "The input has " + std::to_string(input_->size()) + " points, but " +
           std::to_string(normals_ ? normals_->size() : 0) + " normals.";
  const auto problem = indoor::findIndexProblem(*indices_, input_->size());
  return problem.empty() ? indoor::findProblem(options_) : problem;
}

template <typename PointT, typename PointNT>
void
NonConvexPointsRemoval<PointT, PointNT>::applyFilter(Indices& indices)
{
  indices.clear();
  removed_indices_->clear();
  if (const auto problem = findProblem(); !problem.empty()) {
    PCL_ERROR("[pcl::NonConvexPointsRemoval::applyFilter] %s\n", problem.c_str());
    return;
  }
  std::vector<Eigen::Vector3f> normals;
  std::vector<float> curvatures;
  Indices finite;
  for (const auto index : *indices_) {
    if (!indoor::isUsablePoint((*input_)[index])) {
      if (extract_removed_indices_)
        removed_indices_->push_back(index);
      continue;
    }
    finite.push_back(index);
    normals.push_back((*normals_)[index].getNormalVector3fMap());
    curvatures.push_back((*normals_)[index].curvature);
  }
  const auto points = indoor::finitePoints(*input_, finite);
  std::vector<std::uint8_t> non_convex;
  try {
    non_convex = indoor::nonConvexPoints(points, normals, curvatures, options_);
  } catch (const BadArgumentException& error) { // a radius too small for the extent
    PCL_ERROR("[pcl::NonConvexPointsRemoval::applyFilter] %s\n",
              indoor::plainMessage(error).c_str());
    removed_indices_->clear();
    return;
  }
  for (std::size_t i = 0; i < finite.size(); ++i) {
    if ((non_convex[i] != 0) == negative_)
      indices.push_back(finite[i]);
    else if (extract_removed_indices_)
      removed_indices_->push_back(finite[i]);
  }
}

} // namespace pcl

#define PCL_INSTANTIATE_NonConvexPointsRemoval(T, NT)                                  \
  template class PCL_INDOOR_EXPORTS pcl::NonConvexPointsRemoval<T, NT>;
