/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/surface_voxels.h"

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Weights of Eq. (4.4), shared by supervoxels, graph and recovery, and of the
 * terms that Eq. (2.19) and (2.18) have beside it. */
struct SurfaceDistance {
  double seed_size = 0.12;     ///< R_seed, metres (> 0)
  float spatial_weight = 0.2f; ///< w_s (>= 0)
  float normal_weight = 0.5f;  ///< w_n (>= 0)
  float color_weight = 0;      ///< w_c (>= 0)
  float shape_weight = 0;      ///< of FPFH (>= 0)

  /** \brief Dissimilarity of two places on a surface, Eq. (4.4).
   * A normal of zero length counts as orthogonal to all others.
   */
  float
  operator()(const Eigen::Vector3f& position_1,
             const Eigen::Vector3f& normal_1,
             const Eigen::Vector3f& position_2,
             const Eigen::Vector3f& normal_2) const
  {
    const auto scale = spatial_weight / static_cast<float>(seed_size);
    return (position_1 - position_2).norm() * scale +
           (1 - std::abs(normal_1.dot(normal_2))) * normal_weight;
  }

  /** \brief What appearance adds: w_c D_c, where D_c is the difference of colours (CIE
   * 1976) over 100, that of black and white; and the weight of FPFH times the share of
   * the two histograms that is not common to them.
   * \param[in] one, other the appearances of two places
   * \param[in] i, j their columns; what one of them has no columns of adds 0
   */
  float
  ofAppearance(const SurfaceAppearance& one,
               std::size_t i,
               const SurfaceAppearance& other,
               std::size_t j) const;
};

/** \brief Patches of voxels. */
struct Supervoxels {
  static constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t>
      label_of_voxel;                     ///< 0 ... n - 1, or none for voxels left out
  std::vector<Eigen::Vector3f> centroids; ///< mean of the points, one per supervoxel
  std::vector<Eigen::Vector3f> normals;   ///< mean of the voxels', unit length or zero
  SurfaceAppearance appearance;           ///< means, as far as the voxels have any

  /** \brief Get the number of supervoxels. */
  std::size_t
  size() const
  {
    return centroids.size();
  }
};

/** \brief Partition voxels into connected patches of about the seed size: voxel cloud
 * connectivity segmentation (Papon et al., CVPR 2013; Sec. 2.1.6.6). One seed per cell
 * of a grid of seed size; patches grow from voxel to neighbouring voxel, each voxel
 * taking the nearest of the patches around it by SurfaceDistance with its appearance,
 * in rounds in which all voxels decide at once. Unlike pcl::SupervoxelClustering every
 * voxel gets a supervoxel (voxels out of reach form their own), supervoxels are
 * connected, and the result depends neither on the order of the points nor on the
 * number of threads.
 * \param[in] voxels with centroids, neighbours and normals
 * \param[in] left_out one flag per voxel, not 0 for voxels that take no part
 * \param[in] grid_scale seeds are this many voxels apart, in the grid's unit (>= 1)
 */
Supervoxels
growSupervoxels(const SurfaceVoxels& voxels,
                const std::vector<std::uint8_t>& left_out,
                double grid_scale,
                const SurfaceDistance& distance,
                unsigned threads);

} // namespace pcl::indoor
