/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <cstddef>
#include <cstdint>

namespace pcl::indoor::tool {

/** \brief Unpack the points of a PCD file with DATA binary_compressed: all values of
 * its first field, then those of the next, compressed by LZF.
 *
 * They go to their places piece by piece: PCL's reader unpacks all of them to other
 * memory first.
 * \param[in] packed,size the compressed bytes
 * \param[in,out] cloud has its fields and the memory for its points; is_dense says
 * whether all real numbers are finite
 * \return false if the bytes are damaged, or are not just those of the points
 */
bool
unpackPoints(const std::uint8_t* packed, std::size_t size, PCLPointCloud2& cloud);

} // namespace pcl::indoor::tool
