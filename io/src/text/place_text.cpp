/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "text/place_text.h"

#include "files/tool_error.h"

#include <charconv>
#include <cmath>

namespace pcl::indoor {
namespace tool {

Eigen::Vector3d
readPlace(const std::string& option, const std::string& text)
{
  Eigen::Vector3d place;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int axis = 0; axis < 3; ++axis) {
    const auto read = std::from_chars(at, end, place[axis]);
    const bool is_last = axis == 2;
    if (read.ec != std::errc() || !std::isfinite(place[axis]) ||
        (is_last ? read.ptr != end : read.ptr == end || *read.ptr != ','))
      throw ToolError(option + ": '" + text + "' is not X,Y,Z, such as 1.5,-2,0");
    at = read.ptr + 1;
  }
  return place;
}

} // namespace tool
} // namespace pcl::indoor
