/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/segmented_scene.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

/** A wall (1) along x, into y, with the frame of a door (2) before it. */
LabelledPoints
frameAtWall()
{
  LabelledPoints scene;
  std::mt19937 rng(9);
  scene.addRectangle(
      {0, 0, 0}, {3, 0, 0}, {0, 0, 2.5f}, {0, 1, 0}, 1, 0.015f, 0.003f, rng);
  scene.removeIf([](const Eigen::Vector3f& p) { // the frame and the opening
    return p.x() > 1 && p.x() < 2 && p.z() < 2.1f;
  });
  for (const float x : {1.0f, 1.92f})
    scene.addBox({x, 0, 0}, {0.08f, 0.1f, 2}, 2, 0.012f, 0.003f, rng);
  scene.addBox({0.97f, 0, 2.01f}, {1.06f, 0.14f, 0.09f}, 2, 0.012f, 0.003f, rng);
  return scene;
}

/** Floor (3) and two walls (4, 5) before a wall that was turned by 30 degrees. */
void
addRoomBefore(LabelledPoints& scene)
{
  std::mt19937 rng(10);
  const auto add = [&](const Eigen::Vector3f& corner,
                       const Eigen::Vector3f& u,
                       const Eigen::Vector3f& v,
                       const Eigen::Vector3f& normal,
                       std::uint32_t object) {
    scene.addRectangle(corner, u, v, normal, object, 0.015f, 0.003f, rng);
  };
  const float width = 3 * std::cos(static_cast<float>(M_PI) / 6);
  add({0, 0, 0}, {width, 0, 0}, {0, 4, 0}, {0, 0, 1}, 3);
  scene.removeIf([](const Eigen::Vector3f& p) { // of the floor, what is behind the wall
    return p.z() < 0.05f &&
           p.y() < std::tan(static_cast<float>(M_PI) / 6) * p.x() - 0.05f;
  });
  add({0, 0, 0}, {0, 4, 0}, {0, 0, 2.5f}, {1, 0, 0}, 4);
  add({0, 4, 0}, {width, 0, 0}, {0, 0, 2.5f}, {0, -1, 0}, 5);
}

/** Of the points of an object, the share that is in its largest segment. */
double
largestShareOf(std::uint32_t object, const LabelledPoints& scene, const Labels& labels)
{
  std::map<std::uint32_t, double> counts;
  double all = 0, largest = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (scene.objects[i] == object) {
      ++all;
      largest = std::max(largest, ++counts[labels[i]]);
    }
  return largest / all;
}

Labels
segmentedWithout(bool ObjectSegmentationOptions::*step, Segmentation& segmentation)
{
  auto options = segmentation.getOptions();
  options.*step = false;
  segmentation.setOptions(options);
  Labels labels;
  segmentation.segment(labels);
  return labels;
}

} // namespace

TEST(NoiseResilientLCCPUse, SmallInputs)
{
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 3; ++i) { // one point, then equal points
    points.emplace_back(1, 2, 3);
    EXPECT_EQ(segmented(cloudOf(points)), Labels(points.size(), 1));
  }
  const Cloud::Ptr nothing(new Cloud);
  nothing->emplace_back(std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f);
  EXPECT_EQ(segmented(nothing), Labels{0});
  EXPECT_TRUE(segmented(Cloud::Ptr(new Cloud)).empty());
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
  segmentation.setVoxelResolution(0);
  expectRejected("voxel resolution");
  segmentation.setVoxelResolution(1e-9);
  expectRejected("voxels too small for the cloud");
  segmentation.setSeedResolution(0.01);
  expectRejected("seed resolution");
  segmentation.setCurvatureThreshold(0.4f);
  expectRejected("curvature");
  segmentation.setRatioThreshold(std::nanf(""));
  expectRejected("ratio");
  segmentation.setGraphScale(-1);
  expectRejected("scale");
  segmentation.setBendThreshold(200);
  expectRejected("bend");
  segmentation.setConcavityToleranceThreshold(181);
  expectRejected("tolerance");
  ObjectSegmentationOptions options;
  options.recovery.accepted_share = 0;
  segmentation.setOptions(options);
  expectRejected("share");
  options = {};
  options.spatial_weight = -1;
  segmentation.setOptions(options);
  expectRejected("spatial weight");
  options = {};
  options.normal_weight = -1;
  segmentation.setOptions(options);
  expectRejected("normal weight");
  options = {};
  options.concavity_weight = 2;
  segmentation.setOptions(options);
  expectRejected("concavity weight");
  options = {};
  options.normal_rings = 0;
  segmentation.setOptions(options);
  expectRejected("rings");
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

TEST(NoiseResilientLCCPUse, DefaultsAreAsDocumented)
{
  const Segmentation segmentation;
  EXPECT_DOUBLE_EQ(segmentation.getVoxelResolution(), 0.03);
  EXPECT_DOUBLE_EQ(segmentation.getSeedResolution(), 0.12);
  EXPECT_FLOAT_EQ(segmentation.getCurvatureThreshold(), 0.03f);
  EXPECT_FLOAT_EQ(segmentation.getRatioThreshold(), 0.2f);
  EXPECT_FLOAT_EQ(segmentation.getGraphScale(), 3);
  EXPECT_FLOAT_EQ(segmentation.getBendThreshold(), 23);
  EXPECT_EQ(segmentation.getMinSegmentSize(), 4u);
  EXPECT_TRUE(segmentation.getOptions().separate_structure);
  EXPECT_TRUE(segmentation.getOptions().separate_things);
  EXPECT_TRUE(segmentation.getOptions().separate_gaps);
  EXPECT_TRUE(segmentation.getOptions().separate_seams);
  EXPECT_TRUE(segmentation.getOptions().join_frames);
  EXPECT_TRUE(segmentation.getOptions().join_racks);
  EXPECT_TRUE(segmentation.getOptions().join_uprights);
  EXPECT_FALSE(singleViewOptions().join_uprights);
  EXPECT_EQ(segmentation.getOptions().up, Eigen::Vector3f::UnitZ());
  EXPECT_DOUBLE_EQ(segmentation.getOptions().max_union_air, 5);
  EXPECT_FLOAT_EQ(segmentation.getConcavityToleranceThreshold(), 10);
  EXPECT_EQ(segmentation.getPartition(), Segmentation::Partition::Graph);
  EXPECT_FALSE(segmentation.getInputNormals());
}

TEST(NoiseResilientLCCPUse, PartsABookFromTheBoxThatItLiesOn)
{
  auto scene = floorWithTwoBoxes();
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    auto& point = scene.points[i];
    if (scene.objects[i] == 2 && point.z() > 0.58f && point.x() > 0.75f &&
        point.x() < 1.05f && point.y() > 1 && point.y() < 1.2f) {
      point.z() += 0.025f;
      scene.objects[i] = 4;
    }
  }
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  segmentation.setViewPoint(2, 1, 3);
  Labels labels;
  segmentation.segment(labels);
  const auto errors = richtsfeldErrors(countOverlaps(scene.objects, labels));
  EXPECT_LT(errors.over, 0.02);
  EXPECT_LT(errors.under, 0.02);
  auto options = segmentation.getOptions();
  options.separate_things = false;
  segmentation.setOptions(options);
  segmentation.segment(labels);
  EXPECT_GT(richtsfeldErrors(countOverlaps(scene.objects, labels)).under, 0.05);
  options.up = {0, 0, 0};
  segmentation.setOptions(options);
  segmentation.segment(labels);
  EXPECT_TRUE(labels.empty());
}

TEST(NoiseResilientLCCPUse, PartsBoxesAtANarrowGap)
{
  LabelledPoints scene;
  std::mt19937 rng(7);
  scene.addBox({0, 0, 0}, {0.8f, 0.5f, 0.7f}, 1, 0.012f, 0.003f, rng);
  scene.addBox({0.83f, 0, 0}, {0.8f, 0.5f, 0.7f}, 2, 0.012f, 0.003f, rng);
  scene.removeIf([](const Eigen::Vector3f& p) { // not seen
    return p.x() > 0.79f && p.x() < 0.84f && p.y() > 0.02f && p.y() < 0.48f &&
           p.z() < 0.68f;
  });
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  segmentation.setViewPoint(0.8f, -1, 2);
  Labels labels;
  segmentation.segment(labels);
  EXPECT_LT(richtsfeldErrors(countOverlaps(scene.objects, labels)).under, 0.01);
  labels = segmentedWithout(&ObjectSegmentationOptions::separate_gaps, segmentation);
  EXPECT_GT(richtsfeldErrors(countOverlaps(scene.objects, labels)).under, 0.2);
}

TEST(NoiseResilientLCCPUse, PartsCabinetsThatStandAgainstEachOther)
{
  LabelledPoints scene;
  std::mt19937 rng(8);
  for (const std::uint32_t cabinet : {1u, 2u})
    scene.addBox({cabinet == 1 ? 0 : 0.608f, 0, 0},
                 {0.6f, 0.6f, 0.87f},
                 cabinet,
                 0.012f,
                 0.004f,
                 rng);
  scene.removeIf([](const Eigen::Vector3f& p) { // not seen
    return p.y() > 0.58f ||
           (p.x() > 0.5f && p.x() < 0.7f && p.y() > 0.3f && p.z() < 0.85f);
  });
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  segmentation.setViewPoint(0.6f, -2, 2);
  Labels labels;
  segmentation.segment(labels);
  EXPECT_LT(richtsfeldErrors(countOverlaps(scene.objects, labels)).under, 0.05);
  labels = segmentedWithout(&ObjectSegmentationOptions::separate_seams, segmentation);
  EXPECT_GT(richtsfeldErrors(countOverlaps(scene.objects, labels)).under, 0.5);
}

TEST(NoiseResilientLCCPUse, JoinsTheBoardsOfABookcase)
{
  LabelledPoints scene;
  std::mt19937 rng(8);
  for (const float z : {0.2f, 0.6f, 1.0f, 1.4f})
    scene.addBox({0, 0, z}, {1, 0.35f, 0.02f}, 1, 0.012f, 0.003f, rng);
  for (const float x : {-0.02f, 1.0f})
    scene.addBox({x, 0, 0}, {0.02f, 0.35f, 1.6f}, 1, 0.012f, 0.003f, rng);
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  segmentation.setViewPoint(-1, -3, 2);
  auto labels =
      segmentedWithout(&ObjectSegmentationOptions::join_uprights, segmentation);
  const auto joined = richtsfeldErrors(countOverlaps(scene.objects, labels)).over;
  labels = segmentedWithout(&ObjectSegmentationOptions::join_racks, segmentation);
  const auto apart = richtsfeldErrors(countOverlaps(scene.objects, labels)).over;
  EXPECT_GT(apart, 0.4);
  EXPECT_LT(joined, 0.7 * apart);
}

TEST(NoiseResilientLCCPUse, JoinsTheEndBoardsOfADeskThatIsSeenFromBelow)
{
  LabelledPoints scene;
  std::mt19937 rng(8);
  const Eigen::Vector3f x(1.4f, 0, 0), y(0, 0.7f, 0), z(0, 0, 0.7f), right(1, 0, 0);
  scene.addRectangle(z, x, y, {0, 0, -1}, 1, 0.012f, 0.002f, rng);
  scene.addRectangle({0, 0, 0}, y, z, right, 1, 0.012f, 0.002f, rng);
  scene.addRectangle(x, y, z, -right, 1, 0.012f, 0.002f, rng);
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  segmentation.setInputNormals(normalsOf(scene));
  Labels labels;
  segmentation.segment(labels);
  EXPECT_GT(largestShareOf(1, scene, labels), 0.97);
  labels = segmentedWithout(&ObjectSegmentationOptions::join_uprights, segmentation);
  EXPECT_LT(largestShareOf(1, scene, labels), 0.6);
}

TEST(NoiseResilientLCCPUse, JoinsTheFrameOfADoorInAWallThatStandsAskew)
{
  constexpr float angle = static_cast<float>(M_PI) / 6;
  auto scene = frameAtWall();
  scene.turn(Eigen::AngleAxisf(angle, Eigen::Vector3f::UnitZ()).toRotationMatrix());
  addRoomBefore(scene);
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  segmentation.setViewPoint(0.5f, 2, 1.4f);
  auto options = segmentation.getOptions();
  options.separate_gaps = false; // parts the jambs from a head that is so much deeper
  segmentation.setOptions(options);
  Labels labels;
  segmentation.segment(labels);
  EXPECT_GT(largestShareOf(2, scene, labels), 0.97);
  labels = segmentedWithout(&ObjectSegmentationOptions::join_frames, segmentation);
  EXPECT_LT(largestShareOf(2, scene, labels), 0.6);
}

TEST(NoiseResilientLCCPUse, TheThesisKeepsWallsInTheGraph)
{
  const auto scene = floorWithTwoBoxes();
  const auto thesis = thesisOptions();
  EXPECT_EQ(thesis.partition, Segmentation::Partition::FelzenszwalbHuttenlocher);
  EXPECT_EQ(thesis.min_segment_size, 3u);
  EXPECT_FLOAT_EQ(thesis.graph_scale, 3);
  Segmentation segmentation;
  segmentation.setOptions(thesis);
  segmentation.setInputCloud(cloudOf(scene.points));
  segmentation.setViewPoint(2, 1, 3);
  Labels labels;
  segmentation.segment(labels);
  EXPECT_TRUE(segmentation.getStructureIndices().empty());
  auto wrong = thesis;
  wrong.max_union_air = -1;
  segmentation.setOptions(wrong);
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
  EXPECT_EQ(labels, segmented(cloudOf(scene.points)));
}
