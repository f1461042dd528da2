/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Parameters of upstream PCL's chain of normals, supervoxels and LCCP. */
struct UpstreamOptions {
  double voxel_resolution = 0.03; ///< metres
  double seed_resolution = 0.12;  ///< metres
  double normal_radius = 0.05;    ///< metres; 0 leaves normals to the supervoxels
  unsigned k_factor = 0;          ///< of extended convexity
  unsigned min_segment_size = 0;  ///< supervoxels
  bool use_sanity_check = false;
  bool use_smoothness_check = false;
  bool single_camera = false;
  unsigned threads = 0; ///< for the normals; the rest has one
};

/** \brief The defaults of upstream's example; its own for one camera. */
UpstreamOptions
exampleUpstreamOptions(bool single_camera, unsigned threads);

/** \brief Upstream tuned: all of its checks, and voxels and seeds as ours.
 * \param[in] voxel_resolution, seed_resolution metres */
UpstreamOptions
tunedUpstreamOptions(bool single_camera,
                     unsigned threads,
                     double voxel_resolution,
                     double seed_resolution);

/** \brief Segment a cloud with pcl::LCCPSegmentation on pcl::SupervoxelClustering.
 * Normals are turned to the sensor of a single camera, otherwise to the middle of the
 * cloud.
 * \return one label per point, 0 for points that upstream leaves without
 */
std::vector<std::uint32_t>
segmentUpstream(const PointCloud<PointXYZ>& cloud, const UpstreamOptions& options);

} // namespace pcl::indoor::tool
