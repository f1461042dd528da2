/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "comparison/upstream_lccp.h"

#include <pcl/common/common.h> // for getMinMax3D
#include <pcl/common/io.h>     // for copyPointCloud
#include <pcl/common/point_tests.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>

#include <map>

namespace {

using PointT = pcl::PointXYZRGBA; // upstream's supervoxels ask for color
using Cloud = pcl::PointCloud<PointT>;
using pcl::indoor::tool::UpstreamOptions;

pcl::PointCloud<pcl::Normal>::Ptr
estimateNormals(const Cloud::ConstPtr& cloud, const UpstreamOptions& options)
{
  pcl::NormalEstimationOMP<PointT, pcl::Normal> estimation(options.threads);
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(options.normal_radius);
  if (!options.single_camera) {
    PointT lower, upper;
    pcl::getMinMax3D(*cloud, lower, upper);
    estimation.setViewPoint(
        (lower.x + upper.x) / 2, (lower.y + upper.y) / 2, (lower.z + upper.z) / 2);
  }
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  estimation.compute(*normals);
  return normals;
}

} // namespace

namespace pcl::indoor::tool {

UpstreamOptions
exampleUpstreamOptions(bool single_camera, unsigned threads)
{
  UpstreamOptions options;
  options.threads = threads;
  if (single_camera) {
    options.voxel_resolution = 0.0075;
    options.seed_resolution = 0.03;
    options.k_factor = 1;
    options.normal_radius = 0;
    options.single_camera = true;
  }
  return options;
}

UpstreamOptions
tunedUpstreamOptions(bool single_camera,
                     unsigned threads,
                     double voxel_resolution,
                     double seed_resolution)
{
  auto options = exampleUpstreamOptions(single_camera, threads);
  options.voxel_resolution = voxel_resolution;
  options.seed_resolution = seed_resolution;
  options.k_factor = 0;
  options.use_sanity_check = options.use_smoothness_check = true;
  options.min_segment_size = 3;
  return options;
}

std::vector<std::uint32_t>
segmentUpstream(const PointCloud<PointXYZ>& input, const UpstreamOptions& options)
{
  const auto cloud = make_shared<Cloud>();
  Indices finite;
  for (std::size_t i = 0; i < input.size(); ++i)
    if (isFinite(input[i]))
      finite.push_back(static_cast<index_t>(i));
  copyPointCloud(input, finite, *cloud);

  SupervoxelClustering<PointT> supervoxels(static_cast<float>(options.voxel_resolution),
                                           static_cast<float>(options.seed_resolution));
  supervoxels.setUseSingleCameraTransform(options.single_camera);
  supervoxels.setInputCloud(cloud);
  if (options.normal_radius > 0)
    supervoxels.setNormalCloud(estimateNormals(cloud, options));
  // The example's importances.
  supervoxels.setColorImportance(0.0f);
  supervoxels.setSpatialImportance(1.0f);
  supervoxels.setNormalImportance(4.0f);
  std::map<std::uint32_t, Supervoxel<PointT>::Ptr> clusters;
  supervoxels.extract(clusters);
  std::multimap<std::uint32_t, std::uint32_t> adjacency;
  supervoxels.getSupervoxelAdjacency(adjacency);

  LCCPSegmentation<PointT> lccp;
  lccp.setConcavityToleranceThreshold(10);
  lccp.setSanityCheck(options.use_sanity_check);
  lccp.setSmoothnessCheck(options.use_smoothness_check,
                          static_cast<float>(options.voxel_resolution),
                          static_cast<float>(options.seed_resolution),
                          0.1f);
  lccp.setKFactor(options.k_factor);
  lccp.setInputSupervoxels(clusters, adjacency);
  lccp.setMinSegmentSize(options.min_segment_size);
  lccp.segment();
  const auto labelled = supervoxels.getLabeledCloud();
  lccp.relabelCloud(*labelled);
  std::vector<std::uint32_t> labels(input.size(), 0);
  for (std::size_t i = 0; i < finite.size(); ++i)
    labels[finite[i]] = (*labelled)[i].label;
  return labels;
}

} // namespace pcl::indoor::tool
