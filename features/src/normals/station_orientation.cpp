/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/features/station_orientation.h>

#include <pcl/exceptions.h>

#include <algorithm>

namespace pcl::indoor {

std::size_t
orientTowardsStations(const PointCloud<PointXYZ>& points,
                      const std::vector<Eigen::Vector3d>& stations,
                      const std::vector<std::uint32_t>& station_of_point,
                      PointCloud<Normal>& normals)
{
  if (points.size() != normals.size() || points.size() != station_of_point.size())
    PCL_THROW_EXCEPTION(
        BadArgumentException,
        normals.size() << " normals and the stations of " << station_of_point.size()
                       << " points do not fit " << points.size() << " points.");
  std::size_t turned = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (station_of_point[i] == 0)
      continue;
    if (station_of_point[i] > stations.size())
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "There are " << stations.size() << " stations, no station "
                                       << station_of_point[i] << '.');
    const Eigen::Vector3d to_station =
        stations[station_of_point[i] - 1] - points[i].getVector3fMap().cast<double>();
    auto normal = normals[i].getNormalVector3fMap();
    if (normal.cast<double>().dot(to_station) < 0.0) {
      normal = -normal;
      ++turned;
    }
  }
  return turned;
}

} // namespace pcl::indoor
