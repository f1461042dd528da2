/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/map/region_borders.h"
#include "rooms/map/room_map.h"
#include "rooms/space/interior_space.h"
#include "rooms/space/occupancy_grid.h"
#include "rooms/storeys/storeys.h"

#include <pcl/indoor/voxel_map.h>
#include <pcl/segmentation/building_rooms.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl::indoor {

/** \brief What is known of a storey's points. */
struct StoreyPoints {
  const std::vector<std::uint8_t>& storey_of; ///< of each point
  std::size_t storey;                         ///< that is looked at
};

/** \brief What parts two regions. */
struct PartitionPoints {
  std::size_t own = 0;    ///< points that were measured from one of the two
  std::size_t all = 0;    ///< points of which it is known from where
  std::size_t pixels = 0; ///< of the map
};

/** \brief From where the points of a building were measured. */
class StationViews {
public:
  /** \param[in] stations in the frame of the grid's points
   * \param[in] building must outlive this, as \a stations and \a storeys */
  StationViews(const ScanStations& stations,
               const OccupancyGrid& building,
               const InteriorSpace& interior,
               const Storeys& storeys);

  /** \brief Does no station stand within the building, or is not known where all stand?
   * Then they tell nothing: they may be of another frame. */
  bool
  empty() const;

  /** \brief One per station, without their rooms. */
  const std::vector<PlacedStation>&
  placed() const
  {
    return placed_;
  }

  /** \brief The region in which each station stands; 0 = in none of the storey. */
  std::vector<std::int32_t>
  regionsOf(const RoomMap& map, std::size_t storey) const;

  /** \brief Drop the regions in which no station stands and into which none looked but
   * through walls, panes or above sills: mirror images, gardens, attics.
   * \param[in,out] map its labels are 1 ... n again
   * \return how many were dropped
   */
  std::size_t
  dropNeverEntered(const StoreyPoints& points, RoomMap& map) const;

  /** \brief Join the regions between which only what was mirrored from elsewhere looks
   * like a wall: neither side's stations measured it.
   * \param[in,out] map its labels are 1 ... n again
   * \return how many borders were dropped
   */
  std::size_t
  joinMirrored(const StoreyPoints& points, RoomMap& map) const;

private:
  void
  place(const Eigen::Vector3d& position, const InteriorSpace& interior);

  /** A voxel with points, and the station that measured them; 0 = not known. */
  struct Sighting {
    std::int32_t cell;
    std::uint32_t station;
  };

  /** Up to so many of each region that is asked for, in an order that is not that of
   * the points. */
  std::vector<std::vector<Sighting>>
  sightings(const StoreyPoints& points,
            const RoomMap& map,
            const std::vector<std::uint8_t>& is_asked) const;

  /** The share of voxels that a station sees. */
  double
  shareSeen(const std::vector<Sighting>& sightings,
            const RoomMap& map,
            std::size_t storey) const;

  bool
  isSeen(const Sighting& sighting, const RoomMap& map, std::size_t storey) const;

  /** Whether nothing parts a place of a storey, in voxels, from a station. */
  bool
  isFreeWay(std::uint32_t station,
            const Eigen::Vector3d& to,
            const RoomMap& map,
            std::size_t storey) const;

  /** Whether a voxel lies in a wall, a pane, a floor or above a sill. */
  bool
  isClosed(const Eigen::Array3i& voxel, const RoomMap& map) const;

  /** Whether a voxel may be the ceiling of the storey below. */
  bool
  isSlabBelow(std::int32_t cell, std::size_t storey) const;

  /** Neither a part of the floor nor of the ceiling. */
  bool
  isUpright(std::int32_t cell, const RoomMap& map) const;

  /** What is known of that which parts regions with stations. */
  std::map<RegionPair, PartitionPoints>
  countPartitions(const StoreyPoints& points,
                  const RoomMap& map,
                  const PixelMap<RegionPair>& partitions) const;

  std::uint32_t
  stationOf(std::size_t point) const;

  const ScanStations& stations_;
  const OccupancyGrid& building_;
  const Storeys& storeys_;
  std::vector<PlacedStation> placed_;
  std::vector<Eigen::Vector3d> places_;       ///< of stations in voxels of the grid
  std::vector<std::uint32_t> apart_;          ///< stations that stand apart, from 1
  std::set<std::tuple<int, int, int>> taken_; ///< metres around those
  bool is_known_ = false; ///< where they are, and one is in the building
};

} // namespace pcl::indoor
