/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Segmentations to compare with that know neither supervoxels nor convexity. */
enum class Baseline {
  SmoothGrowing,     ///< pcl::RegionGrowing at its example's defaults
  FeatureGrowing,    ///< pcl::ConditionalEuclideanClustering of places with like FPFH
  EuclideanClusters, ///< pcl::EuclideanClusterExtraction
  NormalGraph ///< Felzenszwalb and Huttenlocher on normals, as ScanNet's segmentator
};

struct BaselineOptions {
  Baseline baseline = Baseline::SmoothGrowing;
  double voxel_size = 0.03;   ///< all work on the means of voxels, metres
  bool single_camera = false; ///< normals are turned to the origin, else to the middle
  unsigned threads = 0;       ///< of normals and FPFH
};

/** \brief Segment a cloud.
 * \return one label per point, 0 for points that are not finite or in no segment
 */
std::vector<std::uint32_t>
segmentBaseline(const PointCloud<PointXYZ>& cloud, const BaselineOptions& options);

} // namespace pcl::indoor::tool
