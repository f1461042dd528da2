/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "datasets/labelled_scan.h"

#include <string>

namespace pcl::indoor::tool {

/** \brief The files of a depth image with labels, as NYU v2 and SUN RGB-D have them. */
struct DepthImageFiles {
  std::string depth;       ///< PNG of 16 bits, 0 = no depth
  std::string intrinsics;  ///< text of 9 numbers: the camera matrix, row by row
  std::string labels;      ///< PNG, number of the category, 0 = none
  std::string instances;   ///< PNG, number of the object in its category; may be empty
  std::string color;       ///< PNG; may be empty
  std::string label_names; ///< text, the name of label 1, 2, ... per line; may be empty
  double depth_unit = 0.001; ///< metres
  bool is_rotated = false;   ///< depths are rotated left by three bits (SUN RGB-D)
};

/** \brief Is a folder a scan of SUN RGB-D: depth/NAME.png and intrinsics.txt? */
bool
isSunRgbd(const std::string& folder);

/** \brief Put depth image and intrinsics of a folder of SUN RGB-D among the files; an
 * intrinsics file that is given stays.
 * \throws ToolError if there is not one depth image
 */
void
findSunRgbd(const std::string& folder, DepthImageFiles& files);

/** \brief Make an organised cloud of a depth image, in the camera's frame: x to the
 * right, y down, z forward.
 *
 * Pixel (u, v) of depth z is at ((u - cx) z / fx, (v - cy) z / fy, z), counted from 0.
 * Pixels without depth are NaN and have no labels. An object is a pair of label and
 * instance, or a label where there are no instances; numbers follow these.
 * \throws ToolError if a file is missing or damaged, if images differ in size, if the
 * depth has not 16 bits, if no pixel has a depth, if the intrinsics are no camera
 * matrix, or if a label has no name
 */
LabelledScan
readDepthImage(const DepthImageFiles& files);

/** \brief Read a cloud with an image of its objects, as OSD has them.
 * \param[in] labels PNG, number of the object, as large as the organised cloud; empty:
 * the field label of the cloud has them. Points that are not finite have none.
 * \throws ToolError if a file is missing or damaged, or if the sizes differ
 */
LabelledScan
readLabelledCloud(const std::string& cloud, const std::string& labels);

} // namespace pcl::indoor::tool
