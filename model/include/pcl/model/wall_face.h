/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/model/points_of_rooms.h>
#include <pcl/segmentation/building_rooms.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief A straight run of a room's outline: one side of a wall, seen from above. */
struct WallFace {
  std::uint32_t room = 0;     ///< that it belongs to, from 1
  std::uint32_t storey = 0;   ///< that of the room
  Eigen::Vector2d begin, end; ///< metres; the room is on the left
  double floor = 0.0;         ///< height of the room's floor, metres
  double ceiling = 0.0;       ///< height of the room's ceiling, metres
  bool is_seen = false;       ///< whether points lie on it that it was fitted to

  double
  length() const
  {
    return (end - begin).norm();
  }

  Eigen::Vector2d
  along() const
  {
    return (end - begin).normalized();
  }

  /** \brief Points into the room. */
  Eigen::Vector2d
  inward() const
  {
    const Eigen::Vector2d way = along();
    return {-way.y(), way.x()};
  }
};

/** \brief The outlines of all rooms in straight runs, each fitted to the points of its
 * wall. Those of columns, see isColumn(), are left out.
 *
 * A run is moved and turned to where most points of the room lie beside it, from the
 * floor to the ceiling, and then fitted to these by least squares: the mean of a
 * thousand points with noise of 1 cm is known to less than a millimetre. Corners are
 * where neighbouring runs meet. Runs of one outline follow each other.
 * \param[in] points those of the building, in the frame of the rooms
 */
PCL_INDOOR_EXPORTS std::vector<WallFace>
wallFaces(const std::vector<Room>& rooms, const PointsOfRooms& points, int threads = 0);

} // namespace pcl::indoor
