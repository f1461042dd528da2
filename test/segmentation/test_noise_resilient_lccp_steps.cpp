/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/objects/segmented_scene.h"

#include "objects/object_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

/** Segments without joining pieces, or up to another level. */
Labels
piecesFrom(const Eigen::Vector3f& viewpoint,
           const LabelledPoints& scene,
           float joining_level = 1)
{
  Segmentation segmentation;
  auto options = segmentation.getOptions();
  options.pieces.joining_level = joining_level;
  segmentation.setOptions(options);
  segmentation.setInputCloud(cloudOf(scene.points));
  segmentation.setViewPoint(viewpoint.x(), viewpoint.y(), viewpoint.z());
  Labels labels;
  segmentation.segment(labels);
  return labels;
}

SegmentationErrors
errorsOf(const LabelledPoints& scene, const Labels& labels)
{
  return richtsfeldErrors(countOverlaps(scene.objects, labels));
}

} // namespace

TEST(NoiseResilientLCCPSteps, PartsABookFromTheBoxThatItLiesOn)
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
  const auto labels = piecesFrom({2, 1, 3}, scene);
  const auto errors = errorsOf(scene, labels);
  EXPECT_LT(errors.over, 0.06);
  EXPECT_LT(errors.under, 0.02);
}

TEST(NoiseResilientLCCPSteps, PartsBoxesAtANarrowGap)
{
  LabelledPoints scene;
  std::mt19937 rng(7);
  scene.addBox({0, 0, 0}, {0.8f, 0.5f, 0.7f}, 1, 0.012f, 0.003f, rng);
  scene.addBox({0.83f, 0, 0}, {0.8f, 0.5f, 0.7f}, 2, 0.012f, 0.003f, rng);
  scene.removeIf([](const Eigen::Vector3f& p) { // not seen
    return p.x() > 0.79f && p.x() < 0.84f && p.y() > 0.02f && p.y() < 0.48f &&
           p.z() < 0.68f;
  });
  const auto labels = piecesFrom({0.8f, -1, 2}, scene);
  EXPECT_LT(errorsOf(scene, labels).under, 0.01);
}

TEST(NoiseResilientLCCPSteps, KeepsFloorCeilingAndWallsOutOfTheGraph)
{
  const auto scene = roomWithTwoBoxes();
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  Labels labels;
  segmentation.segment(labels);
  const auto planes = [&] {
    const auto& of_voxels = stepsOf(segmentation.getResult()).scene.plane_of_voxel;
    return of_voxels.empty() ? 0
                             : *std::max_element(of_voxels.begin(), of_voxels.end());
  };
  EXPECT_EQ(planes(), 6u);
  std::size_t of_boxes = 0;
  const auto structure = segmentation.getStructureIndices();
  for (const auto index : structure)
    of_boxes += scene.objects[index] == 2 || scene.objects[index] == 3;
  EXPECT_LT(of_boxes, structure.size() / 50);
  segmentation.setJoiningScale(JoiningScale::View);
  segmentation.setVoxelResolution(0.03);
  segmentation.segment(labels);
  EXPECT_EQ(planes(), 0u);
  EXPECT_TRUE(segmentation.getStructureIndices().empty());
}

TEST(NoiseResilientLCCPSteps, JoinsThePiecesUpToItsLevel)
{
  const auto scene = roomWithTwoBoxes();
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  auto options = segmentation.getOptions();
  Labels pieces;
  std::size_t most = 0;
  for (const float level : {0.0f, 0.3f, 0.7f, 1.0f}) {
    options.pieces.joining_level = level;
    segmentation.setOptions(options);
    Labels labels;
    segmentation.segment(labels);
    const auto& result = segmentation.getResult();
    ASSERT_EQ(result.piece_of_point.size(), scene.points.size());
    if (pieces.empty())
      pieces = result.piece_of_point;
    EXPECT_EQ(result.piece_of_point, pieces) << "the level has no influence on them";
    const auto joined = segmentsAtLevel(result, level);
    const auto count = std::set<std::uint32_t>(joined.begin(), joined.end()).size();
    EXPECT_GE(count, most) << "higher levels join less";
    most = count;
    Labels expected;
    for (const auto piece : pieces)
      expected.push_back(joined[piece] + 1);
    EXPECT_GT(agreement(expected, labels), 0.95); // bodies may be cut afterwards
  }
  const auto& steps = stepsOf(segmentation.getResult());
  for (const auto index : segmentation.getStructureIndices())
    EXPECT_EQ(steps.pieces.pieces[pieces[index]].positions.count, 0)
        << "the planes' have no voxels";
}

TEST(NoiseResilientLCCPSteps, OtherPartitionsHaveNoPieces)
{
  const auto scene = floorWithTwoBoxes();
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(scene.points));
  for (const auto partition : {Partition::Lccp, Partition::FelzenszwalbHuttenlocher}) {
    segmentation.setPartition(partition);
    Labels labels;
    segmentation.segment(labels);
    EXPECT_EQ(labels.size(), scene.points.size());
    EXPECT_TRUE(segmentation.getResult().piece_of_point.empty());
    EXPECT_TRUE(stepsOf(segmentation.getResult()).pieces.pieces.empty());
    EXPECT_TRUE(segmentation.getResult().joins.empty());
  }
}
