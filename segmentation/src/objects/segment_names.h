/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/object_segmentation.h>

namespace pcl {
namespace indoor {

/** Number the segments from 0 in the order of their first points. */
void
numberSegments(ObjectSegmentation& result);

/** Number the segments, and say which are floor, wall or ceiling. Segments of fewer
 * voxels than a supervoxel has become one segment together, the remainder.
 * \param[in] supervoxel voxels of a supervoxel; 0 for no remainder */
void
nameSegments(double supervoxel, ObjectSegmentation& result);

} // namespace indoor
} // namespace pcl
