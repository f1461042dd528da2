/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/options.h" // for Setting
#include "pipeline/pipeline_options.h"
#include "rooms/filed_rooms.h"
#include "scene/scene_file.h"

#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Find out, before the long work, what cannot be written.
 * \throws ToolError naming it */
void
requireUsable(const PipelineOptions& options);

/** \brief Add what was found to the cloud, as it is to be written beside its place. */
OutputFile
completeCloud(const PipelineOptions& options, const Scene& scene, CloudFile& file);

/** \brief The same of a scan that is read in parts.
 * \param[in,out] scene gets the objects of its sample
 * \param[in] first_object per room, what is added to the numbers of its objects
 */
OutputFile
completeCloudInParts(const PipelineOptions& options,
                     const FiledRooms& filed,
                     const WorkFolder& folder,
                     const std::vector<std::uint32_t>& first_object,
                     Scan& scan,
                     Scene& scene,
                     const PointsDone& report);

using NamedBytes = std::vector<std::pair<std::string, std::string>>;

/** \brief The files beside the cloud, by their paths; scene.json is the last.
 * \param[in] settings the values that were used, for the record
 * \param[in] points of the scene, z up, metres
 */
NamedBytes
describe(const PipelineOptions& options,
         const std::vector<Setting>& settings,
         const Scene& scene,
         const PointCloud<PointXYZ>& points,
         const CloudFile& file);

/** \brief Put all results into the folder. */
void
save(const std::string& folder, const NamedBytes& texts, OutputFile cloud);

/** \brief The names of all results, for a person. */
std::string
namesOf(const NamedBytes& texts);

} // namespace pcl::indoor::tool
