/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/svg_drawing.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief One way to label the points of a scene. */
struct LabelledView {
  std::string title;
  std::vector<std::uint32_t> labels; ///< one per point
};

/** \brief Draw a scene side by side in the colours of several labellings: a room from
 * obliquely above, a single view from its camera.
 * \param[in] views the first is the truth, after which the colours of the others are
 * chosen; points that it labels 0 are grey everywhere
 */
SvgDrawing
drawSideBySide(const PointCloud<PointXYZ>& cloud,
               bool single_view,
               const std::vector<LabelledView>& views);

} // namespace pcl::indoor::tool
