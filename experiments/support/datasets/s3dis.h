/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "datasets/labelled_scan.h"

#include <string>

namespace pcl::indoor::tool {

/** \brief Is a folder a room of S3DIS, or an area with such rooms?
 * \throws ToolError if it holds several areas, naming one */
bool
isS3dis(const std::string& folder);

/** \brief Read a room or an area of S3DIS (Armeni et al., CVPR 2016).
 *
 * A room is a folder with Annotations/CLASS_NUMBER.txt, rows of x y z r g b; an area is
 * a folder of rooms. Each file is an object; files and rooms are numbered in the order
 * of their names. The categories are the set's own 13 and stairs, with the same numbers
 * in every scan; others follow by name. Rooms are numbered only in an area. Notes of
 * the files become those of the scan.
 * \throws ToolError if a room has no Annotations or these no files, or if a file is
 * none of points or has a name without number
 */
LabelledScan
readS3dis(const std::string& folder);

} // namespace pcl::indoor::tool
