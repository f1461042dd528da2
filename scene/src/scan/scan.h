/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/scan_content.h"

#include <pcl/indoor/exports.h>

#include <functional>

namespace pcl::indoor::tool {

/** \brief The unit that the points seem to be in, metres: see RoomSegmentation. */
double
metresPerUnitOf(CloudStream& stream);

/** \brief Read a scan part by part, keeping a point per cell.
 * \param[in,out] scan has a stream and gets its sample
 * \param[in] cell_size in the unit of the file
 * \param[in] most_points from which on cells become larger
 */
PCL_INDOOR_EXPORTS void
drawSample(ScanContent& scan,
           double cell_size,
           std::size_t most_points,
           const std::function<void(std::size_t done, std::size_t all)>& report);

/** \brief Read no more of a large scan than points from all over it.
 * \param[in,out] scan has a stream; its file gets no more points than these
 */
PCL_INDOOR_EXPORTS void
drawFewPoints(ScanContent& scan);

/** \brief A part of a scan that is read in parts, in the frame of its sample. */
CloudFile
partOf(const ScanContent& scan, PCLPointCloud2 part);

} // namespace pcl::indoor::tool
