/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/surface_graph.h"

#include <pcl/segmentation/thesis.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::indoor {

/** \brief Supervoxels of points and what is made of them. */
struct PointPartition {
  Supervoxels supervoxels; ///< a label for each point of the surface
  std::vector<SurfaceEdge> edges;
  /** of each supervoxel, by the partition of the options; Supervoxels::none if
   * pcl::LCCPSegmentation gave it none */
  std::vector<std::uint32_t> segment_of_supervoxel;
};

/** \brief Partition points as Sec. 4.2.2 does, with PCL's own supervoxels: R_voxel,
 * R_seed and the weights of the options. Where points have colours, PCL's class has L,
 * a and b as whole numbers in the place of red, green and blue: it measures CIELab.
 * \param[in] surface points with oriented normals
 * \param[in] left_out one flag per point: not 0 for those that take no part
 * \param[in] camera the place from which voxels grow with the distance along z; none
 * if they do not
 */
PointPartition
partitionWithUpstream(const SurfaceVoxels& surface,
                      const std::vector<std::uint8_t>& left_out,
                      const std::optional<Eigen::Vector3f>& camera,
                      const thesis::ObjectOptions& options);

} // namespace pcl::indoor
