/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"

#include <pcl/segmentation/building_rooms.h>

namespace pcl::indoor::tool {

/** \brief Where the scanner stood, in the frame of the file's points, and which of them
 * it measured from there; empty if that is not known. */
ScanStations
scanStations(const CloudFile& file);

} // namespace pcl::indoor::tool
