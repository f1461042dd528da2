/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "building/building_stages.h"
#include "command_line/options.h"
#include "pipeline/pipeline_options.h"
#include "pipeline/ranks.h"

#include <cstdint>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What tells runs apart whose rooms and objects may differ: the content of the
 * scan and of the model, the settings of these, and the version of the program.
 *
 * The content, not the time of the last change or a sample: a scan that was written
 * again by another program may have the same time, size and header.
 */
std::uint64_t
keyOfRun(const PipelineOptions& options, const std::vector<Setting>& settings);

/** \brief Read the scan: all of it, or a point per cell if it is too large. */
ScanContent
readScan(const PipelineOptions& options, Progress& progress);

/** \brief Find the objects of the rooms, room by room, and what they are; with all
 * ranks if there are several.
 * \return the cloud with all that was found, beside its place */
OutputFile
completedCloud(const PipelineOptions& options,
               ObjectSearch search,
               WorkFolder& folder,
               Ranks& ranks,
               ScanContent& scan,
               FoundBuilding& building);

} // namespace pcl::indoor::tool
