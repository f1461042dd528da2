/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/surface_voxels.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief When two segments that touch are one piece.
 * Air is the volume that the hull of both has beyond their two hulls, as a multiple of
 * the smaller of these; contact is the share of a segment's voxels that touch the
 * other, of the one that has more.
 */
struct ConvexUnionOptions {
  /** segments are joined if the air is at most this multiple of the contact (>= 0; 0
   * joins none); higher gives larger segments */
  double air_per_contact = 5;
  /** or if that of the boxes along the axes is at most this multiple (>= 0) */
  double box_air_per_contact = 2;
  double max_air = 2; ///< but never with more air between the hulls (>= 0)
  /** least length of the contact, as a multiple of the side of a square as large as the
   * segment: pieces that touch with a corner or a narrow end are not joined (>= 0) */
  double min_contact_length = 1;
  /** voxels of the smaller segment over those of the larger, at most (> 0; 1 for any):
   * less than 1 joins fragments, but no two whole things */
  double max_size_ratio = 1;
  double voxel_size = 0.03; ///< of the voxels, metres (> 0)
  /** three orthogonal directions, one per column, that boxes and hulls follow */
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
};

/** \brief Join touching segments whose hulls leave little air between them: the
 * compartments of a bookcase, a mattress in its bed. What stands on a table is not
 * joined to it, because the hull of both holds much air, however large the table is;
 * nor is what touches another thing only here and there. The pair with the least air
 * for its contact is joined first, ties in the order of segments; see DirectionHulls
 * for the hulls. The cost is linear in the number of voxels, and n log n in the number
 * of segments, at about 0.05 ms for each pair that touches.
 * \param[in] left_out one flag per voxel; segments of flagged voxels are not joined
 * \param[in,out] segment_of_voxel any numbers below the number of voxels + segments
 * \throws pcl::BadArgumentException if sizes differ or an option is out of range
 */
void
joinConvexUnions(const SurfaceVoxels& voxels,
                 const std::vector<std::uint8_t>& left_out,
                 const ConvexUnionOptions& options,
                 std::vector<std::uint32_t>& segment_of_voxel);

} // namespace indoor
} // namespace pcl
