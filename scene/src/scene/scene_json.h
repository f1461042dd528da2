/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/scene/scene.h>

#include <nlohmann/json.hpp>

namespace pcl::indoor::tool {

/** \brief A scene, as scene/schema/scene.schema.json has it. */
PCL_INDOOR_EXPORTS nlohmann::ordered_json
sceneJson(const Scene& scene);

} // namespace pcl::indoor::tool
