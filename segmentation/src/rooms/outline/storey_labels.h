/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/map/room_map.h"
#include "rooms/space/occupancy_grid.h"

#include <pcl/segmentation/building_rooms.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Labels the points of one storey: by the map, and at walls by the side they
 * are on. Where walls lean, points are judged at the place where they would be if those
 * stood upright.
 */
class StoreyLabels {
public:
  StoreyLabels(const std::vector<Eigen::Vector3f>& points,
               const OccupancyGrid& occupancy,
               const RoomMap& map,
               const BuildingRoomsOptions& options);

  /** \param[in] storey_of per point
   * \param[in] storey this one
   * \param[in] room_of per label of the map
   * \param[in,out] point_labels changed where \a storey_of is \a storey
   */
  void
  assign(const std::vector<std::uint8_t>& storey_of,
         std::uint8_t storey,
         const std::vector<std::uint32_t>& room_of,
         std::vector<std::uint32_t>& point_labels) const;

private:
  Eigen::Vector2d
  placeOf(std::size_t i) const;

  std::size_t
  pixelOf(std::size_t i) const;

  bool
  inSlab(std::size_t i, std::size_t pixel) const;

  std::vector<std::int32_t>
  wallLabels(const std::uint32_t* begin, const std::uint32_t* end) const;

  const std::vector<Eigen::Vector3f>& points_;
  const OccupancyGrid& occupancy_;
  const RoomMap& map_;
  const BuildingRoomsOptions& options_;
  const Eigen::Matrix2d turn_; ///< into the frame of the grid
  PixelMap<float> slab_;       ///< its height, if walls lean
};

} // namespace indoor
} // namespace pcl
