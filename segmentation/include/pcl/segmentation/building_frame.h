/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/segmentation/building_rooms.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace pcl {
namespace indoor {

/** \brief The points of a cloud as segmentBuilding() needs them: z up, near the origin.
 */
struct BuildingFrame {
  std::vector<Eigen::Vector3f> points; ///< in the building's frame, metres
  Eigen::Isometry3d pose; ///< turns and moves the building's frame into the cloud's
};

/** \brief Turn and move points of a cloud into the building's frame.
 * No bit of a coordinate is lost where an axis of the cloud points up.
 * \param[in] points finite
 * \param[in] up_axis of any length but 0
 */
BuildingFrame
buildingFrame(const std::vector<Eigen::Vector3f>& points,
              const Eigen::Vector3f& up_axis);

/** \brief Bring rooms and openings into the frame of the cloud.
 * \param[in] points as given to buildingFrame()
 * \param[in] point_labels room of each of these
 */
void
placeInCloud(const Eigen::Isometry3d& pose,
             const std::vector<Eigen::Vector3f>& points,
             const std::vector<std::uint32_t>& point_labels,
             std::vector<Room>& rooms,
             std::vector<RoomOpening>& openings);

} // namespace indoor
} // namespace pcl
