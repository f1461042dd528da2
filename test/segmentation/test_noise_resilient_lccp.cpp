/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/objects/segmented_scene.h"

#include "objects/object_steps.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

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
  const auto& voxels = stepsOf(segmentation.getResult()).scene.voxels;
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
  auto options = segmentation.getOptions();
  options.pieces.joining_level = 1; // joining might mend it
  segmentation.setOptions(options);
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
  const auto labels = segmentedObjects(cloudOf(scene.points));
  ASSERT_EQ(labels.size(), scene.points.size());
  EXPECT_EQ(labels, renamed(labels));
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
  const auto labels = segmentedObjects(cloud);
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
  EXPECT_EQ(of_chosen, segmentedObjects(cloudOf(chosen)));
}

TEST(NoiseResilientLCCP, LeavesOnlyPointsThatAreNotFinite)
{
  const auto scene = floorWithTwoBoxes();
  const auto cloud = cloudOf(scene.points);
  cloud->is_dense = false;
  for (std::size_t i = 0; i < cloud->size(); i += 7)
    (*cloud)[i].y = std::numeric_limits<float>::quiet_NaN();
  const auto labels = segmentedObjects(cloud);
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
  segmentation.setNumberOfThreads(4000000000u); // far more than there can be
  segmentation.segment(parallel);
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
  const auto labels = segmentedObjects(cloudOf(scene.points));
  const auto other = segmentedObjects(cloudOf(shuffled));
  Labels back(labels.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    back[order[i]] = other[i];
  // Rounding of sums may move single points.
  EXPECT_GT(agreement(labels, back), 0.99);
}

TEST(NoiseResilientLCCP, WhatIsTooSmallToBeToldIsOneRemainder)
{
  auto scene = floorWithTwoBoxes();
  const auto scene_size = scene.points.size();
  std::mt19937 rng(5);
  for (const float x : {0.9f, 1.3f, 1.7f}) // patches of 9 voxels in the air
    scene.addRectangle(
        {x, 0.2f, 2}, {0.09f, 0, 0}, {0, 0.09f, 0}, {0, 0, 1}, 7, 0.01f, 0, rng);
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  Labels labels;
  segmentation.segment(labels);
  const auto structure = segmentation.getStructure();
  const auto remainder = static_cast<std::uint32_t>(StructureKind::Remainder);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    EXPECT_EQ(structure[i] == remainder, i >= scene_size);
    if (i >= scene_size) {
      EXPECT_EQ(labels[i], labels[scene_size]);
    }
  }
  segmentation.setPartition(Segmentation::Partition::Lccp); // knows no remainder
  segmentation.segment(labels);
  for (const auto kind : segmentation.getStructure())
    EXPECT_NE(kind, remainder);
}

TEST(NoiseResilientLCCP, FewPointsAreTheRemainder)
{
  auto scene = floorWithTwoBoxes();
  const auto scene_size = scene.points.size();
  std::mt19937 rng(5); // a patch of 25 voxels, more than a supervoxel, of 64 points
  scene.addRectangle(
      {0.9f, 0.2f, 2}, {0.16f, 0, 0}, {0, 0.16f, 0}, {0, 0, 1}, 7, 0.02f, 0, rng);
  const auto count = scene.points.size() - scene_size;
  ASSERT_GT(count, 50u);
  ASSERT_LT(count, 100u);
  const auto remainder = static_cast<std::uint32_t>(StructureKind::Remainder);
  const auto kindOfPatch = [&](std::uint32_t fewest_points) {
    Segmentation segmentation;
    EXPECT_EQ(segmentation.getFewestPoints(), 100u);
    segmentation.setFewestPoints(fewest_points);
    segmentation.setInputCloud(cloudOf(scene.points));
    Labels labels;
    segmentation.segment(labels);
    return segmentation.getStructure().back();
  };
  EXPECT_EQ(kindOfPatch(100), remainder);
  EXPECT_EQ(kindOfPatch(static_cast<std::uint32_t>(count) + 1), remainder);
  EXPECT_EQ(kindOfPatch(static_cast<std::uint32_t>(count)), 0u);
  EXPECT_EQ(kindOfPatch(0), 0u);
}

TEST(NoiseResilientLCCP, TheFirstPointIsLikeAllOthers)
{
  auto points = floorWithTwoBoxes().points;
  for (auto& point : points)
    point += Eigen::Vector3f(71.3f, 33.7f, 5.1f);
  const auto voxelsOf = [](const std::vector<Eigen::Vector3f>& cloud) {
    Segmentation segmentation;
    segmentation.setInputCloud(cloudOf(cloud));
    Labels labels;
    segmentation.segment(labels);
    return stepsOf(segmentation.getResult()).scene.voxels.cells.keys;
  };
  const auto voxels = voxelsOf(points);
  EXPECT_GT(voxels.size(), 100u);
  for (const std::size_t other : {std::size_t{17}, points.size() / 2}) {
    auto swapped = points;
    std::swap(swapped[0], swapped[other]);
    EXPECT_EQ(voxelsOf(swapped), voxels);
  }
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
  EXPECT_NEAR(
      stepsOf(segmentation.getResult()).scene.voxel_size, 0.125, 0.02); // 2.5 spacings
  EXPECT_EQ(scoreDetections(countOverlaps(scene.objects, labels)).right_count, 3u);
  segmentation.setVoxelResolution(0.03); // what is given holds
  segmentation.segment(labels);
  EXPECT_NEAR(stepsOf(segmentation.getResult()).scene.voxel_size, 0.03, 1e-6);
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
  EXPECT_LT(stepsOf(segmentation.getResult()).scene.voxel_size, 0.02)
      << "of a single view, as nothing was chosen";
  segmentation.setVoxelResolution(0.02);
  segmentation.segment(output);
  EXPECT_DOUBLE_EQ(stepsOf(segmentation.getResult()).scene.voxel_size, 0.02);
}

TEST(NoiseResilientLCCP, NormalsThatAreNoneAreEstimated)
{
  const auto scene = roomWithTwoBoxes();
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  Labels expected;
  segmentation.segment(expected);
  const auto normals = normalsOf(scene);
  for (const Eigen::Vector3f& none : {Eigen::Vector3f(0, 0, 0),
                                      Eigen::Vector3f(0.4f, 0.6f, 0.5f),
                                      Eigen::Vector3f(0, 0, 1)}) {
    const auto changed = pcl::make_shared<pcl::PointCloud<pcl::Normal>>(*normals);
    for (auto& normal : *changed)
      normal.getNormalVector3fMap() = none;
    segmentation.setInputNormals(changed);
    Labels labels;
    segmentation.segment(labels);
    EXPECT_EQ(labels, expected) << none.transpose();
  }
}

TEST(NoiseResilientLCCP, AFewBadNormalsDoNoHarm)
{
  const auto scene = roomWithTwoBoxes();
  const auto normals = normalsOf(scene);
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  for (const float length : {0.0f, 1e6f, std::numeric_limits<float>::quiet_NaN()}) {
    const auto changed = pcl::make_shared<pcl::PointCloud<pcl::Normal>>(*normals);
    for (std::size_t i = 0; i < changed->size(); i += 40)
      (*changed)[i].getNormalVector3fMap().setConstant(length);
    segmentation.setInputNormals(changed);
    Labels labels;
    segmentation.segment(labels);
    EXPECT_EQ(scoreDetections(countOverlaps(scene.objects, labels)).right_count, 8u)
        << length;
  }
}
