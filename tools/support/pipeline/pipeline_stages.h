/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/options.h"
#include "pipeline/pipeline_options.h"
#include "pipeline/pipeline_results.h"
#include "pipeline/ranks.h"
#include "rooms/scene_rooms.h"
#include "scene/understood_scan.h"

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

/** \brief What the objects of each room are looked for with, but for the building's
 * pose, which is not known yet. */
RoomWork
roomWork(const PipelineOptions& options);

/** \brief Read the scan: all of it, or a point per cell if it is too large. */
Scan
loadScan(const PipelineOptions& options, Progress& progress);

/** \brief Find the rooms of the scan, unless the folder has them. */
Scene
findRooms(const PipelineOptions& options,
          const CloudFile& file,
          const UnderstoodScan& understood,
          WorkFolder& folder,
          Progress& progress);

/** \brief The points as the objects are looked for: z up, metres, what lies beyond the
 * building not finite. */
PointCloud<PointXYZ>::ConstPtr
standingPoints(const CloudFile& file, const RoomWork& work, const Scene& scene);

/** \brief Find the objects of the rooms, room by room, and what they are.
 * \param[in] standing tells which points count
 * \return the cloud with all that was found, beside its place */
OutputFile
findObjects(const PipelineOptions& options,
            Scan& scan,
            const PointCloud<PointXYZ>& standing,
            const RoomWork& work,
            WorkFolder& folder,
            Ranks& ranks,
            Scene& scene,
            Progress& progress);

} // namespace pcl::indoor::tool
