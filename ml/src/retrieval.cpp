/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/retrieval.h>

#include <pcl/exceptions.h>

#include <limits>

namespace pcl::indoor {

namespace {

std::vector<int>
labelsOfNearest(const DistanceTable& distances,
                const std::vector<int>& labels,
                bool leaves_same_out)
{
  if (labels.size() != distances.columns)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        labels.size() << " labels do not fit " << distances.columns
                                      << " histograms");
  std::vector<int> found(distances.rows, no_label);
  for (std::size_t row = 0; row < distances.rows; ++row) {
    float nearest = std::numeric_limits<float>::infinity();
    for (std::size_t column = 0; column < distances.columns; ++column)
      if (distances.at(row, column) < nearest && !(leaves_same_out && row == column)) {
        nearest = distances.at(row, column);
        found[row] = labels[column];
      }
  }
  return found;
}

} // namespace

std::vector<int>
nearestLabels(const DistanceTable& distances, const std::vector<int>& gallery_labels)
{
  return labelsOfNearest(distances, gallery_labels, false);
}

std::vector<int>
leaveOneOutLabels(const DistanceTable& distances, const std::vector<int>& labels)
{
  if (distances.rows != distances.columns)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "Leave-one-out needs a square table, not "
                            << distances.rows << " x " << distances.columns);
  return labelsOfNearest(distances, labels, true);
}

} // namespace pcl::indoor
