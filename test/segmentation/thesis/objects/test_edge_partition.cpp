/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/objects/edge_partition.h"

#include <pcl/point_types.h>
#include <pcl/segmentation/lccp_segmentation.h>

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace pcl::indoor;
using Labels = std::vector<std::uint32_t>;

TEST(EdgePartition, ConvexSegmentsAreThoseOfUpstreamLccp)
{
  std::mt19937 rng(9);
  for (int trial = 0; trial < 20; ++trial) {
    const auto random = [&] { return static_cast<float>(rng() % 2001) / 1000 - 1; };
    const std::uint32_t count = 30;
    std::map<std::uint32_t, pcl::Supervoxel<pcl::PointXYZ>::Ptr> clusters;
    Supervoxels patches;
    for (std::uint32_t i = 0; i < count; ++i) {
      const float x = random(), y = random(), z = random();
      patches.centroids.emplace_back(x, y, z);
      const float u = random(), v = random();
      patches.normals.push_back(Eigen::Vector3f(u, v, 1).normalized());
      auto supervoxel = pcl::make_shared<pcl::Supervoxel<pcl::PointXYZ>>();
      supervoxel->centroid_.getVector3fMap() = patches.centroids[i];
      supervoxel->normal_.getNormalVector3fMap() = patches.normals[i];
      clusters[i + 1] = supervoxel;
    }
    std::multimap<std::uint32_t, std::uint32_t> adjacency;
    std::vector<SurfaceEdge> edges;
    for (std::uint32_t a = 0; a < count; ++a)
      for (std::uint32_t b = a + 1; b < count; ++b)
        if (rng() % 10 == 0) {
          edges.push_back({a, b, 1});
          adjacency.emplace(a + 1, b + 1);
          adjacency.emplace(b + 1, a + 1);
        }
    pcl::LCCPSegmentation<pcl::PointXYZ> lccp;
    lccp.setConcavityToleranceThreshold(10);
    lccp.setSanityCheck(false);
    lccp.setSmoothnessCheck(false, 0.03f, 0.12f, 0.1f);
    lccp.setKFactor(0);
    // Upstream adds small segments in the order of their addresses in memory: compare
    // with its segments before that, and with what its filter promises.
    lccp.setMinSegmentSize(0);
    lccp.setInputSupervoxels(clusters, adjacency);
    lccp.segment();
    std::map<std::uint32_t, std::uint32_t> upstream;
    lccp.getSupervoxelToSegmentMap(upstream);
    std::map<std::uint32_t, std::uint32_t> upstream_sizes, sizes, large_part, part;
    const auto ours = convexSegments(count, edges, convexEdges(patches, edges, 10));
    for (std::uint32_t i = 0; i < count; ++i) {
      ++upstream_sizes[upstream.at(i + 1)];
      ++sizes[ours[i]];
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto convex = upstream.at(i + 1);
      EXPECT_EQ(part.emplace(convex, ours[i]).first->second, ours[i]) << "is parted";
      if (upstream_sizes[convex] > 3) {
        EXPECT_EQ(large_part.emplace(ours[i], convex).first->second, convex)
            << "two large segments are joined";
      }
    }
    for (const auto& edge : edges)
      if (ours[edge.source] != ours[edge.target]) {
        EXPECT_GT(sizes[ours[edge.source]], 3u) << "trial " << trial;
        EXPECT_GT(sizes[ours[edge.target]], 3u) << "trial " << trial;
      }
  }
}

TEST(EdgePartition, SmallSegmentsGoToTheirLargestNeighbor)
{
  // A chain 0-1-2-3 | 4-5-6 | 7-8-9-10-11, bars stand for concave edges.
  std::vector<SurfaceEdge> edges;
  std::vector<std::uint8_t> is_convex;
  for (std::uint32_t i = 0; i < 11; ++i) {
    edges.push_back({i, i + 1, 1});
    is_convex.push_back(i != 3 && i != 6);
  }
  EXPECT_EQ(convexSegments(12, edges, is_convex),
            (Labels{0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1}));
  // With a patch more in the middle it is large enough.
  edges.push_back({4, 12, 1});
  is_convex.push_back(1);
  EXPECT_EQ(convexSegments(13, edges, is_convex),
            (Labels{0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2, 2, 1}));
}

TEST(EdgePartition, WeightsAreThoseOfTheEquations)
{
  Supervoxels patches;
  patches.centroids = {{0, 0, 0}, {0.06f, 0, 0}};
  patches.normals = {{0, 0, 1}, {0, 0.6f, 0.8f}};
  const float d = 0.5f * 0.2f + 0.2f * 0.5f; // Eq. (4.4)
  const auto concave = weighEdges(patches, {{0, 1, 1}}, {0}, {}, 0.25f);
  const auto convex = weighEdges(patches, {{0, 1, 1}}, {1}, {}, 0.25f);
  EXPECT_NEAR(concave[0].weight, d, 1e-6);
  EXPECT_NEAR(convex[0].weight, 0.25f * d * d, 1e-6); // Eq. (4.3)
}
