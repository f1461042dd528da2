/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The points of a cloud for computing, and which of its places are none. */
struct PlacedPoints {
  CoordinateOrigin origin;          ///< of those that are points
  PointCloud<PointXYZ>::Ptr points; ///< as pointsAround() gives them
  std::size_t finite_count = 0;
  std::size_t copy_count = 0; ///< see CloudFile::copy_count
  /** Places of thousands of points that are none, as scanners write what has sent no
   * light back; in the coordinates of the file. */
  std::vector<Eigen::Vector3d> left_out;
};

/** \brief Find the points of a cloud.
 * \param[in] in_rows 0 0 0 is no point of a camera's picture
 */
PCL_INDOOR_EXPORTS PlacedPoints
placedPoints(const PCLPointCloud2& cloud, bool in_rows);

/** \brief How many points of a cloud lie at exactly one place? */
PCL_INDOOR_EXPORTS std::size_t
countAt(const PCLPointCloud2& cloud, const Eigen::Vector3d& place);

/** \brief A line on each place that was left out; of more than three, such as the
 * stations of a large scan, one on the others together.
 * \param[in] counts points at each place
 * \param[in] all points of the cloud
 */
PCL_INDOOR_EXPORTS std::vector<std::string>
leftOutNotes(const std::vector<Eigen::Vector3d>& places,
             const std::vector<std::uint64_t>& counts,
             std::uint64_t all);

/** \brief One line on the copies of points; empty if there are few. */
std::string
copiesNote(std::uint64_t copies, std::uint64_t all);

/** \brief One line on why the normals of a cloud are none, see findNormalsProblem();
 * empty if they are normals. */
PCL_INDOOR_EXPORTS std::string
normalsNote(const PCLPointCloud2& cloud, const PointCloud<PointXYZ>& points);

} // namespace pcl::indoor::tool
