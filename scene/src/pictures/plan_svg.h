/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/floor_plan.h"

#include <pcl/indoor/exports.h>

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The plan of all storeys as an SVG drawing for printing, the highest on top: a
 * group per storey, id "storey-0" and so on; room areas filled in pale colours, with
 * number and area; walls as lines; doors with their arcs, openings with their widths; a
 * scale bar and the direction of y.
 */
PCL_INDOOR_EXPORTS std::string
planSvg(const FloorPlan& plan);

/** \brief A drawing per storey, from below, for a page that styles and names the parts
 * itself: without widths, scale bar and direction, but with the objects. */
std::vector<std::string>
storeySvgs(const FloorPlan& plan);

} // namespace pcl::indoor::tool
