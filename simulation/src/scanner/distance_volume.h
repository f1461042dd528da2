/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "scanner/depth_sensor.h"

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace pcl::indoor {

/** \brief A vertex of the surface in a DistanceVolume. */
struct LabelledVertex {
  Eigen::Vector3f at; ///< metres
  std::uint32_t label;
};

/** \brief Views of a depth camera, fused to the distance from the nearest surface.
 *
 * Voxels near surfaces are kept in blocks of 8 x 8 x 8. Each holds the mean of the
 * signed distances along the camera's axis that the views give, cut off at four voxels,
 * and the label that most of the weight near the surface is of (majority vote of Boyer
 * and Moore). A view weighs as much as one over the squared depth, as its error grows
 * with that. (Curless and Levoy, SIGGRAPH 1996; blocks: Niessner et al., SIGGRAPH Asia
 * 2013.)
 */
class DistanceVolume {
public:
  /** \param[in] voxel_size edge of a voxel, metres (> 0)
   * \param[in] threads 0 = automatic; does not change the result */
  DistanceVolume(double voxel_size, int threads);

  /** \brief Add a view.
   * \param[in] pixels with the numbers of labels in place of triangles
   * \throws BadArgumentException if more than 2 GB of voxels would be needed */
  void
  integrate(const std::vector<DepthPixel>& pixels,
            const CameraFrame& frame,
            const DepthCameraOptions& camera);

  /** \brief The vertices that marching cubes would have: where the distance along an
   * edge of the grid passes zero, if one of the four cells at the edge has been seen at
   * all its corners.
   * \param[in] least_weight of a voxel that counts as seen, 1/m^2
   * \return in the order of the blocks; those without a label are left out */
  std::vector<LabelledVertex>
  vertices(float least_weight) const;

private:
  static constexpr int side = 8; // voxels

  struct Voxel {
    float distance = 0.0f; // metres, above 0 before the surface
    float weight = 0.0f;   // 1/m^2
    std::int32_t label = -1;
    float votes = 0.0f;
  };

  struct Block {
    Eigen::Vector3i place; // in blocks
    std::array<Voxel, side * side * side> voxels;
  };

  class Projection;

  void
  addBlocksAlong(const std::vector<DepthPixel>& pixels, const Projection& projection);
  void
  addBlock(const Eigen::Vector3i& place);
  void
  update(Block& block,
         const std::vector<DepthPixel>& pixels,
         const Projection& projection) const;
  const Voxel*
  voxelAt(const Eigen::Vector3i& place) const;
  bool
  isSeen(const Eigen::Vector3i& cell, float least_weight) const;
  bool
  isOnCell(const Eigen::Vector3i& place, int axis, float least_weight) const;

  double voxel_size_, truncation_;
  int threads_;
  std::vector<std::unique_ptr<Block>> blocks_;
  std::unordered_map<std::uint64_t, std::uint32_t> number_of_block_;
};

} // namespace pcl::indoor
