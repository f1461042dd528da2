/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "thesis/objects/upstream_supervoxels.h" // for PointPartition

namespace pcl::indoor {

/** \brief Partition points as partitionWithUpstream() does, by all of Eq. (2.18): with
 * FPFH beside the colours, if there are any. PCL's supervoxels have no such term, so
 * that growSupervoxels() makes them. The FPFH of a voxel is that of its centroid, of
 * all points within 2 R_voxel. */
PointPartition
partitionByShapes(const SurfaceVoxels& surface,
                  const std::vector<std::uint8_t>& left_out,
                  const std::optional<Eigen::Vector3f>& camera,
                  const thesis::ObjectOptions& options);

} // namespace pcl::indoor
