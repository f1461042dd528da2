/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

namespace pcl::indoor {

/** \brief The first classes of a voxel are of the building: floor, wall, ceiling. */
constexpr std::size_t building_classes = 3;

/** \brief What each voxel of a room was taken for. */
struct VoxelClasses {
  std::vector<std::uint32_t> voxel_of_point;
  std::size_t class_count = 0;
  /** class_count per voxel, their sum is 1; of what is larger than 40 m per point */
  std::vector<float> probabilities;
  /** one per voxel: from its points to the middle of the object that they are part of,
   * metres; means nothing where there is none */
  std::vector<Eigen::Vector3f> to_middle;

  /** \brief The probabilities of a point's voxel. */
  const float*
  of(std::size_t point) const
  {
    return probabilities.data() + voxel_of_point[point] * class_count;
  }

  /** \brief How likely a point is part of the building, 0 ... 1. */
  double
  buildingShare(std::size_t point) const
  {
    return std::accumulate(of(point), of(point) + building_classes, 0.0);
  }
};

/** \brief Tells what the points of a room are part of: finite, metres, z up. */
using ClassifyVoxels =
    std::function<VoxelClasses(const std::vector<Eigen::Vector3f>& points)>;

} // namespace pcl::indoor
