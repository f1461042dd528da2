/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/object_steps.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** How many voxels hold points of each segment, and how many points each has. */
struct SegmentSizes {
  std::vector<std::uint32_t> voxels, points;
};

/** REQUIRES: every point has a segment, below the count. */
SegmentSizes
sizesOfSegments(const DetailedSegmentation& result, std::size_t segment_count);

/** Number the segments from 0 in the order of their first points. */
void
numberSegments(DetailedSegmentation& result);

/** What the numbered segments are. For the segment that holds most points of a plane:
 * floor, wall or ceiling; None for all others. A segment with most of its points in no
 * plane is an object, such as a cabinet that has got the wall behind it. */
std::vector<StructureKind>
structureOfSegments(const DetailedSegmentation& result);

/** Number the segments, and say which are floor, wall or ceiling. Those that are too
 * small to be told become one segment, the remainder, see
 * ObjectSegmentationOptions::fewest_points. */
void
nameSegments(const ObjectSegmentationOptions& options, DetailedSegmentation& result);

} // namespace pcl::indoor
