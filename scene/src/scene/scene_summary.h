/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "scene/scene_json.h"

#include <pcl/indoor/exports.h>

#include <string>

namespace pcl::indoor::tool {

/** \brief A scene in one line, for example "2 storeys, 21 rooms, 318 objects". */
PCL_INDOOR_EXPORTS std::string
summaryOf(const Scene& scene);

} // namespace pcl::indoor::tool
