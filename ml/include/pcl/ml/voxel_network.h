/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/indoor/voxel_classes.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief Rows of weights and what is added, for each output. */
struct VoxelLayer {
  std::size_t inputs = 0;
  std::size_t outputs = 0;
  std::vector<float> weights; ///< of each tap inputs x outputs, row by row
  std::vector<float> bias;    ///< one per output
};

/** \brief A sparse voxel U-net: what each voxel of a room is part of, by the shapes
 * around it.
 *
 * Submanifold sparse convolutions (Graham et al., CVPR 2018) on five levels of voxels,
 * from 5 to 80 cm. No part of the thesis. docs/method/voxel_network.md
 */
struct VoxelNetwork {
  std::vector<std::string> classes; ///< floor, wall, ceiling, then those of objects
  std::vector<std::size_t> widths;  ///< values of a voxel, by level
  double voxel_size = 0.0;          ///< of the first level, metres
  VoxelLayer stem;                  ///< of the neighbours, from the inputs
  std::vector<VoxelLayer> first, second; ///< of the neighbours, by level
  std::vector<VoxelLayer> down, up;      ///< of the eight children, by level but one
  std::vector<VoxelLayer> joined;        ///< of the neighbours, after going up
  VoxelLayer last; ///< one output per class, then three: to the middle of the object
};

/** \brief The network of a file.
 * \throws pcl::IOException that says in one line what is wrong with it: not a network,
 * damaged, cut off, or not there
 */
PCL_INDOOR_EXPORTS VoxelNetwork
loadVoxelNetwork(const std::string& path);

/** \brief What the points of a room are part of.
 *
 * Time is linear in the voxels: about 0.2 million multiplications for each. Memory is
 * 1 kB for each, at most for those of cubes of 24 m, which larger clouds are gone
 * through in.
 * The result does not depend on the order of the points but for rounding.
 * \param[in] points finite, metres, z up; of a room, or of a few
 */
PCL_INDOOR_EXPORTS VoxelClasses
classifyVoxels(const std::vector<Eigen::Vector3f>& points, const VoxelNetwork& network);

} // namespace pcl::indoor
