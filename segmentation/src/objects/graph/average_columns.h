/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/supervoxel_growing.h" // for Supervoxels::none

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief The mean column of the members of each group.
 * \param[in] labels the group of each column, Supervoxels::none if it is in none
 * \return one column per group, zero if it has no members; none if there are no columns
 */
template <typename Columns>
Columns
averageColumns(const Columns& columns,
               const std::vector<std::uint32_t>& labels,
               std::size_t group_count)
{
  Columns means;
  if (columns.cols() == 0)
    return means;
  Eigen::MatrixXd sums =
      Eigen::MatrixXd::Zero(columns.rows(), static_cast<Eigen::Index>(group_count));
  std::vector<std::uint32_t> counts(group_count, 0);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != Supervoxels::none) {
      sums.col(labels[i]) +=
          columns.col(static_cast<Eigen::Index>(i)).template cast<double>();
      ++counts[labels[i]];
    }
  for (std::size_t k = 0; k < group_count; ++k)
    sums.col(static_cast<Eigen::Index>(k)) /= std::max(counts[k], 1u);
  means = sums.cast<float>();
  return means;
}

} // namespace pcl::indoor
