/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/PointIndices.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Copy coordinates and organisation of a cloud, with labels.
 * \param[in] labels one per point; empty for an empty output, then \a cloud may be null
 */
template <typename CloudPtr>
void
labelCloud(const CloudPtr& cloud,
           const std::vector<std::uint32_t>& labels,
           PointCloud<PointXYZL>& output)
{
  output.clear();
  if (labels.empty())
    return;
  output.header = cloud->header;
  output.sensor_origin_ = cloud->sensor_origin_;
  output.sensor_orientation_ = cloud->sensor_orientation_;
  output.is_dense = cloud->is_dense;
  output.resize(labels.size());
  output.width = cloud->width;
  output.height = cloud->height;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    output[i].getVector3fMap() = (*cloud)[i].getVector3fMap();
    output[i].label = labels[i];
  }
}

/** \brief List the points of each label from 1 to the count.
 * \param[in] labels one per point; empty after an error, then \a cloud may be null */
template <typename CloudPtr>
std::vector<PointIndices>
indicesOfLabels(const CloudPtr& cloud,
                const std::vector<std::uint32_t>& labels,
                std::size_t count)
{
  std::vector<PointIndices> segments;
  if (labels.empty())
    return segments;
  segments.resize(count);
  for (auto& segment : segments)
    segment.header = cloud->header;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] > 0)
      segments[labels[i] - 1].indices.push_back(static_cast<index_t>(i));
  return segments;
}

} // namespace pcl::indoor
