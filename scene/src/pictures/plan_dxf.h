/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/floor_plan.h"

#include <pcl/indoor/exports.h>

#include <string>

namespace pcl::indoor::tool {

/** \brief The plan as a DXF drawing (ASCII, release 12) for CAD programs: metres,
 * places of the scan, y up. The storeys have layers of their own, STOREY0_ROOMS (closed
 * lines), _WALLS (lines), _OPENINGS (leaves, arcs and thresholds) and _TEXT (numbers
 * and areas).
 */
PCL_INDOOR_EXPORTS std::string
planDxf(const FloorPlan& plan);

} // namespace pcl::indoor::tool
