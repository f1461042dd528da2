/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/space/interior_space.h"

#include <pcl/indoor/voxel_map.h>
#include <pcl/segmentation/thesis.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief The rooms of a storey on its field map, and each step on the way to them. */
struct FieldRooms {
  VoxelMap<std::uint32_t> potential; ///< anisotropic potential field, voxels squared
  PixelMap<float> field;             ///< its highest interior value per column
  PixelMap<int> highest_free;        ///< layer of the highest interior voxel, -1 = none
  std::vector<float> thresholds;     ///< peaks of the field's histogram
  PixelMap<int> clusters;            ///< of HDBSCAN or DBSCAN*: 0 ... n - 1; -1 = none
  PixelMap<int> labels; ///< after peaks and random walker; -1 = no interior
};

/** \brief Divide a storey into rooms as the thesis does: potential field, field map,
 * visibility, HDBSCAN of the combined distance, local peaks, random walker.
 * \param[in] space of this storey alone
 * \param[in] slab how the ceiling is found
 * \throws pcl::BadArgumentException if an option is out of its range
 */
FieldRooms
segmentFieldMap(const InteriorSpace& space,
                const thesis::FieldRoomsOptions& options = {},
                const CeilingSlabOptions& slab = {});

} // namespace pcl::indoor
