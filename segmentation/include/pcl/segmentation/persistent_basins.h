/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/segmentation/voxel_grid.h>

#include <cstdint>

namespace pcl {
namespace indoor {

/** \brief Split a map into the basins around its persistent maxima.
 *
 * The map is flooded from its highest values down (a watershed, 8 neighbours). Where
 * two basins meet, the one with the lower maximum is joined to the other unless the
 * pass between them is narrow: lower than \a persistence times that maximum. On a
 * distance map, the maximum is the half width of a room and the pass the half width of
 * an opening, so a long corridor stays whole although its many maxima differ a little.
 * \param[in] field values to flow down; 0 = not part of any basin
 * \param[in] persistence share of the lower maximum, 0 ... 1; larger gives more basins
 * \return basin of each pixel, 1 ... n numbered by their first pixel; 0 where the field
 * is 0
 */
PixelMap<std::int32_t>
persistentBasins(const PixelMap<float>& field, float persistence);

} // namespace indoor
} // namespace pcl
