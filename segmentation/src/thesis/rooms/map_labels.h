/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <cstddef>
#include <cstdint>

namespace pcl::indoor {

/** \brief Where a peak of a field may lie that a clustering left out. */
enum class PeakPlaces {
  OffSlopes, ///< not where the field does not fall on the way to a labelled pixel
  Anywhere   ///< at every unlabelled pixel, as the thesis has it
};

/** \brief Gives labels to the peaks of a field that a clustering left out (Sec. 3.2.3).
 *
 * With PeakPlaces::OffSlopes, a pixel from which the field does not fall on the way to
 * a labelled one is no peak, and stays unlabelled. Of the others, each connected
 * component (8 neighbours) that reaches the threshold gets a label. Linear time.
 * \param[in] labels 0 or more, -1 = none
 * \param[in] field the map that was clustered
 * \param[in] threshold the smallest of the histogram's peaks; pixels below it stay
 * unlabelled
 * \param[in] min_pixels smaller components stay unlabelled
 * \return the labels, and new ones that continue their numbers, by first pixel
 * \throws pcl::BadArgumentException if the maps differ in size
 */
PixelMap<int>
labelPeaks(const PixelMap<int>& labels,
           const PixelMap<float>& field,
           float threshold,
           std::size_t min_pixels = 1,
           PeakPlaces places = PeakPlaces::OffSlopes);

/** \brief How many labelled free voxels vote for the label of an occupied one, as the
 * thesis has it. */
constexpr std::size_t label_voters = 10;

/** \brief How far from it they may be, voxels of 0.2 m: farther than walls are thick.
 * An occupied voxel with none in reach gets no label. */
constexpr int voter_reach = 15;

/** \brief Propagates the labels of a map to the voxels (Sec. 3.2.3, "Occupied voxels").
 *
 * A free voxel gets the label of its column. An occupied one gets the most frequent
 * label among its nearest labelled free voxels; all those as far as the last of them
 * vote too, so that no order of voxels matters. Equal votes go to the label with the
 * smaller sum of squared distances, then to the smaller label. Time linear in the
 * voxels where labelled voxels are near, at most O(voter_reach^3) for each occupied
 * voxel.
 * \param[in] occupancy non-zero = occupied
 * \param[in] interior non-zero = interior free space
 * \param[in] labels of the columns, -1 = none
 * \param[in] threads 0 = automatic; the result does not depend on it
 * \return -1 for voxels that are neither interior nor occupied, or out of reach
 * \throws pcl::BadArgumentException if the sizes differ
 */
VoxelMap<int>
labelVoxels(const VoxelMap<std::uint8_t>& occupancy,
            const VoxelMap<std::uint8_t>& interior,
            const PixelMap<int>& labels,
            int threads = 0);

} // namespace pcl::indoor
