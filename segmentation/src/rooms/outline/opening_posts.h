/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/map/region_borders.h"
#include "rooms/map/room_map.h"
#include "rooms/space/occupancy_grid.h"

#include <Eigen/Core>

#include <array>
#include <utility>
#include <vector>

namespace pcl::indoor {

/** \brief Measures how wide openings are by the points of their posts. By voxels alone,
 * each post would take up to one voxel of a door's width.
 *
 * A post is the first face across the opening within the thickness of the wall; so an
 * open leaf, which stands beside the wall, does not count. Where the wall's faces are,
 * the points of the lintel tell.
 */
class OpeningPosts {
public:
  /** \param[in] openings,occupancy,map of one storey; must outlive this */
  OpeningPosts(const std::vector<RegionOpening>& openings,
               const OccupancyGrid& occupancy,
               const RoomMap& map);

  /** \brief Look at a point of the building. */
  void
  add(const Eigen::Vector3f& point, std::int32_t cell);

  /** \brief Take over what another one of the same openings has seen. */
  void
  add(const OpeningPosts& other);

  /** \brief Get the ends of an opening, metres from its middle along it and against
   * it; where no post is seen, that of the voxels. */
  std::pair<double, double>
  ends(std::size_t opening) const;

private:
  /** What was seen of one opening, metres from its middle: (along, beside). */
  struct Seen {
    std::vector<double> lintel;                        ///< beside
    std::array<std::vector<Eigen::Vector2d>, 2> posts; ///< against it, along it
  };

  /** Where the wall is, beside the middle of an opening. */
  std::pair<double, double>
  wall(const Seen& seen) const;

  const std::vector<RegionOpening>& openings_;
  const OccupancyGrid& occupancy_;
  const RoomMap& map_;
  Eigen::Matrix2d turn_;
  double floor_;                                          ///< metres
  std::vector<std::uint8_t> is_near_;                     ///< per pixel
  std::vector<std::pair<std::size_t, std::size_t>> near_; ///< pixels and openings
  std::vector<Seen> seen_;
};

} // namespace pcl::indoor
