/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "datasets/labelled_scan.h"

#include <string>

namespace pcl::indoor::tool {

/** \brief Has a folder a file SCENE_vh_clean_2.ply? */
bool
isScanNet(const std::string& folder);

/** \brief Read a scene of ScanNet (Dai et al., CVPR 2017).
 *
 * Of its folder SCENE_vh_clean_2.ply (points), SCENE_vh_clean_2.0.010000.segs.json
 * (segment of each vertex) and SCENE.aggregation.json (groups of segments). A group is
 * an object, numbered by its id + 1; vertices in no group, which nobody annotated, have
 * 0. Of two groups with the same segment the later one in the file gets it, as in the
 * set's own scripts. Categories are the labels, by name.
 * \throws ToolError if a file is missing or damaged, if there are not as many segments
 * as vertices, if a group has no label, an id that another has, or a segment of no
 * vertex
 */
LabelledScan
readScanNet(const std::string& folder);

} // namespace pcl::indoor::tool
