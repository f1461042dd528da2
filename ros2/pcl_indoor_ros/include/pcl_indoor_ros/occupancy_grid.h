/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/scene/storey_maps.h>

#include <Eigen/Core>

namespace pcl_indoor_ros {

/** \brief The map of a storey as a nav_msgs/OccupancyGrid.
 * \param[in] origin of the header's frame, in that of the scan's file, metres */
template <typename Message, typename Header>
Message
occupancyGrid(const pcl::indoor::StoreyMap& map,
              const Eigen::Vector3d& origin,
              const Header& header)
{
  Message message;
  message.header = header;
  message.info.map_load_time = header.stamp;
  message.info.resolution = static_cast<float>(map.resolution);
  message.info.width = static_cast<decltype(message.info.width)>(map.nx);
  message.info.height = static_cast<decltype(message.info.height)>(map.ny);
  const Eigen::Vector3d corner = map.lower_left_corner - origin;
  auto& pose = message.info.origin;
  pose.position.x = corner.x();
  pose.position.y = corner.y();
  pose.position.z = corner.z();
  pose.orientation.x = map.turn.x();
  pose.orientation.y = map.turn.y();
  pose.orientation.z = map.turn.z();
  pose.orientation.w = map.turn.w();
  message.data.assign(map.cells.begin(), map.cells.end());
  return message;
}

} // namespace pcl_indoor_ros
