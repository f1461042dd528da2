/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/indoor/voxel_map.h>
#include <pcl/model/points_of_rooms.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief What a scan shows at a place of a wall's side. */
enum class WallCell : std::uint8_t {
  Empty,  ///< nothing at all: glass, an open hole, or a shadow
  Face,   ///< the wall
  Recess, ///< something behind the wall's face: a reveal, a leaf, glass
  Proud,  ///< something before it by less than a hand: a leaf, a casing
  Front   ///< objects of the room and nothing of the wall: it is hidden
};

/** \brief A side of a wall as an image, along it and upwards. */
struct PCL_INDOOR_EXPORTS WallImage {
  double cell = 0.0;        ///< side of a cell, metres
  double floor = 0.0;       ///< height of the lowest cells' lower edge, metres
  PixelMap<WallCell> cells; ///< x along the wall from its begin, y upwards
  PixelMap<float> depth;    ///< before the face, metres; 0 where nothing was seen

  /** \brief Share of cells in a box that are of a kind; cells beyond the image count
   * as of none. */
  double
  share(const Eigen::AlignedBox2d& box, WallCell kind) const;
};

/** \brief Make the image of a wall's side.
 *
 * A cell shows the median depth of the points within two and a half cells around it;
 * edges of what is larger stay where they are. The cells are as large as the points are
 * sparse: about ten points count for each. What stands farther before the wall than
 * 0.15 m is an object.
 * \param[in] points near the side, see PointsOfRooms::beside()
 * \param[in] length of the side, metres (> 0)
 * \param[in] height of the side above its floor, metres (> 0)
 */
PCL_INDOOR_EXPORTS WallImage
wallImage(const std::vector<WallPoint>& points,
          double length,
          double floor,
          double height);

} // namespace pcl::indoor
