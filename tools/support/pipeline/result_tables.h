/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/progress.h"
#include "scene/scene_json.h"

#include <vector>

namespace pcl::indoor::tool {

/** \brief What the pipeline says at its end: rooms and areas per storey, objects by
 * class, the commonest first, and seconds per stage. */
std::vector<TextTable>
tablesOf(const Scene& scene, const std::vector<Progress::Stage>& stages);

} // namespace pcl::indoor::tool
