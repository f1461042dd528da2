/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/e57/e57_pages.h"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief One of the values that each point of a scan has, and how it is stored. */
struct E57Field {
  enum class Kind { Integer, Scaled, Single, Double, Other };

  std::string name; ///< as the file has it, for example cartesianX
  Kind kind = Kind::Integer;
  unsigned bits = 0;                     ///< of a stored value; 0 if all are the same
  std::int64_t minimum = 0, maximum = 0; ///< of whole numbers, before scaling
  double scale = 1.0, offset = 0.0;      ///< of whole numbers
};

/** \brief What an E57 file tells of one of its scans. */
struct E57Scan {
  struct Limits {
    double least = 0.0, largest = 0.0;
  };

  std::string name;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity(); ///< of its points
  std::uint64_t section = 0; ///< physical place of its points
  std::uint64_t count = 0;   ///< of points
  std::vector<E57Field> fields;
  std::array<std::optional<Limits>, 3> colors; ///< red, green, blue
};

/** \brief Read what an E57 file tells of its scans.
 * \throws ToolError if its header or description is damaged, or contradicts itself
 */
std::vector<E57Scan>
readE57Scans(E57Pages& pages);

} // namespace pcl::indoor::tool
