/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/map/room_map.h"
#include "rooms/outline/wall_sides.h"
#include "rooms/space/occupancy_grid.h"

#include <pcl/segmentation/building_rooms.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

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
  /** A point's voxel in the building's grid. */
  struct Voxel {
    std::int32_t column = 0;
    std::int32_t layer = 0;
  };

  /** Points near borders between rooms, by the rows of the map they lie in. */
  struct NearPoints {
    std::vector<std::uint32_t> first; ///< per row, and the end
    std::vector<std::uint32_t> points;
  };

  Voxel
  voxelOf(std::size_t i) const;

  bool
  isUpright(const Voxel& voxel) const;

  Eigen::Vector2d
  placeOf(std::size_t i, const Voxel& voxel) const;

  std::int32_t
  pixelOf(std::size_t i, const Voxel& voxel) const;

  NearPoints
  labelFarPoints(const std::vector<std::uint8_t>& storey_of,
                 std::uint8_t storey,
                 const std::vector<std::uint32_t>& room_of,
                 std::vector<std::uint32_t>& point_labels) const;

  PixelPoints
  sortByPixels(int begin_row, int end_row, NearPoints& near) const;

  const std::vector<Eigen::Vector3f>& points_;
  const OccupancyGrid& occupancy_;
  const RoomMap& map_;
  const BuildingRoomsOptions& options_;
  const Eigen::Matrix2d turn_; ///< into the frame of the grid
  PixelMap<float> slab_;       ///< its height, if walls lean
  const double radius_;        ///< of the windows in which walls are fitted, pixels
};

} // namespace pcl::indoor
