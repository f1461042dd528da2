/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/voxel_map.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Which landmarks are visible from each voxel: a row of bits per voxel. */
struct VisibilityVectors {
  std::size_t count = 0;              ///< of voxels
  std::size_t landmarks = 0;          ///< bits per voxel
  std::size_t words = 0;              ///< 64-bit words per voxel
  std::vector<std::uint64_t> bits;    ///< s_l(i) of Eq. (3.5) is bit l of the i-th
                                      ///< row; unused bits are 0
  std::vector<std::uint32_t> visible; ///< of each voxel: the number of its bits set
};

/** \brief The visibility vectors s(p) of Eq. (3.5).
 * Time O(voxels * landmarks * length of a line up to what blocks it), memory a bit per
 * voxel and landmark. With the voxels themselves as landmarks these are the vectors of
 * the thesis; a few hundred landmarks estimate the same distances.
 * \param[in] occupancy non-zero = occupied
 * \param[in] voxels those that look, usually the highest free ones
 * \param[in] landmarks those that are looked for; a voxel sees itself
 * \param[in] threads 0 = automatic; the result does not depend on it
 * \throws pcl::BadArgumentException if a voxel or landmark lies outside of the grid
 */
VisibilityVectors
visibilityVectors(const VoxelMap<std::uint8_t>& occupancy,
                  const std::vector<Eigen::Vector3i>& voxels,
                  const std::vector<Eigen::Vector3i>& landmarks,
                  int threads = 0);

/** \brief D^vis of Eq. (3.5): the positions that differ over the sum of both vectors.
 * The thesis prints a Hamming distance that counts equal positions; those that differ
 * are meant.
 * \return 0 (the same view) to 1 (nothing in common); 0 if neither sees anything
 */
double
visibilityDistance(const VisibilityVectors& vectors, std::size_t i, std::size_t j);

/** \brief What all or some voxels of a group see: it gives a lower bound of the
 * distance to any of them. */
struct VisibilityGroup {
  std::vector<std::uint64_t> all; ///< landmarks that every one of them sees
  std::vector<std::uint64_t> any; ///< landmarks that at least one of them sees
  std::uint32_t most_visible = 0; ///< the largest number that one of them sees

  /** \brief Add the i-th voxel of the vectors. */
  void
  add(const VisibilityVectors& vectors, std::size_t i);
};

/** \brief A distance that visibilityDistance() of i and a voxel of the group reaches at
 * least.
 */
double
leastVisibilityDistance(const VisibilityVectors& vectors,
                        std::size_t i,
                        const VisibilityGroup& group);

/** \brief Landmarks for visibilityVectors(): at most one per square of the map.
 * \param[in] heights the z index in each column, -1 = none, as highestFreeVoxel()
 * gives it
 * \param[in] spacing edge of a square in pixels (at least 1)
 * \return per square the voxel whose column is nearest to its middle
 * \throws pcl::BadArgumentException if spacing is not positive
 */
std::vector<Eigen::Vector3i>
spreadLandmarks(const PixelMap<int>& heights, int spacing);

} // namespace pcl::indoor
