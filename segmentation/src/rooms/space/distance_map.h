/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::indoor {

/** \brief The squared distance where there is nothing to measure it to. */
constexpr std::uint32_t kNoObstacle = std::numeric_limits<std::uint32_t>::max();

/** \brief The squared distance of every pixel to the nearest obstacle.
 * Exact (Meijster, Roerdink and Hesselink, "A general algorithm for computing distance
 * transforms in linear time", 2000); time linear in the pixels.
 * \param[in] obstacles non-zero = obstacle
 * \param[in] threads 0 = automatic; the result does not depend on it
 * \return between pixel centres, in pixels squared; kNoObstacle if there is no obstacle
 */
PixelMap<std::uint32_t>
squaredDistanceMap(const PixelMap<std::uint8_t>& obstacles, int threads = 0);

/** \brief One pass of such a transform along an axis: `slabs` slabs of lines; in a
 * slab, line j of `lines` has its elements at slab_start + j + k * stride, k < length.
 * \param[in,out] values squared distances across the axis; after it those in the plane
 */
void
transformAlong(std::vector<std::uint32_t>& values,
               std::size_t slabs,
               std::size_t slab_stride,
               std::size_t lines,
               std::size_t stride,
               int length,
               int threads);

} // namespace pcl::indoor
