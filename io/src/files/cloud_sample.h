/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_stream.h"

#include <pcl/indoor/exports.h>

#include <cstddef>
#include <cstdint>
#include <functional>

namespace pcl::indoor::tool {

/** \brief Where to look in a file to see what it is like: at blocks of points from all
 * over it, at all points of a small one.
 * \param[in] visit gets the first point and the number of points of each block
 */
void
sampleBlocks(std::uint64_t point_count,
             const std::function<void(std::uint64_t first, std::size_t count)>& visit);

/** \brief The points of these blocks. */
PCL_INDOOR_EXPORTS PCLPointCloud2
pointsFromAllOver(CloudStream& stream);

} // namespace pcl::indoor::tool
