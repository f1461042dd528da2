/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_stream.h"

#include <cstdint>
#include <memory>
#include <string>

namespace pcl::indoor::tool {

/** \brief Is it a PTX file, as Leica's programs write them? By its first lines, or by
 * the ending of its name. */
bool
isPtx(const std::string& path, const std::string& beginning);

/** \brief About how many points a PTX file has: as many as it has lines. */
std::uint64_t
ptxPointCount(const std::string& path, const std::string& beginning);

/** \brief Open a PTX file, after a look at its lines.
 *
 * Each scan in it has ten lines (columns, rows, the scanner's position and axes, a
 * matrix of four rows that a point is multiplied with from the left), and a line for
 * each point, column by column: x y z, intensity of 0 to 1, red green blue of 0 to 255;
 * intensity and colour may be absent. The fields are x, y, z as doubles, moved by the
 * matrix; intensity, rgb, row and column, from 0. Points at 0 0 0 saw no return: they
 * are NaN. Several scans are joined, see joinedStream(), with the field station.
 * \throws ToolError if a header is damaged, or if there are fewer points than promised;
 * a point that cannot be read is named when it is read
 */
std::unique_ptr<CloudStream>
openPtx(const std::string& path);

} // namespace pcl::indoor::tool
