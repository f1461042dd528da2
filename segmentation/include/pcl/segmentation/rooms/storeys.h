/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_bits.h>
#include <pcl/indoor/voxel_map.h>
#include <pcl/segmentation/rooms/occupancy_grid.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

struct StoreyOptions {
  double min_clearance =
      1.5;               ///< least free height above and below a slab, metres (> 0)
  double max_slab = 1.1; ///< greatest height of a slab with what stands on it and
                         ///< hangs under it, metres (>= 0)
  double min_slab_area = 10.0; ///< least area of a slab, m^2 (> 0); larger ignores
                               ///< galleries
  double bridge = 1.5; ///< openings in a slab that are at most twice this wide, as of
                       ///< stairs, are cut at the slab's height, metres (>= 0)
  double min_opening_area = 12.0; ///< a larger opening is a hall, m^2 (>= 0); it
                                  ///< belongs to the storey of its floor
  int threads = 0;                ///< 0 = automatic; the result does not depend on it
};

/** \brief A storey's typical heights in the frame of the grid, metres. */
struct Storey {
  double floor = 0.0;
  double ceiling = 0.0;
};

/** \brief The storeys of a building, lowest first. */
struct Storeys {
  std::vector<Storey> heights; ///< at least one
  /** For each pair of storeys k and k + 1, per column of the grid: the height above
   * which things belong to storey k + 1 (or higher); infinite where a hall is open over
   * both.
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
 * occupied. A group is part of a slab if most columns around it have their top or their
 * underside at the same height; stairs and furniture have not. The heights that most of
 * these groups share are the borders between storeys. A scan without slabs has one
 * storey. Linear in the number of voxels.
 *
 * \param[in] occupancy occupied voxels are set
 * \throws pcl::BadArgumentException if an option is out of range or the number of
 * values does not fit the shape
 */
Storeys
findStoreys(const VoxelBits& occupancy, const StoreyOptions& options = {});

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

} // namespace indoor
} // namespace pcl
