/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/map/ceiling_slab.h"
#include "rooms/storeys/storey_space.h"

#include <pcl/indoor/voxel_map.h>
#include <pcl/segmentation/building_rooms.h>

#include <Eigen/Core>

#include <cstddef>

namespace pcl::indoor {

/** \brief The map of one storey and every step on the way to it. */
struct RoomMap : MappedRooms {
  int first_layer = 0;            ///< layer of the building's grid that is layer 0
  VerticalRange range;            ///< layers from floor to ceiling
  PixelMap<int> ceiling;          ///< layer of the ceiling, -1 = none
  SlabLayers slab;                ///< where the walls were looked for
  PixelMap<Eigen::Vector2f> lean; ///< see leanMap(); empty if all walls are upright

  /** \brief How far below the ceiling a layer of the building's grid lies, layers. */
  int
  belowCeiling(std::size_t pixel, int layer) const
  {
    return ceiling.values[pixel] + first_layer - layer;
  }

  /** \brief Whether a layer of the building's grid lies in the slab. */
  bool
  inSlab(std::size_t pixel, int layer) const
  {
    const int below = belowCeiling(pixel, layer);
    return below >= slab.first && below <= slab.last;
  }
};

/** \brief The walls and the free space of a storey: a map that has no rooms yet.
 * \param[in] threads 0 = automatic; the result does not depend on it */
RoomMap
mapWithoutRooms(const StoreySpace& space,
                const RoomMapOptions& options,
                int threads = 0);

/** \brief Divide a storey into rooms on its map.
 * \param[in] threads 0 = automatic; the result does not depend on it */
RoomMap
segmentRoomMap(const StoreySpace& space,
               const RoomMapOptions& options,
               int threads = 0);

} // namespace pcl::indoor
