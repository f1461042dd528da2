/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Where the scanner stood, and from where it measured which point. */
struct ScanStations {
  /** All of them, in the frame and unit of the points: what is seen from others would
   * seem to be seen from nowhere. If one is not finite, none tells anything. */
  std::vector<Eigen::Vector3d> positions;
  /** The station of each point, from 1; 0 = not known. Empty: of no point is it known.
   */
  std::vector<std::uint32_t> of_point;

  bool
  empty() const
  {
    return positions.empty();
  }
};

/** \brief A station within a building. */
struct PlacedStation {
  Eigen::Vector3d position; ///< in the building's frame, metres
  int storey = -1;          ///< -1 = beyond the building's extent
  std::uint32_t room = 0;   ///< in which it stands; 0 = in none
};

} // namespace indoor
} // namespace pcl
