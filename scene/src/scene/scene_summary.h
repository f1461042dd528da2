/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "scene/scene_json.h"
#include "text/text_table.h"

#include <pcl/indoor/exports.h>

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A scene in one line, for example "2 storeys, 21 rooms, 318 objects". */
PCL_INDOOR_EXPORTS std::string
summaryOf(const Scene& scene);

/** \brief The same at length: rooms and areas per storey, and objects by class, the
 * commonest first, where there are classes. */
PCL_INDOOR_EXPORTS std::vector<TextTable>
tablesOf(const Scene& scene);

} // namespace pcl::indoor::tool
