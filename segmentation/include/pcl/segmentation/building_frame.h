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

/** \brief Turn and move the points of a cloud so that z points up and they lie near the
 * origin, as segmentBuilding() needs them.
 * No bit of a coordinate is lost where an axis of the cloud points up.
 * \param[in,out] points finite, metres
 * \param[in] up_axis of any length but 0
 * \return turns and moves the building's frame back into the cloud's
 */
Eigen::Isometry3d
moveIntoBuildingFrame(std::vector<Eigen::Vector3f>& points,
                      const Eigen::Vector3f& up_axis);

/** \brief Bring rooms and openings into the frame of the cloud.
 * \param[in] boxes per room: around its points, in the cloud's frame (turned, the
 * building's boxes would be too large)
 */
void
placeInCloud(const Eigen::Isometry3d& pose,
             const std::vector<Eigen::AlignedBox3f>& boxes,
             std::vector<Room>& rooms,
             std::vector<RoomOpening>& openings);

} // namespace indoor
} // namespace pcl
