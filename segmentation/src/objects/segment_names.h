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

/** Number the segments, and tell which are floor, wall or ceiling. Those of fewer
 * voxels than a supervoxel, too small to be told, become one, the remainder. \param[in]
 * supervoxel voxels; 0 for no remainder */
void
nameSegments(double supervoxel, ObjectSegmentation& result);

} // namespace indoor
} // namespace pcl
