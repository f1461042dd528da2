/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/space/occupancy_grid.h"

#include <pcl/indoor/voxel_bits.h>
#include <pcl/indoor/voxel_map.h>
#include <pcl/segmentation/building_rooms.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** \brief The storeys of a building, lowest first. */
struct Storeys {
  std::vector<Storey> heights; ///< at least one
  /** For each pair of storeys k and k + 1, per column of the grid: the height above
   * which objects belong to storey k + 1 (or higher); infinite where a hall is open
   * over both.
   */
  std::vector<PixelMap<float>> borders;

  /** \brief The storey of a point at height z (frame of the grid, metres) in a column.
   * REQUIRES: the column lies in the grid.
   */
  int
  storeyAt(int x, int y, double z) const;
};

/** \brief Split a building into storeys, from its occupied voxels.
 *
 * The thesis describes peaks of the histogram of all heights (Sec. 2.2.1). That fails
 * for halls over two storeys, a storey under a part of the house, levels that differ
 * between wings, and sloped roofs. Therefore slabs are looked for in place: groups of
 * occupied voxels in a column with free space above and below, which ends at something
 * occupied or, where a ceiling or a floor was not seen, has walls on three sides. A
 * group is part of a slab if most columns around it have their top or their underside
 * at the same height; stairs and furniture have not. The heights that most of these
 * groups share are the borders between storeys. A scan without slabs has one storey.
 * Linear in the number of voxels.
 *
 * \param[in] occupancy occupied voxels are set
 * \param[in] threads 0 = automatic; the result does not depend on it
 * \param[in] unseen result of unseenSlabs(): they divide storeys, too
 * \throws pcl::BadArgumentException if an option or the voxel size is out of range
 */
Storeys
findStoreys(const VoxelBits& occupancy,
            const StoreyOptions& options = {},
            int threads = 0,
            const std::vector<double>& unseen = {});

/** \brief Move the borders of storeys between the ceiling below and the floor above,
 * more finely than the grid: to the valley between the two peaks of the points' heights
 * (Sec. 2.2.1). A slab may be thinner than a voxel.
 *
 * \param[in] points the points that the grid was made of
 * \param[in] grid their occupancyGrid()
 * \param[in,out] storeys result of findStoreys() for the grid
 * \throws pcl::BadArgumentException if points and grid do not belong together
 */
void
refineBorders(const std::vector<Eigen::Vector3f>& points,
              const OccupancyGrid& grid,
              Storeys& storeys);

} // namespace pcl::indoor
