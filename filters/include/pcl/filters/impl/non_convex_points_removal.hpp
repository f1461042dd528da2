/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/filters/non_convex_points_removal.h>
#include <pcl/indoor/exports.h>
#include <pcl/indoor/neighbor_distance.h>
#include <pcl/indoor/plain_message.h>
#include <pcl/indoor/usable_point.h>

namespace pcl {

template <typename PointT, typename PointNT>
NonConvexPointsRemoval<PointT, PointNT>::NonConvexPointsRemoval(
    bool extract_removed_indices)
: FilterIndices<PointT>(extract_removed_indices)
{
  filter_name_ = "NonConvexPointsRemoval";
}

template <typename PointT, typename PointNT>
bool
NonConvexPointsRemoval<PointT, PointNT>::hasValidInput() const
{
  const char* where = "[pcl::NonConvexPointsRemoval::applyFilter]";
  if (!normals_ || normals_->size() != input_->size()) {
    PCL_ERROR("%s The input has %zu points, but %zu normals.\n",
              where,
              static_cast<std::size_t>(input_->size()),
              static_cast<std::size_t>(normals_ ? normals_->size() : 0));
    return false;
  }
  for (const auto index : *indices_)
    if (index < 0 || static_cast<std::size_t>(index) >= input_->size()) {
      PCL_ERROR("%s Index %d is outside of the cloud.\n", where, index);
      return false;
    }
  if (!(radius_ >= 0) || !std::isfinite(radius_)) {
    PCL_ERROR("%s The radius must not be negative, not %g m.\n", where, radius_);
    return false;
  }
  const float curvature = options_.curvature_threshold;
  if (!(curvature >= 0 && curvature <= 1.0f / 3)) {
    PCL_ERROR(
        "%s The curvature threshold must be in [0, 1/3], not %g.\n", where, curvature);
    return false;
  }
  if (!(options_.ratio_threshold >= 0 && options_.ratio_threshold <= 1)) {
    PCL_ERROR("%s The ratio threshold must be in [0, 1], not %g.\n",
              where,
              options_.ratio_threshold);
    return false;
  }
  return true;
}

template <typename PointT, typename PointNT>
void
NonConvexPointsRemoval<PointT, PointNT>::applyFilter(Indices& indices)
{
  indices.clear();
  removed_indices_->clear();
  if (!hasValidInput())
    return;
  std::vector<Eigen::Vector3f> points, normals;
  std::vector<float> curvatures;
  Indices finite;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (const auto index : *indices_) {
    const PointT& point = (*input_)[index];
    if (!indoor::isUsablePoint(point)) {
      if (extract_removed_indices_)
        removed_indices_->push_back(index);
      continue;
    }
    if (finite.empty())
      origin = point.getVector3fMap().template cast<double>();
    finite.push_back(index);
    points.push_back((point.getVector3fMap().template cast<double>() - origin)
                         .template cast<float>());
    normals.push_back((*normals_)[index].getNormalVector3fMap());
    curvatures.push_back((*normals_)[index].curvature);
  }
  auto options = options_;
  options.radius = radius_ > 0 ? radius_ : indoor::neighborhoodRadius(points);
  if (!(options.radius > 0)) // no two different points: no neighbourhood
    options.radius = 1;
  std::vector<std::uint8_t> non_convex;
  try {
    non_convex = indoor::nonConvexPoints(points, normals, curvatures, options);
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
