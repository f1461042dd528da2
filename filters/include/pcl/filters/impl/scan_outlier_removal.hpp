/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/filters/scan_outlier_removal.h>
#include <pcl/indoor/exports.h>
#include <pcl/indoor/usable_point.h>

#include <string>
#include <vector>

namespace pcl {

template <typename PointT>
ScanOutlierRemoval<PointT>::ScanOutlierRemoval(bool extract_removed_indices)
: FilterIndices<PointT>(extract_removed_indices)
{
  filter_name_ = "ScanOutlierRemoval";
}

template <typename PointT>
void
ScanOutlierRemoval<PointT>::applyFilter(Indices& indices)
{
  indices.clear();
  removed_indices_->clear();
  std::string problem = indoor::findProblem(options_);
  for (const auto index : *indices_)
    if (index < 0 || static_cast<std::size_t>(index) >= input_->size())
      problem = "Index " + std::to_string(index) + " is outside of the cloud.";
  if (!problem.empty()) {
    PCL_ERROR("[pcl::ScanOutlierRemoval::applyFilter] %s\n", problem.c_str());
    return;
  }
  std::vector<Eigen::Vector3f> points;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (const auto index : *indices_) {
    if (!indoor::isUsablePoint((*input_)[index]))
      continue;
    const Eigen::Vector3d position =
        (*input_)[index].getVector3fMap().template cast<double>();
    if (points.empty())
      origin = position;
    points.push_back((position - origin).template cast<float>());
  }
  const auto outliers = indoor::scanOutliers(points, options_);
  std::size_t i = 0;
  for (const auto index : *indices_) {
    const bool finite = indoor::isUsablePoint((*input_)[index]);
    if (finite && (outliers[i++] != 0) == negative_)
      indices.push_back(index);
    else if (extract_removed_indices_)
      removed_indices_->push_back(index);
  }
}

} // namespace pcl

#define PCL_INSTANTIATE_ScanOutlierRemoval(T)                                          \
  template class PCL_INDOOR_EXPORTS pcl::ScanOutlierRemoval<T>;
