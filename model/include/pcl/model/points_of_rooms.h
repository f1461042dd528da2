/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/indoor/point_tiles.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief A point as seen from a wall. */
struct WallPoint {
  float along = 0.0f;  ///< from the begin of the run, metres
  float before = 0.0f; ///< the wall, metres; negative behind it
  float height = 0.0f; ///< metres
};

/** \brief A stretch of a vertical plane and its surroundings. */
struct FaceStretch {
  Eigen::Vector2d begin, end; ///< metres; the room is on the left
  double margin = 0.0;        ///< how far it goes on beyond both, metres
  double behind = 0.0;        ///< reach behind it, metres
  double before = 0.0;        ///< reach before it, metres
};

/** \brief The points of a building by room: what is beside a wall of a room. */
class PCL_INDOOR_EXPORTS PointsOfRooms {
public:
  /** \param[in] points metres, z up; what is not finite counts nowhere
   * \param[in] room_of_point room of each, 0 = none; those of none are seen from all
   * \param[in] room_count largest number of a room
   * \param[in] origin of the frame of the rooms, which is subtracted from each point
   * \throws pcl::BadArgumentException if there are not as many rooms as points, or a
   * number is larger
   */
  PointsOfRooms(const PointCloud<PointXYZ>& points,
                const std::vector<std::uint32_t>& room_of_point,
                std::uint32_t room_count,
                const Eigen::Vector3f& origin = Eigen::Vector3f::Zero());

  /** \brief The largest number of a room. */
  std::uint32_t
  roomCount() const
  {
    return static_cast<std::uint32_t>(of_rooms_.size() - 1);
  }

  /** \brief Get the points near a stretch that a room sees.
   *
   * With \a with_none those of no room count, too; those of the room are the first.
   */
  void
  beside(const FaceStretch& stretch,
         std::uint32_t room,
         bool with_none,
         std::vector<WallPoint>& found) const;

private:
  std::vector<PointTiles<Eigen::Vector3f>> of_rooms_; ///< per room; first those of none
};

} // namespace pcl::indoor
