/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/filters/scan_outlier_removal.h>
#include <pcl/indoor/exports.h>
#include <pcl/indoor/index_check.h>
#include <pcl/indoor/neighbor_distance.h> // for finitePoints
#include <pcl/indoor/usable_point.h>

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
  auto problem = indoor::findIndexProblem(*indices_, input_->size());
  if (problem.empty())
    problem = indoor::findProblem(options_);
  if (!problem.empty()) {
    PCL_ERROR("[pcl::ScanOutlierRemoval::applyFilter] %s\n", problem.c_str());
    return;
  }
  const auto points = indoor::finitePoints(*input_, *indices_);
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
