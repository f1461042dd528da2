/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {
namespace test {

using Labels = std::vector<std::uint32_t>;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

inline Cloud::Ptr
cloudOf(const std::vector<Eigen::Vector3f>& points)
{
  Cloud::Ptr cloud(new Cloud);
  for (const auto& point : points)
    cloud->emplace_back(point.x(), point.y(), point.z());
  return cloud;
}

} // namespace test
} // namespace pcl::indoor
