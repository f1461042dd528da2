/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <fstream>
#include <string>

namespace pcl::indoor::tool {

/** \brief Points that wait in a file while others need the memory. */
class PCL_INDOOR_EXPORTS PointsAside {
public:
  /** \brief Put the points into a file, and give their memory back. Where the file
   * cannot be written they stay where they are.
   * \param[in,out] points have none until bringBack(); must outlive this
   * \param[in] path of the file, which nobody sees: it ends with this, or the process
   */
  PointsAside(PointCloud<PointXYZ>& points, const std::string& path);

  /** \brief Take the points out of the file; bit by bit the same.
   * \throws ToolError if they cannot be read */
  void
  bringBack();

private:
  PointCloud<PointXYZ>& points_;
  std::string path_;
  std::fstream file_;
  std::size_t count_ = 0; ///< of the points in the file
};

} // namespace pcl::indoor::tool
