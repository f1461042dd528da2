/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/saved_scene.h"

namespace pcl::indoor::tool {

/** \brief Where an opening is on the plan. */
struct OpeningPlace {
  Eigen::Vector2d middle;
  Eigen::Vector2d along; ///< the wall, unit length
  double left = 0.0;     ///< from the middle to the room on the left of that, metres
  double right = 0.0;    ///< the same to the right; both at least half the wall
};

/** \brief Find it: its wall tells the direction, or else the longest side of its rooms
 * nearby. Rooms are looked for within a metre; where none is, the wall ends. */
OpeningPlace
openingPlace(const SavedScene& scene, const SavedOpening& opening);

} // namespace pcl::indoor::tool
