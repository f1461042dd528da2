/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <cstddef>
#include <string>

namespace pcl::indoor {

constexpr double smallest_automatic_voxel = 0.1; ///< metres
constexpr double largest_automatic_voxel = 0.4;  ///< metres: half as wide as a door

/** \brief The weights of the evidence for interior space, Eq. (3.1). */
struct EnclosureWeights {
  double below = 1.5;      ///< w1: occupied below
  double above = 0.5;      ///< w2: occupied above
  double vertical = 0.5;   ///< w3: occupied below and above
  double horizontal = 1.0; ///< w4 + w5: shared equally by all horizontal directions
  double exterior = 1.5;   ///< evidence that exterior space has without any enclosure;
                           ///< larger sends more voxels outside
};

/** \brief How interior free space is told from exterior (Sec. 3.2.1). */
struct InteriorSpaceOptions {
  double voxel_size = 0.2; ///< metres; rounded to a multiple of the input's voxels
  EnclosureWeights weights;
  double smoothness = 0.6;        ///< E_{v,u} of Eq. (3.2) where labels differ (>= 0)
  std::size_t max_directions = 4; ///< of enclosure, the best supported ones
  double min_direction_support = 0.02; ///< see HorizontalDirection
  bool upright_walls = true; ///< walls count by where they head; false: enclosure is
                             ///< looked for along their normals in space
};

struct StoreyOptions {
  double min_clearance =
      1.5;               ///< least free height above and below a slab, metres (> 0)
  double max_slab = 1.1; ///< greatest height of a slab with what stands on it and
                         ///< hangs under it, metres (>= 0)
  double min_slab_area = 10.0; ///< least area of a slab, m^2 (> 0); larger ignores
                               ///< galleries
  double bridge = 1.5; ///< openings in a slab that are at most twice this wide, as of
                       ///< stairs, are cut at the slab's height, metres (>= 0)
  double min_opening_area = 12.0; ///< a larger opening is a hall, m^2 (>= 0); it
                                  ///< belongs to the storey of its floor
};

/** \brief Where the walls of a storey are looked for: in a slab right below the
 * ceiling.
 *
 * Furniture seldom reaches the ceiling; walls and the lintels over doorways do. So the
 * slab shows the rooms closed, where a map of the whole height shows them cluttered and
 * joined by their doors.
 */
struct CeilingSlabOptions {
  double window =
      1.0;           ///< side of the square in which the ceiling is looked for, metres
  double step = 0.6; ///< how far a column's own top may lie below the highest top in
                     ///< the window and still be its ceiling, metres
  double level_share = 0.3; ///< a column's own top is its ceiling, too, if more than
                            ///< this share of the window's columns have tops within a
                            ///< voxel of it
  double min_height = 1.8;  ///< a ceiling is at least so high above the floor, metres
  double gap = 0.15;        ///< least distance from the ceiling to the slab, metres
  double max_gap = 0.6;  ///< greatest distance, where noise blurs the ceiling, metres
  double min_wall = 0.5; ///< what is shorter in the slab is no wall, metres
  double depth = 0.3;    ///< height of the slab, metres
};

/** \brief Which regions are one room. */
struct MergeOptions {
  double open_share = 0.55; ///< the open area is more than this share of the border and
                            ///< of the smaller region's section, 0 ... 1; larger gives
                            ///< more rooms
  double door_share = 0.75; ///< spaces with a door between them are joined above this
                            ///< open share only, 0 ... 1
  double open_height = 0.8; ///< the opening reaches over at least this share of the
                            ///< height: beams may be above it, lintels not, 0 ... 1;
                            ///< larger gives more rooms
};

/** \brief When two spaces without a door between them are two rooms. */
struct OpenPlanOptions {
  /** Smallest floor area of each, m^2. Building codes ask 6.5 of a habitable room
   * (International Residential Code, R304.1); infinity joins all open spaces. */
  double habitable_area = 6.5;
  double max_elongation = 2.5;  ///< a space with a larger area over the square of its
                                ///< width is a corridor; its arms stay one room
  double persistence = 0.85;    ///< two spaces may be two rooms if the passage between
                                ///< them is at most this share of the width of the
                                ///< narrower one, 0 ... 1
  double min_wall_share = 0.4;  ///< a wall within a room parts it if it fills at least
                                ///< this share of the straight line that it lies on,
                                ///< 0 ... 1; larger gives fewer rooms
  double max_shared_view = 0.7; ///< two spaces are two rooms if at most this share of
                                ///< the straight lines between them is free, 0 ... 1
};

/** \brief How a storey's map is divided into rooms. */
struct RoomMapOptions {
  CeilingSlabOptions slab;
  double persistence = 0.5;  ///< see BasinOptions
  double door_width = 1.15;  ///< narrower passages are doors, also without a lintel,
                             ///< metres (>= 0); see BasinOptions,
                             ///< mergeOpenRegions()
  MergeOptions merging;      ///< see mergeOpenRegions()
  OpenPlanOptions open_plan; ///< which open spaces are two rooms
  double min_width = 0.5;    ///< narrower spaces are no rooms, metres
  double min_area = 0.5;     ///< smaller spaces are no rooms, m^2
  double reach = 0.6; ///< how far a room's label is carried into its walls, metres
};

/** \brief How the two faces of a wall are told apart. */
struct WallSideOptions {
  double window = 0.5;        ///< side of the square in which a wall is fitted, metres
  double max_thickness = 0.3; ///< what is thicker is not taken for one wall, metres
  double reach = 0.5; ///< how far from the wall its rooms are looked for, metres
  std::size_t min_points = 8; ///< fewer points make no wall (>= 2)
};

/** \brief All parameters of the way from a building's points to its rooms. */
struct BuildingRoomsOptions {
  double voxel_size = 0.0; ///< side of a voxel and of a map pixel, metres (>= 0); 0 =
                           ///< automatic: 0.1, up to 0.4 where the points are so sparse
                           ///< that their surfaces would have holes
  InteriorSpaceOptions interior;
  StoreyOptions storeys;
  RoomMapOptions map;
  WallSideOptions walls;
  bool align_grid = true; ///< whether voxels lie along the best supported walls
  int threads = 0; ///< of all stages, 0 = automatic; the result does not depend on it
};

/** \brief What is wrong with the options: one sentence with the value and the range.
 * \return empty if all are in range
 */
PCL_INDOOR_EXPORTS std::string
findProblem(const BuildingRoomsOptions& options);

} // namespace pcl::indoor
