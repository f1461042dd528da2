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

/** Number the segments, and say which are floor, wall or ceiling. Those of pieces that
 * are too small to be told become one segment, the remainder, see
 * ObjectSegmentationOptions::fewest_points. */
void
nameSegments(const ObjectSegmentationOptions& options, ObjectSegmentation& result);

} // namespace indoor
} // namespace pcl
