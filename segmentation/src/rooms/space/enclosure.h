/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/space/grid_cut.h"

#include <pcl/indoor/voxel_map.h>
#include <pcl/segmentation/building_rooms_options.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

constexpr double gain_unit = 0.01; ///< of the energy, Eq. (3.2)

/** \brief The most directions for which there are bits. */
constexpr std::size_t most_enclosure_directions = 5;

/** \brief Bits of enclosure(): occupied voxels exist ... */
enum EnclosureBit : std::uint8_t {
  ENCLOSED_BELOW = 1,          ///< ... below the voxel: z- of Eq. (3.1)
  ENCLOSED_ABOVE = 2,          ///< ... above the voxel: z+
  ENCLOSED_ALONG_DIRECTION = 4 ///< ... on both sides along direction 0; the bit is
                               ///< shifted left by i for direction i
};

/** \brief Find out in which ways every free voxel is enclosed by occupied ones
 * (Sec. 3.2.1.2).
 *
 * The grid is swept once to and fro per direction, along discretised lines that advance
 * by one voxel along the direction's largest component and round the others: every
 * voxel lies on exactly one line per direction. Linear in voxels and directions.
 *
 * \param[in] occupancy occupied voxels are not 0
 * \param[in] directions in the frame of the grid, of any length but 0, at most 5; they
 * need not be level, and which of the two senses does not matter
 * \param[in] threads number of threads (>= 0; 0 = automatic)
 * \return EnclosureBit flags of every free voxel; 0 for occupied ones
 * \throws pcl::BadArgumentException if there are too many directions, one is not finite
 * or 0, threads is negative, or the number of values does not fit the shape
 */
VoxelMap<std::uint8_t>
enclosure(const VoxelMap<std::uint8_t>& occupancy,
          const std::vector<Eigen::Vector3d>& directions,
          int threads = 0);

/** \brief The evidence for a voxel to be interior, Eq. (3.1).
 * \param[in] bits EnclosureBit flags
 * \param[in] direction_count number of horizontal directions (>= 0)
 * \param[in] weights w1 ... w5; with two directions each has the half of
 * weights.horizontal, as in the thesis
 */
double
enclosureEvidence(std::uint8_t bits,
                  int direction_count,
                  const EnclosureWeights& weights = {});

/** \brief How much cheaper it is to call each voxel interior than exterior: the unary
 * term of Eq. (3.2) as an integer for cutGrid(), in a byte per voxel.
 *
 * The gain is evidence - weights.exterior, in multiples of gain_unit. Eq. (3.1)
 * speaks for the interior only; the constant for the exterior lets voxels with weak
 * evidence go outside.
 *
 * \param[in] occupancy occupied voxels are not 0; their gain is GRID_CUT_EXCLUDED
 * \param[in] bits result of enclosure(), whose memory becomes that of the codes
 * \param[in] direction_count number of directions that were given to enclosure()
 * \param[in] weights see EnclosureWeights
 * \throws pcl::BadArgumentException if the sizes differ or a gain leaves the range of
 * the result
 */
CodedGains
interiorGain(const VoxelMap<std::uint8_t>& occupancy,
             VoxelMap<std::uint8_t> bits,
             int direction_count,
             const EnclosureWeights& weights = {});

} // namespace pcl::indoor
