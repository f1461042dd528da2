/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <cstdint>

namespace pcl::indoor {

/** \brief When a pass between two basins is narrow. */
struct BasinOptions {
  double persistence; ///< a pass is narrow if it is lower than this share of the lower
                      ///< of the two maxima, 0 ... 1; larger gives more basins
  double door = 0.0;  ///< half the width up to which a pass is a door
  double door_persistence = 0.0; ///< a door parts two basins if it is lower than this
                                 ///< share of the lower maximum
};

/** \brief Split a map into the basins around its persistent maxima.
 *
 * The map is flooded from its highest values down (a watershed, 8 neighbours). Where
 * two basins meet, the one with the lower maximum is joined to the other unless the
 * pass between them is narrow compared with that maximum, see BasinOptions. On a
 * distance map, the maximum is the half width of a room and the pass the half width of
 * an opening, so a long corridor stays whole although its many maxima differ a little.
 * \param[in] field values to flow down; 0 = not part of any basin
 * \return basin of each pixel, 1 ... n numbered by their first pixel; 0 where the field
 * is 0
 */
PixelMap<std::int32_t>
persistentBasins(const PixelMap<float>& field, const BasinOptions& options);

} // namespace pcl::indoor
