/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Views of a depth camera, with simulated tables that no criterion was learned from.
#include "objects/object_steps.h"

#include <pcl/segmentation/noise_resilient_lccp.h>
#include <pcl/segmentation/segmentation_metrics.h>
#include <pcl/simulation/depth_camera.h>
#include <pcl/simulation/random_plan.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace pcl::indoor;

namespace {

using Labels = std::vector<std::uint32_t>;

struct View {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud{
      new pcl::PointCloud<pcl::PointXYZ>(640, 480)};
  Labels objects; ///< 0 = wall or floor, or no depth
};

View
viewOf(const Building& building, const CameraPose& pose, std::uint32_t seed)
{
  DepthCameraOptions camera;
  camera.seed = seed;
  const auto seen = viewBuilding(building, pose, camera);
  View view;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    (*view.cloud)[i] = pcl::PointXYZ(seen[i].x, seen[i].y, seen[i].z);
    view.objects.push_back(seen[i].object);
  }
  return view;
}

View
viewOfTable(std::uint32_t seed, const Eigen::Vector3d& position = {0.6, 0.5, 1.5})
{
  const auto building = buildBuilding(randomPlan(seed, PlanKind::Table));
  return viewOf(building, {position, {0, 0, 0.7}}, seed);
}

using Segmentation = pcl::NoiseResilientLCCP<pcl::PointXYZ>;

Labels
segmentedBy(Segmentation& segmentation,
            const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud)
{
  Labels labels;
  segmentation.setInputCloud(cloud);
  segmentation.segment(labels);
  return labels;
}

/** Whether a line of the last run holds some words. */
bool
says(const Segmentation& segmentation, const std::string& words)
{
  const auto& lines = segmentation.getReport().warnings;
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    return line.find(words) != std::string::npos;
  });
}

/** The points with depth in a row, and their labels. */
View
withoutRows(const pcl::PointCloud<pcl::PointXYZ>& cloud, const Labels& labels)
{
  View view;
  view.cloud->clear();
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (std::isfinite(cloud[i].z)) {
      view.cloud->push_back(cloud[i]);
      view.objects.push_back(labels[i]);
    }
  return view;
}

/** Up in the frame of a camera that is not rolled. */
Eigen::Vector3f
upSeenFrom(const CameraPose& pose)
{
  const Eigen::Vector3d forwards = (pose.target - pose.position).normalized();
  const double cosine = forwards.head<2>().norm();
  return Eigen::Vector3d(0, -cosine, forwards.z()).cast<float>();
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
    quality += scoreObjects(view.objects, labels).panopticQuality();

    auto options = singleViewOptions();
    options.pieces.joining_level = 1;
    segmentation.setOptions(options);
    segmentation.segment(labels);
    quality_of_pieces += scoreObjects(view.objects, labels).panopticQuality();
  }
  EXPECT_GT(quality, 4 * 0.4);
  EXPECT_GT(quality, quality_of_pieces + 4 * 0.1);
}

TEST(NoiseResilientLCCPView, ARoomIsSegmentedAsARoom)
{
  double quality = 0, quality_of_table = 0;
  int rooms = 0;
  for (std::uint32_t seed = 90001; seed <= 90006; ++seed) {
    const auto building = buildBuilding(randomPlan(seed, PlanKind::Home));
    const auto pose = drawCameraPose(building, {}, seed);
    if ((pose.target - pose.position).norm() < 2)
      continue;
    ++rooms;
    const auto view = viewOf(building, pose, seed);
    pcl::NoiseResilientLCCP<pcl::PointXYZ> segmentation;
    segmentation.setInputCloud(view.cloud);
    EXPECT_FALSE(segmentation.getUseSingleCameraTransform());
    Labels labels;
    segmentation.segment(labels);
    ASSERT_EQ(labels.size(), view.objects.size());
    EXPECT_GT(stepsOf(segmentation.getResult()).scene.up.dot(upSeenFrom(pose)), 0.996)
        << "5 degrees off, seed " << seed;
    EXPECT_FALSE(segmentation.getStructureIndices().empty()) << "no wall, no floor";
    quality += scoreObjects(view.objects, labels).panopticQuality();

    segmentation.setUseSingleCameraTransform(true);
    segmentation.segment(labels);
    quality_of_table += scoreObjects(view.objects, labels).panopticQuality();
  }
  ASSERT_GE(rooms, 3);
  EXPECT_GT(quality, rooms * 0.4);
  EXPECT_GT(quality, quality_of_table + rooms * 0.2);
}

TEST(NoiseResilientLCCPView, TheDirectionUpThatWasSetIsTaken)
{
  const auto building = buildBuilding(randomPlan(90001, PlanKind::Home));
  const auto view = viewOf(building, drawCameraPose(building, {}, 1), 1);
  pcl::NoiseResilientLCCP<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(view.cloud);
  segmentation.setUpAxis({0, -1, 0});
  Labels labels;
  segmentation.segment(labels);
  EXPECT_EQ(stepsOf(segmentation.getResult()).scene.up, Eigen::Vector3f(0, -1, 0));
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
    for (const bool is_single : {false, true}) {
      pcl::NoiseResilientLCCP<pcl::PointXYZ> segmentation;
      segmentation.setInputCloud(cloud);
      if (is_single)
        segmentation.setUseSingleCameraTransform(true);
      Labels labels;
      segmentation.segment(labels);
      ASSERT_EQ(labels.size(), cloud->size()) << depth;
      EXPECT_EQ(std::count(labels.begin(), labels.end(), 0u), 0) << depth;
      EXPECT_EQ(*std::max_element(labels.begin(), labels.end()),
                segmentation.getResult().segment_count)
          << depth;
    }
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
  EXPECT_GT(stepsOf(result).pieces.pieces.size(), result.segment_count);
  EXPECT_TRUE(stepsOf(result).scene.planes.empty()) << "nothing is taken for a wall";
}

TEST(NoiseResilientLCCPView, ItsFrameAndItsRowsDoNotMatter)
{
  const auto view = viewOfTable(90001);
  Segmentation segmentation;
  const auto expected = segmentedBy(segmentation, view.cloud);
  ASSERT_EQ(segmentation.getReport().warnings.size(), 1u);
  EXPECT_TRUE(says(segmentation, "along z, with y down"));
  auto turned = view;
  for (auto& point : *turned.cloud)
    point = pcl::PointXYZ(point.x, -point.y, -point.z);
  EXPECT_EQ(segmentedBy(segmentation, turned.cloud), expected);
  EXPECT_TRUE(segmentation.getReport().view.is_turned);
  ASSERT_EQ(segmentation.getReport().warnings.size(), 1u) << "it is said";
  for (const auto& cloud : {view.cloud, turned.cloud}) {
    const auto points = withoutRows(*cloud, expected);
    EXPECT_EQ(segmentedBy(segmentation, points.cloud), points.objects);
    EXPECT_EQ(segmentation.getReport().warnings.size(), 1u);
  }
}

TEST(NoiseResilientLCCPView, ARoomMayBeSeenAlongMinusZ)
{
  const auto building = buildBuilding(randomPlan(90001, PlanKind::Home));
  auto view = viewOf(building, drawCameraPose(building, {}, 1), 1);
  Segmentation segmentation;
  const auto expected = segmentedBy(segmentation, view.cloud);
  for (auto& point : *view.cloud)
    point = pcl::PointXYZ(point.x, -point.y, -point.z);
  EXPECT_EQ(segmentedBy(segmentation, view.cloud), expected);
}

TEST(NoiseResilientLCCPView, ATableIsATableFromFartherOff)
{
  double quality = 0;
  int tables = 0;
  for (std::uint32_t seed = 90001; seed <= 90004; ++seed) {
    const auto building =
        buildBuilding(randomPlan(seed, PlanKind::Table, PlanFilling::Cluttered));
    const auto view = viewOf(building, {{0.9, 0.8, 1.9}, {0, 0, 0.75}}, seed);
    Segmentation segmentation;
    quality += scoreObjects(view.objects, segmentedBy(segmentation, view.cloud))
                   .panopticQuality();
    tables += segmentation.getReport().view.capture == Capture::TableView;
  }
  EXPECT_GE(tables, 3) << "what is looked at may be large";
  EXPECT_GT(quality, 4 * 0.3);
}

TEST(NoiseResilientLCCPView, ObjectsOnATableAreToldInWhateverFrameItStands)
{
  const Eigen::Quaternionf turn = Eigen::Quaternionf(3, -1, 2, 5).normalized();
  double quality = 0;
  for (std::uint32_t seed = 90001; seed <= 90004; ++seed) {
    const auto building =
        buildBuilding(randomPlan(seed, PlanKind::Table, PlanFilling::LivedIn));
    const CameraPose pose{{0.9, 0.8, 1.6}, {0, 0, 0.7}};
    const auto seen = viewOf(building, pose, seed);
    auto view = withoutRows(*seen.cloud, seen.objects);
    for (auto& point : *view.cloud)
      point.getVector3fMap() = turn * point.getVector3fMap();
    Segmentation segmentation;
    segmentation.setUpAxis(turn * upSeenFrom(pose));
    const auto labels = segmentedBy(segmentation, view.cloud);
    EXPECT_EQ(segmentation.getReport().view.capture, Capture::Scan) << "a larger scan";
    EXPECT_FALSE(segmentation.getStructureIndices().empty()) << "floor and walls";
    quality += scoreObjects(view.objects, labels).panopticQuality();
  }
  EXPECT_GT(quality, 4 * 0.3);
}

TEST(NoiseResilientLCCPView, OnlyWhatWasSetIsChanged)
{
  const auto view = viewOfTable(90001);
  Segmentation segmentation, changed;
  const auto expected = segmentedBy(segmentation, view.cloud);
  changed.setVoxelResolution(0);
  changed.setFewestPoints(100);
  changed.setPartition(Partition::Pieces);
  EXPECT_EQ(segmentedBy(changed, view.cloud), expected) << "all are defaults";
  EXPECT_EQ(changed.getReport().options.min_segment_size, 6u);
  EXPECT_EQ(changed.getReport().options.pieces.scale, JoiningScale::View);
  EXPECT_EQ(changed.getReport().options.voxel_size, 0.005);
  changed.setVoxelResolution(0.01);
  EXPECT_NE(segmentedBy(changed, view.cloud), expected);
  EXPECT_EQ(changed.getReport().options.voxel_size, 0.01);
  EXPECT_EQ(changed.getReport().options.seed_size, 0.04);
  EXPECT_EQ(changed.getReport().options.min_segment_size, 6u) << "it was not set";
  changed.setOptions(ObjectSegmentationOptions());
  segmentedBy(changed, view.cloud);
  EXPECT_EQ(changed.getReport().options.voxel_size, 0.03) << "all were set";
}

TEST(NoiseResilientLCCPView, OneSegmentAndMillimetresAreSaid)
{
  auto view = viewOfTable(90001);
  Segmentation segmentation;
  segmentation.setVoxelResolution(0.3);
  segmentedBy(segmentation, view.cloud);
  EXPECT_TRUE(says(segmentation, "one segment"));
  for (auto& point : *view.cloud)
    point.getVector3fMap() *= 1000;
  segmentedBy(segmentation, view.cloud);
  EXPECT_TRUE(says(segmentation, "millimetres"));
}
