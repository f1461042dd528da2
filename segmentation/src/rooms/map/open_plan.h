/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>
#include <pcl/segmentation/building_rooms_options.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Give what stands free in a room, such as a pillar or a lamp, to the room:
 * pixels of no room that are connected and that one room surrounds (8 neighbours).
 * \param[in] rooms room of each free pixel, 0 = none
 */
PixelMap<std::int32_t>
fillIslands(PixelMap<std::int32_t> rooms);

/** \brief Tells rooms of an open plan apart, such as the kitchen and the bedroom of a
 * studio: each is large and compact enough to be lived in, and who is in one sees
 * little of the other. Sec. 3.1 and 3.2.2 name visibility as what makes a space one.
 */
class OpenPlan {
public:
  /** \param[in] labels region of each free pixel, 0 = none
   * \param[in] field distance of each pixel to the next wall, metres; 0 = wall
   * \param[in] pixel_size metres
   * \param[in] options what makes two spaces two rooms
   */
  OpenPlan(const PixelMap<std::int32_t>& labels,
           const PixelMap<float>& field,
           double pixel_size,
           const OpenPlanOptions& options);

  /** \brief Whether two spaces, each of one or more regions, are two rooms. */
  bool
  separates(const std::vector<std::int32_t>& a,
            const std::vector<std::int32_t>& b) const;

  /** \brief The share of straight lines between two spaces that nothing blocks, 0 ...
   * 1, estimated from 64 pixels of each. */
  double
  sharedView(const std::vector<std::int32_t>& a,
             const std::vector<std::int32_t>& b) const;

  /** \brief Whether a space is large and compact enough to be lived in. */
  bool
  isHabitable(const std::vector<std::int32_t>& space) const;

  /** \brief The floor area of a space, m^2. */
  double
  area(const std::vector<std::int32_t>& space) const;

private:
  OpenPlanOptions options_;
  double pixel_area_;
  VoxelMap<std::uint8_t> walls_;                   ///< of one layer
  std::vector<std::vector<std::uint32_t>> pixels_; ///< per label, in order
  std::vector<double> width_;                      ///< per label, metres
};

} // namespace pcl::indoor
