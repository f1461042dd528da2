/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/space/occupancy_grid.h"

#include <pcl/indoor/voxel_bits.h>
#include <pcl/segmentation/building_rooms_options.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief Floors and ceilings that a scan does not show, as those of a slice or of a
 * camera that was never tilted. */
struct UnseenSides {
  double floor_seen = 1.0;   ///< share of the space between walls with a floor below
  double ceiling_seen = 1.0; ///< share of it with a ceiling above
  std::vector<std::size_t> floor, ceiling; ///< where they are to be put: voxels of the
                                           ///< space, at the ends of the walls

  bool
  floorIsSeen() const
  {
    return floor_seen >= least_seen;
  }

  bool
  ceilingIsSeen() const
  {
    return ceiling_seen >= least_seen;
  }

  /** \brief Whether what lacks a ceiling is a courtyard or a shaft, not a room into
   * which a lidar looked from too low. */
  bool
  ceilingIsMostlySeen() const
  {
    return ceiling_seen >= mostly;
  }

  bool
  floorIsMostlySeen() const
  {
    return floor_seen >= mostly;
  }

  static constexpr double least_seen = 0.3; ///< furniture hides the rest
  static constexpr double mostly = 0.7; ///< whole scans: .84 and more; half of maps:
                                        ///< .4 to .6 of the ceiling
};

/** \brief The interior free space of a building, on coarser voxels than the map's. */
struct InteriorSpace {
  int factor = 1;                          ///< map pixels per voxel, along each axis
  std::vector<Eigen::Vector2d> directions; ///< of the walls, in the frame of the grid
  VoxelBits occupancy;                     ///< cleaned up; set = occupied
  VoxelBits inside;                        ///< set = interior free space
  UnseenSides unseen;                      ///< which floors and ceilings are missing
};

/** \brief Find the directions of a building's walls (Sec. 3.2.1.2), the best supported
 * one first.
 * \param[in] points the points that the grid was made of
 * \param[in] building their occupancy grid
 * \return horizontal unit vectors in the frame of the points, at right angles or not
 */
std::vector<Eigen::Vector3d>
wallDirections(const std::vector<Eigen::Vector3f>& points,
               const OccupancyGrid& building,
               const InteriorSpaceOptions& options = {},
               int threads = 0);

/** \brief Find the dominant directions of a building in space, the best supported one
 * first: normals of its planes that are nearer to the horizontal than to the vertical,
 * dom1 and dom2 of Eq. (3.1). They need not be level, nor at right angles.
 * \return at least two unit vectors in the frame of the points, at most
 * options.max_directions; level ones at right angles stand in for those that are
 * missing
 */
std::vector<Eigen::Vector3d>
dominantDirections(const std::vector<Eigen::Vector3f>& points,
                   const OccupancyGrid& building,
                   const InteriorSpaceOptions& options = {},
                   int threads = 0);

/** \brief Find the interior free space (Sec. 3.2.1): isolated voxels removed, evidence
 * of enclosure (Eq. 3.1), minimum cut (Eq. 3.2).
 * \param[in] building occupancy grid
 * \param[in] directions of the walls, in the frame of the points; they need not be
 * level
 */
InteriorSpace
interiorSpace(const OccupancyGrid& building,
              const std::vector<Eigen::Vector3d>& directions,
              const InteriorSpaceOptions& options = {},
              int threads = 0);

} // namespace pcl::indoor
