/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "files/cloud_stream.h"

#include <cstdint>
#include <memory>
#include <string>

namespace pcl::indoor::tool {

/** \brief Does a file with this beginning hold LAS points, compressed (LAZ) or not? */
bool
isLas(const std::string& path, const std::string& beginning);

/** \brief How many points the header of a LAS or LAZ file promises; 0 if it is not
 * understood.
 * \param[in] beginning of the file, 512 bytes if it has as many */
std::uint64_t
lasPointCount(const std::string& path, const std::string& beginning);

/** \brief Open a file, after a look at all of its points.
 * \return null if it has none
 * \throws ToolError as loadLas() */
std::unique_ptr<CloudStream>
openLasFile(const std::string& path);

/** \brief Read the points of a LAS or LAZ file, versions 1.0 to 1.4, point formats 0 to
 * 10.
 *
 * The fields are x, y, z as doubles, with scale and offset applied; intensity,
 * classification, point_source_id, return_number, number_of_returns,
 * scan_direction_flag, edge_of_flight_line, classification_flags, user_data, scan_angle
 * in degrees; scanner_channel, gps_time, rgb and nir where the format has them; and the
 * dimensions of extra bytes by their own names, with their scales and offsets, those of
 * 64-bit integers as doubles. Of colours of 16 bits rgb has the upper 8, and red_16,
 * green_16 and blue_16 are all of them if there is more to them; where none exceeds
 * 255, they are taken as they are. Points that are withheld are NaN. Waveforms are left
 * out.
 * \throws ToolError if the file is damaged or has fewer points than its header promises
 */
void
loadLas(CloudFile& file, const TableColumns& columns);

} // namespace pcl::indoor::tool
