/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A scan of a data set with its truth: a number per point, 0 = none. */
struct LabelledScan {
  CloudFile file; ///< x, y, z, most times colours, other fields of the files
  std::vector<std::uint32_t> rooms; ///< empty if the set has none
  std::vector<std::uint32_t> objects;
  std::vector<std::uint32_t> categories; ///< empty if the set has none
  std::vector<std::string> room_names;   ///< of room 1, 2, ...
  /** Of category 0, 1, ...; the first is "none". */
  std::vector<std::string> category_names = {"none"};
};

/** \brief Make objects of some categories structure: number 0.
 * \throws ToolError if the scan knows no category of such a name
 */
void
clearObjects(LabelledScan& scan, const std::vector<std::string>& categories);

/** \brief Append the fields room, object and category, as far as there are some. */
void
appendTruth(LabelledScan& scan);

/** \brief JSON with the names: categories, and rooms where there are some. */
std::string
describeTruth(const LabelledScan& scan);

} // namespace pcl::indoor::tool
