/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Views of a depth camera, with simulated tables that no criterion was learned from.
#include <pcl/segmentation/noise_resilient_lccp.h>
#include <pcl/segmentation/segmentation_metrics.h>
#include <pcl/simulation/depth_camera.h>
#include <pcl/simulation/random_plan.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor;

namespace {

using Labels = std::vector<std::uint32_t>;

struct View {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud{
      new pcl::PointCloud<pcl::PointXYZ>(640, 480)};
  Labels objects; ///< 0 = wall or floor, or no depth
};

View
viewOfTable(std::uint32_t seed)
{
  const auto building = buildBuilding(randomPlan(seed, PlanKind::Table));
  DepthCameraOptions camera;
  camera.seed = seed;
  const auto seen = viewBuilding(building, {0.6, 0.5, 1.5}, {0, 0, 0.7}, camera);
  View view;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    (*view.cloud)[i] = pcl::PointXYZ(seen[i].x, seen[i].y, seen[i].z);
    view.objects.push_back(seen[i].object);
  }
  return view;
}

} // namespace

TEST(NoiseResilientLCCPView, JoinsWhatTheCameraSeesInPieces)
{
  double quality = 0, quality_of_pieces = 0;
  for (std::uint32_t seed = 90001; seed <= 90004; ++seed) {
    const auto view = viewOfTable(seed);
    pcl::NoiseResilientLCCP<pcl::PointXYZ> segmentation;
    segmentation.setInputCloud(view.cloud);
    Labels labels;
    segmentation.segment(labels);
    ASSERT_EQ(labels.size(), view.objects.size());
    quality += scoreThings(view.objects, labels).panopticQuality();

    auto options = singleViewOptions();
    options.pieces.joining_level = 1;
    segmentation.setOptions(options);
    segmentation.segment(labels);
    quality_of_pieces += scoreThings(view.objects, labels).panopticQuality();
  }
  EXPECT_GT(quality, 4 * 0.4);
  EXPECT_GT(quality, quality_of_pieces + 4 * 0.1);
}

TEST(NoiseResilientLCCPView, PointsBesideAndBehindTheCameraAreNoHarm)
{
  for (const float depth : {0.0f, -1.0f, 1e-6f}) {
    const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(
        new pcl::PointCloud<pcl::PointXYZ>(40, 40));
    for (int v = 0; v < 40; ++v)
      for (int u = 0; u < 40; ++u)
        cloud->at(u, v) = pcl::PointXYZ(static_cast<float>(u) * 0.01f,
                                        static_cast<float>(v) * 0.01f,
                                        depth + static_cast<float>(u % 7) * 1e-3f);
    pcl::NoiseResilientLCCP<pcl::PointXYZ> segmentation;
    segmentation.setInputCloud(cloud);
    Labels labels;
    segmentation.segment(labels);
    EXPECT_EQ(labels.size(), cloud->size());
    EXPECT_GT(segmentation.getResult().pieces.voxel_size, 0);
  }
}

TEST(NoiseResilientLCCPView, TheOrderOfJoiningIsATreeAsInRooms)
{
  const auto view = viewOfTable(90001);
  pcl::NoiseResilientLCCP<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(view.cloud);
  Labels labels;
  segmentation.segment(labels);
  const auto& result = segmentation.getResult();
  ASSERT_FALSE(result.joins.empty());
  for (std::size_t i = 1; i < result.joins.size(); ++i)
    EXPECT_LE(result.joins[i].level, result.joins[i - 1].level);
  EXPECT_GT(result.pieces.pieces.size(), result.segment_count);
  EXPECT_TRUE(result.scene.planes.empty()) << "nothing is taken for a wall";
}
