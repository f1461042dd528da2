/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/types.h> // for Indices

#include <cstddef>
#include <string>

namespace pcl::indoor {

/** \brief Say which index has no point in a cloud of some size: "" if all have. */
inline std::string
findIndexProblem(const Indices& indices, std::size_t size)
{
  for (const auto index : indices)
    if (index < 0 || static_cast<std::size_t>(index) >= size)
      return "Index " + std::to_string(index) + " is outside of the cloud of " +
             std::to_string(size) + " points.";
  return {};
}

} // namespace pcl::indoor
