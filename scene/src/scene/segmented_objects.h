/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"

#include <pcl/indoor/exports.h>
#include <pcl/scene/scene_options.h> // for CoordinateOptions
#include <pcl/segmentation/thesis.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief How the objects of a room are looked for. */
struct ObjectChoices {
  CoordinateOptions scan;
  bool asks_for_tables =
      false; ///< whether the scan is one is found out; else it is not
  /** \brief What to segment with, a table or anything else; where there are pieces,
   * the shared options alone count. */
  std::function<thesis::ObjectOptions(bool is_table)> options;
  bool has_pieces = true; ///< or it is segmented by the thesis's method
  /** see NoiseResilientLCCP::setUseSingleCameraTransform(), which else finds it out */
  std::optional<bool> is_single_view;
  bool ignore_normals = false, remove_outliers = false;
};

/** \brief The objects of a room, in the order of the points. */
struct SegmentedObjects {
  std::vector<std::uint32_t> object_of_point;    ///< 0 = not finite or an outlier
  std::vector<std::uint32_t> structure_of_point; ///< 1 floor, 2 wall, 3 ceiling, 4
                                                 ///< remainder, 0 anything else
  std::uint32_t count = 0;                       ///< of objects
};

/** \brief Find the objects of a room.
 * \param[in] warn is told what is implausible, a line each
 * \throws ToolError if nothing can be found, or points lack colours that are wanted
 */
PCL_INDOOR_EXPORTS SegmentedObjects
segmentObjects(const ObjectChoices& choices,
               const CloudFile& file,
               const std::function<void(const std::string& line)>& warn);

} // namespace pcl::indoor::tool
