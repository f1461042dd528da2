/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/output_file.h"
#include "pipeline/pipeline_options.h"

#include <pcl/scene/scene.h>

#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Find out, before the long work, what cannot be written.
 * \throws ToolError naming it */
void
requireUsable(const PipelineOptions& options);

using NamedBytes = std::vector<std::pair<std::string, std::string>>;

/** \brief The files beside the cloud, by their paths; scene.json is the last.
 * \param[in] points of the scene, z up, metres
 */
NamedBytes
describe(const PipelineOptions& options,
         const Scene& scene,
         const PointCloud<PointXYZ>& points);

/** \brief Put all results into the folder. */
void
save(const std::string& folder, const NamedBytes& texts, OutputFile cloud);

/** \brief The names of all results, for a person. */
std::string
namesOf(const NamedBytes& texts);

} // namespace pcl::indoor::tool
