/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_stream.h"

#include <memory>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A cloud in memory, read part by part. */
std::unique_ptr<CloudStream>
streamInMemory(PCLPointCloud2 cloud,
               const CloudPose& pose,
               std::vector<std::string> notes = {},
               std::vector<Station> stations = {});

/** \brief Several scans of one building, from several stations, as one: their points
 * one scan after the other, in the frame of the first one's offset.
 *
 * It has the fields that all of them have with the same type, in the order of the
 * first, and the field station: from 1, at which station a point was measured. A scan
 * that tells no stations has one. Coordinates stay
 * floats if they are floats in all and all tell the same offset; else they are doubles.
 * Of the sensors' poses only the positions are kept, see CloudStream::stations().
 * \param[in] names of the scans; the stations of one that has several have its name and
 * their own
 * Its notes are those of the scans, and one on fields that not all of them have.
 * \throws ToolError if there are more points than a file can have, 2^32 - 1
 */
std::unique_ptr<CloudStream>
joinedStream(std::vector<std::unique_ptr<CloudStream>> scans,
             const std::vector<std::string>& names);

} // namespace pcl::indoor::tool
