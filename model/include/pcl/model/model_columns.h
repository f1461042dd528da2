/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/model/building_model.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** \brief Whether a hole in the outline of a room is that of a column: no side is
 * longer than a metre.
 * \param[in] line of a room's footprint, see Room */
PCL_INDOOR_EXPORTS bool
isColumn(const std::vector<Eigen::Vector3d>& line);

/** \brief The columns in rooms, room by room: rectangles, or circles where more points
 * lie on one.
 * \param[in] points those of the building, in the frame of the rooms
 */
PCL_INDOOR_EXPORTS std::vector<ModelColumn>
modelColumns(const std::vector<Room>& rooms, const PointsOfRooms& points);

} // namespace pcl::indoor
