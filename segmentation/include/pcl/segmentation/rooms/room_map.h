/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>
#include <pcl/segmentation/rooms/ceiling_slab.h>
#include <pcl/segmentation/rooms/field_rooms.h>
#include <pcl/segmentation/rooms/open_plan.h>
#include <pcl/segmentation/rooms/region_borders.h>
#include <pcl/segmentation/rooms/storey_space.h>
#include <pcl/segmentation/rooms/wall_sides.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief How the rooms of a storey are told apart. */
enum class RoomMethod {
  CeilingSlab, ///< in a slab below the ceiling, where walls and lintels close the rooms
  PotentialField ///< by the potential field and HDBSCAN: the thesis's own, Sec. 3.2.3
};

/** \brief How a storey's map is divided into rooms. */
struct RoomMapOptions {
  RoomMethod method = RoomMethod::CeilingSlab;
  FieldRoomsOptions field_rooms; ///< of RoomMethod::PotentialField
  CeilingSlabOptions slab;
  double persistence = 0.5;  ///< see BasinOptions
  double door_width = 1.15;  ///< narrower passages are doors, also without a lintel,
                             ///< metres (>= 0); see BasinOptions, MergeOptions
  MergeOptions merging;      ///< see mergeOpenRegions()
  OpenPlanOptions open_plan; ///< which open spaces are two rooms
  double min_width = 0.5;    ///< narrower spaces are no rooms, metres
  double min_area = 0.5;     ///< smaller spaces are no rooms, m^2
  bool merge_open = true;    ///< whether rooms with an open border between them are one
  double reach = 0.6; ///< how far a room's label is carried into its walls, metres
  int threads = 0;    ///< 0 = automatic
};

/** \brief The map of one storey and every step on the way to it. */
struct RoomMap {
  int first_layer = 0;                ///< layer of the building's grid that is layer 0
  VerticalRange range;                ///< layers from floor to ceiling
  PixelMap<int> ceiling;              ///< layer of the ceiling, -1 = none
  SlabLayers slab;                    ///< where the walls were looked for
  PixelMap<std::uint8_t> blocked;     ///< 1 = wall or lintel below the ceiling
  PixelMap<Eigen::Vector2f> lean;     ///< see leanMap(); empty if all walls are upright
  PixelMap<float> field;              ///< distance to the next wall, metres; 0 = wall
  PixelMap<std::int32_t> free_labels; ///< room of each free pixel, 1 ... n; 0 = none
  PixelMap<std::int32_t> labels;      ///< the same, carried into the walls
  FieldRooms field_rooms;             ///< filled by RoomMethod::PotentialField
  std::int32_t room_count = 0;
};

/** \brief Divide a storey into rooms on its map. */
RoomMap
segmentRoomMap(const StoreySpace& space, const RoomMapOptions& options);

} // namespace indoor
} // namespace pcl
