/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/space/enclosure.h"
#include "rooms/space/grid_cut.h"

namespace pcl::indoor {

/** \brief The same as interiorGain() in a byte per voxel.
 * \param[in] bits result of enclosure(), whose memory becomes that of the codes
 * \throws pcl::BadArgumentException as interiorGain() does
 */
CodedGains
codedInteriorGain(const VoxelMap<std::uint8_t>& occupancy,
                  VoxelMap<std::uint8_t> bits,
                  int direction_count,
                  const EnclosureWeights& weights = {},
                  double unit = 0.01);

} // namespace pcl::indoor
