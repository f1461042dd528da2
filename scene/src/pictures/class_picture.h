/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/svg_drawing.h"
#include "scene/scene_json.h"

#include <pcl/indoor/exports.h>

namespace pcl::indoor::tool {

/** \brief The objects of a scene from above, in the colours of their classes, with a
 * legend of the classes that occur; what is "other" is grey, and ceilings are left out.
 * Storeys lie below each other, the highest on top.
 * \param[in] points one per point of the scene, z up
 */
PCL_INDOOR_EXPORTS SvgDrawing
drawClasses(const Scene& scene, const PointCloud<PointXYZ>& points);

} // namespace pcl::indoor::tool
