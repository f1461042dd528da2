/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/map/room_map.h"

#include <pcl/indoor/voxel_bits.h>
#include <pcl/indoor/voxel_map.h>
#include <pcl/segmentation/building_rooms_options.h>

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace pcl::indoor {

/** \brief Two regions, the smaller label first; 0, 0 = none. */
using RegionPair = std::pair<std::int32_t, std::int32_t>;

/** \brief The border between two adjacent regions of a room map, seen as a wall. */
struct RegionBorder {
  std::int32_t a = 0;       ///< the smaller label
  std::int32_t b = 0;       ///< the larger label
  double border_area = 0.0; ///< length of the border times the height there, m^2
  double open_area = 0.0;   ///< the part of it through which one region sees the other
  double opening_area =
      0.0; ///< area from floor to ceiling where a person can pass, m^2
  /** length of the border where a person can pass: of its pieces along y, and of those
   * along x, metres */
  Eigen::Vector2d opening_run = Eigen::Vector2d::Zero();
};

/** \brief The regions of a storey, and what may stand between them. */
struct BorderMap {
  const VoxelBits& occupancy;
  VerticalRange storey;                      ///< the layers that count
  const PixelMap<int>& ceiling;              ///< as ceilingLayers() gives it
  const PixelMap<std::int32_t>& labels;      ///< of every pixel of the regions and of
                                             ///< the walls between them, 0 = none
  const PixelMap<std::int32_t>& free_labels; ///< the same on the free pixels alone
  const PixelMap<std::uint8_t>& blocked;     ///< by walls, as blockedColumns() gives it
};

/** \brief The regions of a map.
 * \param[in] occupancy of its storey */
inline BorderMap
borderMap(const RoomMap& map, const VoxelBits& occupancy)
{
  return {occupancy, map.range, map.ceiling, map.labels, map.free_labels, map.blocked};
}

/** \brief Find the borders between regions and how far they are open.
 *
 * A piece of border is open at a height if no voxel is occupied there between the free
 * space of the one region and that of the other: hollow walls are closed. Furniture and
 * people are no walls: a piece without a blocked column is open at all heights, unless
 * most of it is closed up to the heads, as by a wall whose upper part was not seen.
 * \return one entry per pair of regions that touch, in the order of (a, b)
 */
std::vector<RegionBorder>
regionBorders(const BorderMap& map);

/** \brief A place where a person can pass from one region to another. */
struct RegionOpening {
  std::int32_t a = 0; ///< the smaller label
  std::int32_t b = 0; ///< the larger label
  double x = 0.0;     ///< its middle, grid frame, pixels; pixel 0 covers 0 ... 1
  double y = 0.0;     ///< its middle, grid frame, pixels
  Eigen::Vector2d along = Eigen::Vector2d::UnitX(); ///< of the border, a unit vector
  double width = 0.0;                               ///< metres
  double area = 0.0;                                ///< of what is open, m^2
  /** Its middle over the middle between floor and ceiling, metres: below 0 under a
   * lintel. */
  double rise = 0.0;
};

/** \brief Find the openings in the borders between regions.
 *
 * Pieces of border that a person can pass and that are at most two pixels apart are one
 * opening: two doors between the same two regions are two. Gaps narrower than 0.3 m are
 * left out.
 *
 * \return in the order of (a, b), then of their first pixel
 */
std::vector<RegionOpening>
regionOpenings(const BorderMap& map);

/** \brief Whether two spaces are two rooms however open the border between them is;
 * each is given by the labels of its regions. */
using StayApart = std::function<bool(const std::vector<std::int32_t>& a,
                                     const std::vector<std::int32_t>& b)>;

/** \brief Join regions between which the passage is wide and high, the widest first.
 *
 * A room ends where the passage to the next space is small compared with the spaces
 * themselves (Sec. 3.1): at a door, not below a beam.
 * \param[in] borders as regionBorders() gives them
 * \param[in] section per label (index 0 unused): area of the widest vertical section
 * through the region, m^2 (> 0)
 * \param[in] door_width narrower openings are doors, also without a lintel, metres
 * \param[in] stay_apart asked before two spaces are joined, and again after one of them
 * has grown; empty: never
 * \return the new label of each old one, that of the smallest member; 0 stays 0
 */
std::vector<std::int32_t>
mergeOpenRegions(const std::vector<RegionBorder>& borders,
                 const std::vector<double>& section,
                 const MergeOptions& options = {},
                 double door_width = 0.0,
                 const StayApart& stay_apart = {});

/** \brief Join niches to the rooms that they are part of: small regions that are open
 * to a lower one over all their width.
 *
 * A ceiling that mirrors feigns a higher one in parts of a room. What would be the
 * lintel before such a part is the ceiling of the room; doors are narrower than what
 * lies behind them.
 * \param[in] area, volume per label (index 0 unused), m^2 and m^3
 * \return the new label of each old one, that of a member; 0 stays 0
 */
std::vector<std::int32_t>
mergeNiches(const std::vector<RegionOpening>& openings,
            std::vector<double> area,
            std::vector<double> volume);

} // namespace pcl::indoor
