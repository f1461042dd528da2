/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/register_point_struct.h>
#include <pcl/type_traits.h> // for the names of field types

#include <cstdint>

namespace pcl::indoor {

/** \brief A point of a simulated scan: coordinates in metres and what was hit. */
struct PointXYZScene {
  float x = 0.0f, y = 0.0f, z = 0.0f;
  std::uint32_t room = 0;     ///< number of the room that it was seen in, 0 = none
  std::uint32_t object = 0;   ///< number of the object, 0 = wall, floor or ceiling
  std::uint32_t part = 0;     ///< number of the object's part, 0 = none
  std::uint32_t category = 0; ///< number of the category, 0 = none
};

} // namespace pcl::indoor

// clang-format off
POINT_CLOUD_REGISTER_POINT_STRUCT(pcl::indoor::PointXYZScene,
  (float, x, x)(float, y, y)(float, z, z)
  (std::uint32_t, room, room)(std::uint32_t, object, object)
  (std::uint32_t, part, part)(std::uint32_t, category, category))
// clang-format on
