/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/map/room_map.h"
#include "rooms/storeys/storey_space.h"

#include <pcl/indoor/voxel_bits.h>
#include <pcl/indoor/voxel_map.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief How high the occupied voxels of a grid reach, without the outermost
 * thousandths, metres; 0 if there are none. */
double
occupiedHeight(const VoxelBits& occupancy);

/** \brief Give the regions of a map other labels.
 * \param[in] number the new label, 0 ... n, of each label from 0 on */
void
relabel(const std::vector<std::int32_t>& number, RoomMap& map);

/** \brief Take regions out of a map and number the others anew.
 * \param[in] is_dropped one per label from 0 on
 * \return how many were dropped
 */
std::size_t
dropRegions(const std::vector<std::uint8_t>& is_dropped, RoomMap& map);

/** \brief The share of each region's border with a wall or another region beyond it; 0
 * for no region. Where nothing is, the region may go on: nobody looked there.
 * \param[in] pixel_size metres
 * \return one per label from 0 on
 */
std::vector<double>
closedBorders(const RoomMap& map, double pixel_size);

/** \brief Columns of a region. */
struct LevelSides {
  std::size_t floor = 0;   ///< in which one is seen, or was put in
  std::size_t ceiling = 0; ///< the same
  std::size_t all = 0;

  /** \brief How much of the floor is seen. */
  double
  floorShare() const
  {
    return static_cast<double>(floor) / static_cast<double>(all);
  }

  /** \brief How much of the ceiling is seen. */
  double
  ceilingShare() const
  {
    return static_cast<double>(ceiling) / static_cast<double>(all);
  }
};

/** \brief What a storey's voxels show of the floor and the ceiling of each region.
 * \return one per label from 0 on, which has none
 */
std::vector<LevelSides>
levelSides(const VoxelBits& occupancy, const RoomMap& map);

/** \brief Drop the large regions without a ceiling whose border is open, such as
 * streets, where a scan shows ceilings elsewhere.
 * \param[in,out] map its labels are 1 ... n again
 */
void
dropStreets(const StoreySpace& space, RoomMap& map);

/** What a storey and those below show of the ground around a building. */
struct OpenGround {
  std::size_t open = 0;       ///< pixels of no region, without anything above
  std::size_t enclosed = 0;   ///< pixels of the regions that walls enclose
  double usual_ceiling = 0.0; ///< the share of the ceiling that is seen in these
};

/** \brief Drop the regions under trees and eaves: where a scan has more of open ground
 * than of rooms, a region needs walls around it or a ceiling above it, together as much
 * as four fifths of either.
 * \param[in,out] ground that of the storeys below; that of this one is added
 * \param[in,out] map its labels are 1 ... n again
 */
void
dropOutdoors(const StoreySpace& space, OpenGround& ground, RoomMap& map);

/** \brief Drop the regions of which little was seen: nobody was there, something was
 * seen through a door or a window.
 *
 * Let s be the share of walls, floor and ceiling that was seen. A region goes if
 * area * s / (1 - s) < 4.5 m^2, s < 0.8 and it is less than half as large as the
 * largest. Each of the four walls of a room counts as much as its floor; a floor or a
 * ceiling that is missing in the whole scan does not count.
 * \param[in,out] map its labels are 1 ... n again
 * \return how many were dropped
 */
std::size_t
dropSeenThroughOpenings(const StoreySpace& space, RoomMap& map);

/** \brief Drop the regions into which hardly anyone looked: mirror images behind glass,
 * what was seen through windows, blocks between corridors. They have far fewer points
 * per area than the others of the storey, or points over far less of it.
 * \param[in] points number of points per column
 * \param[in,out] map its labels are 1 ... n again
 * \return how many were dropped
 */
std::size_t
dropHardlySeen(const StoreySpace& space,
               const PixelMap<std::uint32_t>& points,
               RoomMap& map);

} // namespace pcl::indoor
