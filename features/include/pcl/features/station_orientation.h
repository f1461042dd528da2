/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Turn normals towards the stations from which their points were measured (Eq.
 * (2.6)).
 * \param[in] stations their positions, in the frame of the points
 * \param[in] station_of_point from 1; normals of points with 0, which is not known,
 * stay as they are
 * \param[in,out] normals one per point; NaN stay so
 * \return how many have been turned over
 * \throws pcl::BadArgumentException if there are not as many numbers and normals as
 * points, or if there is no such station
 */
PCL_INDOOR_EXPORTS std::size_t
orientTowardsStations(const PointCloud<PointXYZ>& points,
                      const std::vector<Eigen::Vector3d>& stations,
                      const std::vector<std::uint32_t>& station_of_point,
                      PointCloud<Normal>& normals);

} // namespace pcl::indoor
