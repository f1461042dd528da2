/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/options.h" // for Setting
#include "pipeline/pipeline_options.h"
#include "scene/scene_file.h"

#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Find out, before the long work, what cannot be written.
 * \throws ToolError naming it */
void
requireUsable(const PipelineOptions& options);

/** \brief Add what was found to the cloud, as it is to be written. */
void
complete(const PipelineOptions& options, const Scene& scene, CloudFile& file);

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

/** \brief Make the folder and fill it, or leave nothing. Returns the names of the
 * results. */
std::string
save(const std::string& folder, const NamedBytes& texts, const CloudFile& file);

} // namespace pcl::indoor::tool
