/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/object_scene.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief What pieces are described in: what is up, how high, and how large. */
struct PieceFrame {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< x, y and up, as rows
  double floor = 0;      ///< height of what objects stand on, metres
  double voxel_size = 0; ///< metres
};

/** \brief Get the frame of a room: x across its first wall, the floor where the lowest
 * voxels are. */
PieceFrame
roomFrame(const ObjectScene& scene);

/** \brief Get the frame of a camera's view: what objects stand on is the largest piece,
 * and up is its normal; voxels are as large as at the median distance.
 * \param[in] piece_of_voxel 0 ... piece_count - 1
 * \param[in] viewpoint of the camera, which looks along z
 */
PieceFrame
viewFrame(const ObjectScene& scene,
          const std::vector<std::uint32_t>& piece_of_voxel,
          std::uint32_t piece_count,
          const Eigen::Vector3f& viewpoint);

} // namespace pcl::indoor
