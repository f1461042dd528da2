/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/objects/segmented_scene.h"

#include "objects/join/object_joining.h"
#include "objects/object_steps.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

TEST(NoiseResilientLCCPUse, SeedsFartherApartThanTheSceneIsLargeAreAllAlike)
{
  const auto cloud = cloudOf(roomWithTwoBoxes().points);
  const auto labelsFor = [&cloud](double seed_resolution) {
    Segmentation segmentation;
    segmentation.setInputCloud(cloud);
    segmentation.setSeedResolution(seed_resolution);
    Labels labels;
    segmentation.segment(labels);
    EXPECT_EQ(labels.size(), cloud->size());
    return labels;
  };
  const auto labels = labelsFor(1e4);
  for (const double seed_resolution : {1e9, 1e300}) // the squares overflow
    EXPECT_EQ(labelsFor(seed_resolution), labels) << seed_resolution;
}

TEST(NoiseResilientLCCPUse, SmallInputs)
{
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 3; ++i) { // one point, then equal points
    points.emplace_back(1, 2, 3);
    EXPECT_EQ(segmentedObjects(cloudOf(points)), Labels(points.size(), 1));
  }
  const Cloud::Ptr nothing(new Cloud);
  nothing->emplace_back(std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f);
  EXPECT_TRUE(segmentedObjects(nothing).empty());
  EXPECT_TRUE(segmentedObjects(Cloud::Ptr(new Cloud)).empty());
}

TEST(NoiseResilientLCCPUse, PointsKilometresAwayGetNoSegmentAndChangeNothing)
{
  const auto points = floorWithTwoBoxes().points;
  const auto expected = segmentedObjects(cloudOf(points));
  for (const float far : {1e4f, 1e6f, 9e8f}) {
    auto with = points;
    for (int i = 0; i < 3; ++i)
      with.insert(with.begin() + 7 * i, far * Eigen::Vector3f::Unit(i));
    auto labels = segmentedObjects(cloudOf(with));
    ASSERT_EQ(labels.size(), with.size()) << far;
    for (int i = 2; i >= 0; --i) {
      EXPECT_EQ(labels[7 * i], 0u) << far;
      labels.erase(labels.begin() + 7 * i);
    }
    EXPECT_EQ(labels, expected) << far;
  }
}

TEST(NoiseResilientLCCPUse, ARoomInMillimetresHasNoPointsKilometresAway)
{
  auto points = floorWithTwoBoxes().points;
  for (auto& point : points)
    point *= 5000; // as if it were 20 km long
  const auto labels = segmentedObjects(cloudOf(points));
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 0u), 0);
}

TEST(NoiseResilientLCCPUse, IntermediateResultsFitTogether)
{
  const auto scene = floorWithTwoBoxes();
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  segmentation.setViewPoint(2, 1, 3);
  Labels labels;
  segmentation.segment(labels);
  const auto removed = segmentation.getRemovedIndices();
  const auto supervoxels = segmentation.getSupervoxelLabels();
  EXPECT_GT(removed.size(), 100u);
  EXPECT_LT(removed.size(), labels.size() / 4);
  std::size_t without = 0;
  for (const auto label : supervoxels)
    without += label == 0;
  const auto structure = segmentation.getStructureIndices();
  EXPECT_EQ(without, removed.size() + structure.size());
  std::size_t of_floor = 0; // the boxes have a rim, too
  for (const auto index : structure)
    of_floor += labels[index] == labels[structure.front()];
  EXPECT_GT(static_cast<double>(of_floor),
            0.97 * static_cast<double>(structure.size()));
  EXPECT_NEAR(
      static_cast<double>(structure.size()), // the floor
      static_cast<double>(std::count(scene.objects.begin(), scene.objects.end(), 1u)),
      0.03 * static_cast<double>(structure.size()));
  for (const auto index : removed)
    EXPECT_EQ(supervoxels[index], 0u);
  const auto adjacency = segmentation.getSupervoxelAdjacency();
  EXPECT_GT(adjacency.size(), 1000u);
  for (const auto& pair : adjacency) {
    const auto range = adjacency.equal_range(pair.second);
    EXPECT_TRUE(std::any_of(range.first, range.second, [&](const auto& other) {
      return other.second == pair.first;
    }));
  }
}

TEST(NoiseResilientLCCPUse, GivesNothingForWrongUse)
{
  Segmentation segmentation;
  Labels labels{1, 2, 3};
  segmentation.segment(labels);
  EXPECT_TRUE(labels.empty()) << "no cloud";
  const auto cloud = cloudOf({{0, 0, 0}, {1, 0, 0}});
  segmentation.setInputCloud(cloud);
  const auto expectRejected = [&](const char* what) {
    labels.assign(3, 1);
    segmentation.segment(labels);
    EXPECT_TRUE(labels.empty()) << what;
    segmentation.setOptions({});
  };
  segmentation.setVoxelResolution(-0.01);
  expectRejected("voxel resolution");
  segmentation.setViewPoint(0, 1e300, 0);
  expectRejected("viewpoint");
  segmentation.setViewPoint(0, 0, 0);
  segmentation.setVoxelResolution(1e-9);
  expectRejected("voxels too small for the cloud");
  segmentation.setVoxelResolution(0.03);
  segmentation.setSeedResolution(0.01);
  expectRejected("seed resolution");
  segmentation.setSeedResolution(std::nanf(""));
  expectRejected("seed resolution that is no number");
  segmentation.setCurvatureThreshold(0.4f);
  expectRejected("curvature");
  segmentation.setRatioThreshold(std::nanf(""));
  expectRejected("ratio");
  segmentation.setGraphScale(-1);
  expectRejected("scale");
  segmentation.setJoiningLevel(2);
  expectRejected("level");
  segmentation.setConcavityToleranceThreshold(181);
  expectRejected("tolerance");
  ObjectSegmentationOptions options;
  options.spatial_weight = -1;
  segmentation.setOptions(options);
  expectRejected("spatial weight");
  options = {};
  options.normal_weight = -1;
  segmentation.setOptions(options);
  expectRejected("normal weight");
  thesis::ObjectOptions graph;
  graph.edges.concavity_weight = 2;
  segmentation.setThesisOptions(graph);
  expectRejected("concavity weight");
  segmentation.setThesisOptions(thesisOptions());
  segmentation.setPartition(Segmentation::Partition::Pieces);
  expectRejected("pieces on points");
  for (const float level : {-0.1f, 1.1f, std::nanf("")}) {
    options = {};
    options.pieces.joining_level = level;
    segmentation.setOptions(options);
    expectRejected("joining level");
  }
  segmentation.setUpAxis({0, 0, 0});
  expectRejected("up");
  segmentation.setUpAxis({0, 0, 1});
  segmentation.setInputNormals(
      pcl::PointCloud<pcl::Normal>::Ptr(new pcl::PointCloud<pcl::Normal>));
  expectRejected("normals");
  segmentation.setInputNormals({});
  segmentation.setIndices(pcl::IndicesPtr(new pcl::Indices{2}));
  expectRejected("index");
  segmentation.setIndices(pcl::IndicesPtr(new pcl::Indices{0, 1}));
  segmentation.segment(labels);
  EXPECT_EQ(labels.size(), 2u) << "usable again";
}

TEST(NoiseResilientLCCPUse, OtherLevelsAndStructureFitTheSegments)
{
  const auto scene = roomWithTwoBoxes();
  const auto cloud = cloudOf(scene.points);
  (*cloud)[7].x = std::numeric_limits<float>::quiet_NaN();
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  Labels labels;
  segmentation.segment(labels);
  const auto structure = segmentation.getStructure();
  ASSERT_EQ(structure.size(), labels.size());
  EXPECT_EQ(structure[7], 0u);
  std::map<std::uint32_t, std::uint32_t> of_segment, right, all;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == 0)
      continue;
    EXPECT_EQ(of_segment.emplace(labels[i], structure[i]).first->second, structure[i])
        << "all points of a segment are alike";
    const auto object = scene.objects[i]; // 1 floor, 2 and 3 boxes, 4 ceiling
    const std::uint32_t kind = object == 1 ? 1 : object < 4 ? 0 : object == 4 ? 3 : 2;
    ++all[kind];
    right[kind] += structure[i] == kind;
  }
  ASSERT_EQ(all.size(), 4u);
  for (const auto& [kind, count] : all)
    EXPECT_GT(right[kind], 0.95 * count) << "kind " << kind;
  const auto& hierarchy = segmentation.getHierarchy();
  for (const float level : {0.3f, 0.6f, 1.0f}) {
    const auto segments = segmentation.getSegmentsAtLevel(level);
    ASSERT_EQ(segments.size(), labels.size());
    EXPECT_EQ(segments[7], 0u);
    const auto names = segmentsAtLevel(
        stepsOf(segmentation.getResult()).pieces.pieces.size(), hierarchy, level);
    std::set<std::uint32_t> found;
    for (std::size_t i = 0; i < segments.size(); ++i)
      if (i != 7)
        found.insert(segments[i] - 1);
    EXPECT_EQ(found, std::set<std::uint32_t>(names.begin(), names.end()));
  }
  segmentation.setPartition(Segmentation::Partition::Lccp);
  segmentation.segment(labels);
  EXPECT_TRUE(segmentation.getSegmentsAtLevel(0.5f).empty());
  EXPECT_TRUE(segmentation.getHierarchy().empty());
}

TEST(NoiseResilientLCCPUse, DefaultsAreAsDocumented)
{
  const Segmentation segmentation;
  EXPECT_DOUBLE_EQ(segmentation.getVoxelResolution(), 0);
  EXPECT_DOUBLE_EQ(segmentation.getSeedResolution(), 0);
  EXPECT_FLOAT_EQ(segmentation.getCurvatureThreshold(), 0.03f);
  EXPECT_FLOAT_EQ(segmentation.getRatioThreshold(), 0.2f);
  EXPECT_FLOAT_EQ(segmentation.getGraphScale(), 3);
  EXPECT_EQ(segmentation.getMinSegmentSize(), 4u);
  EXPECT_EQ(segmentation.getJoiningScale(), JoiningScale::Objects);
  EXPECT_FALSE(segmentation.getJoiningLevel());
  EXPECT_EQ(partsOptions().pieces.scale, JoiningScale::Parts);
  EXPECT_EQ(singleViewOptions().pieces.scale, JoiningScale::View);
  EXPECT_EQ(singleViewOptions().min_segment_size, 6u);
  EXPECT_EQ(segmentation.getUpAxis(), Eigen::Vector3f::UnitZ());
  EXPECT_FLOAT_EQ(segmentation.getConcavityToleranceThreshold(), 10);
  EXPECT_EQ(segmentation.getPartition(), Segmentation::Partition::Pieces);
  EXPECT_FALSE(segmentation.getInputNormals());
}

TEST(NoiseResilientLCCPUse, SizesThatAreNotGivenFollowFromTheOthers)
{
  const auto expectSizes =
      [](const ObjectSegmentationOptions& options, double voxel, double seed) {
        const auto sized = withSizes(options);
        EXPECT_DOUBLE_EQ(sized.voxel_size, voxel);
        EXPECT_DOUBLE_EQ(sized.seed_size, seed);
      };
  expectSizes({}, 0.03, 0.12);
  expectSizes(partsOptions(), 0.03, 0.12);
  expectSizes(singleViewOptions(), 0.005, 0.02);
  ObjectSegmentationOptions options;
  options.seed_size = 0.2;
  expectSizes(options, 0.05, 0.2);
  options.voxel_size = 0.1;
  expectSizes(options, 0.1, 0.2);
  options.seed_size = 0;
  expectSizes(options, 0.1, 0.4);
}

TEST(NoiseResilientLCCPUse, TheThesisTakesLargePlanesOffByRansac)
{
  const auto scene = floorWithTwoBoxes();
  const auto thesis = thesisOptions();
  EXPECT_EQ(thesis.shared.min_segment_size, 3u);
  EXPECT_FLOAT_EQ(thesis.edges.graph_scale, 3);
  Segmentation segmentation;
  segmentation.setThesisOptions(thesis);
  EXPECT_EQ(segmentation.getPartition(),
            Segmentation::Partition::FelzenszwalbHuttenlocher);
  segmentation.setInputCloud(cloudOf(scene.points));
  segmentation.setViewPoint(2, 1, 3);
  Labels labels;
  segmentation.segment(labels);
  EXPECT_FALSE(segmentation.getStructureIndices().empty());
  auto whole = thesis;
  whole.on_points->ransac_share = 0;
  segmentation.setThesisOptions(whole);
  segmentation.segment(labels);
  EXPECT_TRUE(segmentation.getStructureIndices().empty());
  auto wrong = thesis;
  wrong.edges.graph_scale = -1;
  segmentation.setThesisOptions(wrong);
  segmentation.segment(labels);
  EXPECT_TRUE(labels.empty());
}

template <typename PointT>
class NoiseResilientLCCPOf : public testing::Test {};
using PointTypes = testing::
    Types<pcl::PointXYZ, pcl::PointXYZRGB, pcl::PointXYZRGBA, pcl::PointNormal>;
TYPED_TEST_SUITE(NoiseResilientLCCPOf, PointTypes);

TYPED_TEST(NoiseResilientLCCPOf, GivesTheSameForAllPointTypes)
{
  const auto scene = floorWithTwoBoxes();
  const typename pcl::PointCloud<TypeParam>::Ptr cloud(new pcl::PointCloud<TypeParam>);
  for (const auto& place : scene.points) {
    TypeParam point;
    point.getVector3fMap() = place;
    cloud->push_back(point);
  }
  pcl::NoiseResilientLCCP<TypeParam> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setViewPoint(2, 1, 3);
  Labels labels;
  segmentation.segment(labels);
  EXPECT_EQ(labels, segmentedObjects(cloudOf(scene.points)));
}

TEST(NoiseResilientLCCPUse, AllOutputsAreAlike)
{
  const auto scene = floorWithTwoBoxes();
  const auto cloud = cloudOf(scene.points);
  (*cloud)[7].x = std::numeric_limits<float>::quiet_NaN();
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setViewPoint(2, 1, 3);
  Labels labels;
  segmentation.segment(labels);
  EXPECT_EQ(labels[7], 0u);
  std::vector<pcl::PointIndices> segments;
  segmentation.segment(segments);
  ASSERT_EQ(segments.size(), *std::max_element(labels.begin(), labels.end()));
  std::size_t listed = 0;
  for (std::size_t s = 0; s < segments.size(); ++s)
    for (const auto index : segments[s].indices) {
      ASSERT_EQ(labels[index], s + 1);
      ++listed;
    }
  EXPECT_EQ(listed, labels.size() - 1);
  pcl::PointCloud<pcl::PointXYZL> output;
  segmentation.segment(output);
  ASSERT_EQ(output.size(), labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
    ASSERT_EQ(output[i].label, labels[i]);
  segmentation.setVoxelResolution(-1);
  segmentation.segment(segments);
  EXPECT_TRUE(segments.empty());
  segmentation.segment(output);
  EXPECT_TRUE(output.empty());
}

TEST(NoiseResilientLCCPUse, ProgressRisesFromZeroToOneAndCanStopTheWork)
{
  const auto cloud = cloudOf(roomWithTwoBoxes().points);
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  std::vector<double> shares;
  segmentation.setProgressCallback([&](double share, const char* stage) {
    EXPECT_FALSE(std::string(stage).empty());
    shares.push_back(share);
    return true;
  });
  Labels labels;
  segmentation.segment(labels);
  ASSERT_GE(shares.size(), 3u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);
  for (const double last : shares) {
    segmentation.setProgressCallback(
        [&](double share, const char*) { return share < last; });
    segmentation.segment(labels);
    EXPECT_TRUE(labels.empty()) << last;
    EXPECT_TRUE(segmentation.getStructureIndices().empty());
  }
  segmentation.setProgressCallback({});
  segmentation.segment(labels);
  EXPECT_EQ(labels.size(), cloud->size());
}

TEST(NoiseResilientLCCPUse, TheDirectionUpMayPointAnywhere)
{
  const auto scene = roomWithTwoBoxes();
  auto lying = scene;
  Eigen::Matrix3f turn; // z becomes y
  turn << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  lying.turn(turn);
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  Labels upright, labels;
  segmentation.segment(upright);
  segmentation.setInputCloud(cloudOf(lying.points));
  segmentation.setUpAxis({0, 2, 0});
  EXPECT_EQ(segmentation.getUpAxis(), Eigen::Vector3f(0, 1, 0));
  segmentation.segment(labels);
  EXPECT_GT(agreement(upright, labels), 0.99);
  segmentation.setUpAxis({0, 0, 0});
  segmentation.segment(labels);
  EXPECT_TRUE(labels.empty());
}

TEST(NoiseResilientLCCPUse, TheDirectionUpIsFound)
{
  const auto scene = roomWithTwoBoxes();
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  Labels upright, labels;
  segmentation.segment(upright);
  EXPECT_EQ(segmentation.getReport().up_axis, Eigen::Vector3f::UnitZ());
  EXPECT_TRUE(segmentation.getReport().warnings.empty());
  auto tilted = scene;
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(0.35f, Eigen::Vector3f(1, 2, 0).normalized())
          .toRotationMatrix();
  tilted.turn(turn);
  segmentation.setInputCloud(cloudOf(tilted.points));
  segmentation.segment(labels);
  EXPECT_GT(agreement(upright, labels), 0.99);
  const Eigen::Vector3f up = turn * Eigen::Vector3f::UnitZ();
  EXPECT_GT(segmentation.getReport().up_axis.dot(up), std::cos(0.02f));
  ASSERT_EQ(segmentation.getReport().warnings.size(), 1u);
  EXPECT_NE(segmentation.getReport().warnings[0].find("tilted by 20"),
            std::string::npos);
  segmentation.setUpAxis(up); // as set, without a word
  segmentation.segment(labels);
  EXPECT_EQ(segmentation.getReport().up_axis, up.normalized());
  EXPECT_TRUE(segmentation.getReport().warnings.empty());
}

TEST(NoiseResilientLCCPUse, SettersHaveGetters)
{
  Segmentation segmentation;
  EXPECT_EQ(segmentation.getNumberOfThreads(), 0u);
  segmentation.setNumberOfThreads(3);
  EXPECT_EQ(segmentation.getNumberOfThreads(), 3u);
  EXPECT_EQ(segmentation.getViewPoint(), Eigen::Vector3d(0, 0, 0));
  segmentation.setViewPoint(1, 2, 3);
  EXPECT_EQ(segmentation.getViewPoint(), Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(segmentation.getUseSingleCameraTransform());
  const auto organised = pcl::make_shared<Cloud>(4, 3, pcl::PointXYZ(1, 2, 4));
  segmentation.setInputCloud(organised);
  EXPECT_TRUE(segmentation.getUseSingleCameraTransform()) << "1 m before the camera";
  organised->at(0, 0).z = -1;
  EXPECT_FALSE(segmentation.getUseSingleCameraTransform()) << "not all are before it";
  organised->at(0, 0).z = 4;
  segmentation.setUseSingleCameraTransform(false);
  EXPECT_FALSE(segmentation.getUseSingleCameraTransform());
}
