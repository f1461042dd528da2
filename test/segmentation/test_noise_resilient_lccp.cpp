/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/object_scene.h"

#include <pcl/segmentation/noise_resilient_lccp.h>
#include <pcl/segmentation/segmentation_metrics.h>

#include <gtest/gtest.h>

#include <limits>

using namespace pcl::indoor;
using pcl::indoor::test::floorWithTwoBoxes;
using Labels = std::vector<std::uint32_t>;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Segmentation = pcl::NoiseResilientLCCP<pcl::PointXYZ>;

Cloud::Ptr
cloudOf(const std::vector<Eigen::Vector3f>& points)
{
  Cloud::Ptr cloud(new Cloud);
  for (const auto& point : points)
    cloud->emplace_back(point.x(), point.y(), point.z());
  return cloud;
}

Labels
segmented(const Cloud::ConstPtr& cloud)
{
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setViewPoint(2, 1, 3);
  Labels labels;
  segmentation.segment(labels);
  return labels;
}

pcl::PointCloud<pcl::Normal>::Ptr
normalsOf(const test::LabelledPoints& scene)
{
  const pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  for (const auto& normal : scene.normals)
    normals->emplace_back(normal.x(), normal.y(), normal.z());
  return normals;
}

/** A closed room around the boxes, each wall an object of its own. */
test::LabelledPoints
roomWithTwoBoxes()
{
  auto scene = floorWithTwoBoxes();
  std::mt19937 rng(8);
  const Eigen::Vector3f x(4, 0, 0), y(0, 2.5f, 0), z(0, 0, 2.4f);
  const auto add = [&](const Eigen::Vector3f& corner,
                       const Eigen::Vector3f& u,
                       const Eigen::Vector3f& v,
                       const Eigen::Vector3f& normal,
                       std::uint32_t object) {
    scene.addRectangle(corner, u, v, normal, object, 0.015f, 0.003f, rng);
  };
  add(z, x, y, {0, 0, -1}, 4);
  add({0, 0, 0}, x, z, {0, 1, 0}, 5);
  add(y, x, z, {0, -1, 0}, 6);
  add({0, 0, 0}, y, z, {1, 0, 0}, 7);
  add(x, y, z, {-1, 0, 0}, 8);
  return scene;
}

double
agreement(const Labels& truth, const Labels& labels)
{
  return adjustedRandIndex(countOverlaps(truth, labels));
}

} // namespace

TEST(NoiseResilientLCCP, FindsTwoBoxesOnTheFloor)
{
  const auto scene = floorWithTwoBoxes();
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  segmentation.setInputNormals(normalsOf(scene));
  Labels labels;
  segmentation.segment(labels);
  const auto overlaps = countOverlaps(scene.objects, labels);
  EXPECT_EQ(scoreDetections(overlaps).right_count, 3u);
  // Points within a voxel of the creases may go to either side: 2 x 3.2 m of 3 cm.
  EXPECT_LT(richtsfeldErrors(overlaps).over, 0.03);
  EXPECT_LT(richtsfeldErrors(overlaps).under, 0.03);
}

TEST(NoiseResilientLCCP, TurnsNormalsIntoARoomByItself)
{
  const auto scene = roomWithTwoBoxes();
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  Labels labels;
  segmentation.segment(labels);
  const auto& voxels = segmentation.getResult().voxels;
  std::size_t right = 0;
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    right += voxels.normals[voxels.cells.cell_of_point[i]].dot(scene.normals[i]) > 0;
  EXPECT_GT(static_cast<double>(right),
            0.97 * static_cast<double>(scene.points.size()));
  EXPECT_EQ(scoreDetections(countOverlaps(scene.objects, labels)).right_count, 8u);
}

TEST(NoiseResilientLCCP, FindsThemByTheOtherPartitionsToo)
{
  using Partition = Segmentation::Partition;
  const auto scene = floorWithTwoBoxes();
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  segmentation.setInputNormals(normalsOf(scene));
  for (const auto partition : {Partition::Lccp, Partition::FelzenszwalbHuttenlocher}) {
    segmentation.setPartition(partition);
    Labels labels;
    segmentation.segment(labels);
    EXPECT_EQ(scoreDetections(countOverlaps(scene.objects, labels)).right_count, 3u);
  }
}

TEST(NoiseResilientLCCP, UsesGivenNormals)
{
  const auto scene = floorWithTwoBoxes();
  const auto normals = normalsOf(scene);
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  segmentation.setInputNormals(normals);
  Labels labels;
  segmentation.segment(labels);
  EXPECT_EQ(scoreDetections(countOverlaps(scene.objects, labels)).right_count, 3u);
  for (auto& normal : *normals) // from inside, the creases are convex
    normal.getNormalVector3fMap() *= -1;
  segmentation.segment(labels);
  EXPECT_LT(scoreDetections(countOverlaps(scene.objects, labels)).right_count, 3u);
}

TEST(NoiseResilientLCCP, LabelsCountFromOneInTheOrderOfThePoints)
{
  const auto scene = floorWithTwoBoxes();
  const auto labels = segmented(cloudOf(scene.points));
  ASSERT_EQ(labels.size(), scene.points.size());
  EXPECT_EQ(labels, test::renamed(labels));
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 0u), 0);
}

TEST(NoiseResilientLCCP, LabelledCloudHasInputsCoordinatesAndHeader)
{
  const auto scene = floorWithTwoBoxes();
  const auto cloud = cloudOf(scene.points);
  cloud->header.frame_id = "room";
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setViewPoint(2, 1, 3);
  pcl::PointCloud<pcl::PointXYZL> output;
  segmentation.segment(output);
  ASSERT_EQ(output.size(), cloud->size());
  EXPECT_EQ(output.header.frame_id, "room");
  const auto labels = segmented(cloud);
  for (std::size_t i = 0; i < output.size(); ++i) {
    ASSERT_EQ(output[i].getVector3fMap(), (*cloud)[i].getVector3fMap());
    ASSERT_EQ(output[i].label, labels[i]);
  }
}

TEST(NoiseResilientLCCP, SegmentsOnlyTheIndices)
{
  const auto scene = floorWithTwoBoxes();
  const auto cloud = cloudOf(scene.points);
  const pcl::IndicesPtr indices(new pcl::Indices);
  std::vector<Eigen::Vector3f> chosen;
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    if (scene.objects[i] != 3) {
      indices->push_back(static_cast<pcl::index_t>(i));
      chosen.push_back(scene.points[i]);
    }
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setIndices(indices);
  segmentation.setViewPoint(2, 1, 3);
  Labels labels, of_chosen;
  segmentation.segment(labels);
  ASSERT_EQ(labels.size(), scene.points.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    ASSERT_EQ(labels[i] == 0, scene.objects[i] == 3);
    if (labels[i] != 0)
      of_chosen.push_back(labels[i]);
  }
  EXPECT_EQ(of_chosen, segmented(cloudOf(chosen)));
}

TEST(NoiseResilientLCCP, LeavesOnlyPointsThatAreNotFinite)
{
  const auto scene = floorWithTwoBoxes();
  const auto cloud = cloudOf(scene.points);
  cloud->is_dense = false;
  for (std::size_t i = 0; i < cloud->size(); i += 7)
    (*cloud)[i].y = std::numeric_limits<float>::quiet_NaN();
  const auto labels = segmented(cloud);
  ASSERT_EQ(labels.size(), cloud->size());
  for (std::size_t i = 0; i < labels.size(); ++i)
    ASSERT_EQ(labels[i] == 0, i % 7 == 0);
}

TEST(NoiseResilientLCCP, IsTheSameTwiceAndForAnyNumberOfThreads)
{
  const auto cloud = cloudOf(floorWithTwoBoxes(0.008f).points);
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  Labels first, second, parallel;
  segmentation.setNumberOfThreads(1);
  segmentation.segment(first);
  segmentation.segment(second);
  segmentation.setNumberOfThreads(2);
  segmentation.segment(parallel);
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(first, second);
  EXPECT_EQ(first, parallel);
}

TEST(NoiseResilientLCCP, OrderOfPointsChangesOnlyNames)
{
  const auto scene = floorWithTwoBoxes();
  std::mt19937 rng(11);
  const auto order = test::shuffledOrder(scene.points.size(), rng);
  std::vector<Eigen::Vector3f> shuffled;
  for (const auto i : order)
    shuffled.push_back(scene.points[i]);
  const auto labels = segmented(cloudOf(scene.points));
  const auto other = segmented(cloudOf(shuffled));
  Labels back(labels.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    back[order[i]] = other[i];
  // Rounding of sums and of the local frame may move single points between voxels.
  EXPECT_GT(agreement(labels, back), 0.99);
}

TEST(NoiseResilientLCCP, IsAccurateFarFromTheOrigin)
{
  const auto scene = floorWithTwoBoxes();
  auto far = scene.points;
  for (auto& point : far)
    point += Eigen::Vector3f(4096, 8192, 0); // floats resolve 1 mm here
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(far));
  segmentation.setInputNormals(normalsOf(scene));
  Labels labels;
  segmentation.segment(labels);
  EXPECT_EQ(scoreDetections(countOverlaps(scene.objects, labels)).right_count, 3u);
}

TEST(NoiseResilientLCCP, RaisesItsVoxelsForSparseClouds)
{
  const auto scene = floorWithTwoBoxes(0.002f, 0.05f);
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  segmentation.setInputNormals(normalsOf(scene));
  Labels labels;
  segmentation.segment(labels);
  EXPECT_NEAR(segmentation.getResult().voxel_size, 0.125, 0.02); // 2.5 spacings
  EXPECT_EQ(scoreDetections(countOverlaps(scene.objects, labels)).right_count, 3u);
  auto options = segmentation.getOptions();
  options.adapt_to_resolution = false;
  segmentation.setOptions(options);
  segmentation.segment(labels);
  EXPECT_LT(scoreDetections(countOverlaps(scene.objects, labels)).right_count, 3u);
}

TEST(NoiseResilientLCCP, OrganisedCloudsAreSeenFromTheirSensor)
{
  // A wall at 2 m and a box in front of it, as a camera along z sees them.
  const Cloud::Ptr cloud(new Cloud(160, 120));
  Labels truth;
  for (int v = 0; v < 120; ++v)
    for (int u = 0; u < 160; ++u) {
      const bool box = u > 40 && u < 100 && v > 40 && v < 90;
      const float depth = box ? 1.2f : 2.0f;
      const float scale = depth / 140;
      cloud->at(u, v) = pcl::PointXYZ(static_cast<float>(u - 80) * scale,
                                      static_cast<float>(v - 60) * scale,
                                      depth);
      truth.push_back(box ? 1 : 2);
    }
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  pcl::PointCloud<pcl::PointXYZL> output;
  segmentation.segment(output);
  EXPECT_EQ(output.width, 160u);
  EXPECT_EQ(output.height, 120u);
  Labels labels;
  for (const auto& point : output)
    labels.push_back(point.label);
  EXPECT_EQ(agreement(truth, labels), 1);
}

TEST(NoiseResilientLCCP, SmallInputs)
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

TEST(NoiseResilientLCCP, IntermediateResultsFitTogether)
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
  EXPECT_EQ(without, removed.size());
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

TEST(NoiseResilientLCCP, GivesNothingForWrongUse)
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

TEST(NoiseResilientLCCP, DefaultsAreAsDocumented)
{
  const Segmentation segmentation;
  EXPECT_DOUBLE_EQ(segmentation.getVoxelResolution(), 0.03);
  EXPECT_DOUBLE_EQ(segmentation.getSeedResolution(), 0.12);
  EXPECT_FLOAT_EQ(segmentation.getCurvatureThreshold(), 0.03f);
  EXPECT_FLOAT_EQ(segmentation.getRatioThreshold(), 0.2f);
  EXPECT_FLOAT_EQ(segmentation.getGraphScale(), 3);
  EXPECT_FLOAT_EQ(segmentation.getBendThreshold(), 23);
  EXPECT_EQ(segmentation.getMinSegmentSize(), 6u);
  EXPECT_FLOAT_EQ(segmentation.getConcavityToleranceThreshold(), 10);
  EXPECT_EQ(segmentation.getPartition(), Segmentation::Partition::Graph);
  EXPECT_FALSE(segmentation.getInputNormals());
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
