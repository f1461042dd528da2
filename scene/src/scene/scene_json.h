/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/scene/scene.h>

#include <nlohmann/json.hpp>

namespace pcl::indoor::tool {

/** \brief A scene, as scene/schema/scene.schema.json has it. */
nlohmann::ordered_json
sceneJson(const Scene& scene);

} // namespace pcl::indoor::tool
