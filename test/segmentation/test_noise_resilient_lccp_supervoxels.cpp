/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

// pcl::NoiseResilientLCCP in the place of pcl::LCCPSegmentation, on upstream's
// supervoxels.

#include "segmentation/objects/segmented_scene.h"

#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>

#include <gtest/gtest.h>

#include <iterator>
#include <limits>
#include <map>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

using Color = pcl::PointXYZRGBA;

/** Upstream's supervoxels of the floor and its boxes, with their adjacency. */
struct UpstreamSupervoxels {
  std::map<std::uint32_t, pcl::Supervoxel<Color>::Ptr> clusters;
  std::multimap<std::uint32_t, std::uint32_t> adjacency;
  pcl::PointCloud<pcl::PointXYZL>::Ptr labelled;

  UpstreamSupervoxels()
  {
    const auto scene = floorWithTwoBoxes();
    const pcl::PointCloud<Color>::Ptr cloud(new pcl::PointCloud<Color>);
    for (const auto& point : scene.points) {
      cloud->emplace_back();
      cloud->back().getVector3fMap() = point;
    }
    pcl::SupervoxelClustering<Color> clustering(0.03f, 0.12f);
    clustering.setUseSingleCameraTransform(false);
    clustering.setInputCloud(cloud);
    clustering.setNormalCloud(normalsOf(scene));
    clustering.setColorImportance(0);
    clustering.setSpatialImportance(0.4f);
    clustering.setNormalImportance(1);
    clustering.extract(clusters);
    clustering.getSupervoxelAdjacency(adjacency);
    labelled = clustering.getLabeledCloud();
  }
};

Labels
labelsOf(const pcl::PointCloud<pcl::PointXYZL>& cloud)
{
  Labels labels;
  for (const auto& point : cloud)
    labels.push_back(point.label);
  return labels;
}

} // namespace

TEST(NoiseResilientLCCPSupervoxels, JoinThoseOfUpstreamAsUpstreamDoes)
{
  const UpstreamSupervoxels given;
  ASSERT_GT(given.clusters.size(), 500u);
  pcl::LCCPSegmentation<Color> upstream;
  upstream.setInputSupervoxels(given.clusters, given.adjacency);
  upstream.setConcavityToleranceThreshold(10);
  upstream.setSanityCheck(false);
  upstream.setMinSegmentSize(3);
  upstream.segment();
  auto expected = *given.labelled;
  upstream.relabelCloud(expected);

  Segmentation segmentation;
  segmentation.setPartition(Partition::Lccp);
  segmentation.setInputSupervoxels(given.clusters, given.adjacency);
  segmentation.segment();
  auto relabelled = *given.labelled;
  segmentation.relabelCloud(relabelled);
  EXPECT_GT(agreement(labelsOf(expected), labelsOf(relabelled)), 0.98)
      << "but for small segments, which upstream adds in the order of their addresses";
  EXPECT_EQ(segmentation.getSupervoxelToSegmentMap().size(), given.clusters.size());
}

TEST(NoiseResilientLCCPSupervoxels, AreJoinedByAnyPartition)
{
  const UpstreamSupervoxels given;
  Segmentation segmentation;
  segmentation.setInputSupervoxels(given.clusters, given.adjacency);
  for (const auto partition :
       {Partition::Pieces, Partition::FelzenszwalbHuttenlocher, Partition::Lccp}) {
    segmentation.setPartition(partition);
    segmentation.segment();
    std::map<std::uint32_t, std::size_t> sizes;
    for (const auto& [name, segment] : segmentation.getSupervoxelToSegmentMap()) {
      EXPECT_GE(segment, 1u);
      ++sizes[segment];
    }
    EXPECT_LT(sizes.size(), given.clusters.size() / 4);
    EXPECT_GE(sizes.size(), 2u) << "the floor and a box at least";
  }
}

TEST(NoiseResilientLCCPSupervoxels, SomeHaveNoNormal)
{
  UpstreamSupervoxels given; // upstream's of one or two voxels
  const auto nan = std::numeric_limits<float>::quiet_NaN();
  const auto first = given.clusters.begin(), last = std::prev(given.clusters.end());
  for (const auto each : {first, last})
    each->second->normal_.getNormalVector3fMap().setConstant(nan);
  Segmentation segmentation;
  segmentation.setInputSupervoxels(given.clusters, given.adjacency);
  for (const auto partition :
       {Partition::Pieces, Partition::FelzenszwalbHuttenlocher, Partition::Lccp}) {
    segmentation.setPartition(partition);
    ASSERT_NO_THROW(segmentation.segment());
    EXPECT_EQ(segmentation.getSupervoxelToSegmentMap().size(), given.clusters.size());
  }
}

TEST(NoiseResilientLCCPSupervoxels, UnknownNamesAndWrongUse)
{
  Segmentation segmentation;
  segmentation.segment();
  EXPECT_TRUE(segmentation.getSupervoxelToSegmentMap().empty()) << "none were set";
  UpstreamSupervoxels given;
  given.adjacency.emplace(given.clusters.begin()->first, 4000000);
  segmentation.setInputSupervoxels(given.clusters, given.adjacency);
  segmentation.segment();
  EXPECT_EQ(segmentation.getSupervoxelToSegmentMap().size(), given.clusters.size());
  pcl::PointCloud<pcl::PointXYZL> unknown;
  unknown.emplace_back();
  unknown.back().label = 4000000;
  segmentation.relabelCloud(unknown);
  EXPECT_EQ(unknown.back().label, 0u);
  segmentation.setJoiningLevel(500);
  segmentation.segment();
  EXPECT_TRUE(segmentation.getSupervoxelToSegmentMap().empty());
}
