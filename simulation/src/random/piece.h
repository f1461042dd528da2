/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <string>

#include <cstdint>

namespace pcl::indoor {

/** \brief A piece of furniture that has no place yet. */
struct Piece {
  std::string category;
  std::uint32_t seed = 0;
  Eigen::Vector3d size = Eigen::Vector3d::Zero(); ///< metres
  int variant = 0;
};

/** \brief How an object lies on or in a piece. */
struct Resting {
  double turn = 0.0;    ///< radians, from the piece's
  bool inside = false;  ///< on any board of it; otherwise on its highest level place
  bool at_rear = false; ///< as far back as the piece reaches
  double give = 0.015;  ///< how uneven what carries it may be, metres
  int touching = -1;    ///< beside this object, if there is room
};

} // namespace pcl::indoor
