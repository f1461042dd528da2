/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/labelled_points.h"

#include "objects/split/object_gaps.h"
#include "segmentation/objects/scene_of_points.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

/** Bookcases of 0.8 m side by side (objects 1, 2 ...) with gaps between them. */
LabelledPoints
bookcases(int count, float gap, float noise = 0.003f)
{
  LabelledPoints scene;
  std::mt19937 rng(3);
  for (int i = 0; i < count; ++i)
    scene.addBox({static_cast<float>(i) * (0.8f + gap), 0, 0},
                 {0.8f, 0.35f, 1.8f},
                 static_cast<std::uint32_t>(i + 1),
                 0.015f,
                 noise,
                 rng);
  return scene;
}

Eigen::Matrix3f
aboutTheVertical(float angle)
{
  return Eigen::AngleAxisf(angle, Eigen::Vector3f::UnitZ()).toRotationMatrix();
}

/** All points of one segment in the input. */
std::vector<std::uint32_t>
partedAtGaps(const ObjectScene& scene, bool leave_out = false)
{
  std::vector<std::uint32_t> labels(scene.points.size(), 1);
  partAtGaps(scene, std::vector<std::uint8_t>(scene.points.size(), leave_out), labels);
  return labels;
}

std::vector<std::uint32_t>
partedAtGaps(const LabelledPoints& labelled)
{
  return partedAtGaps(sceneOfPoints(labelled.points, 0.03));
}

TEST(ObjectGaps, PartsBookcasesWhicheverWayTheyStand)
{
  for (const float angle : {0.0f, 0.4f, 1.3f, 2.9f}) {
    auto scene = bookcases(3, 0.04f);
    scene.turn(aboutTheVertical(angle));
    EXPECT_EQ(renamed(partedAtGaps(scene)), renamed(scene.objects)) << angle;
  }
}

TEST(ObjectGaps, PartsBodiesWhoseSidesHoldMostPoints)
{
  LabelledPoints scene;
  std::mt19937 rng(9);
  const auto random = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(rng() % 1001) / 1000;
  };
  for (const std::uint32_t object : {1u, 2u}) {
    const float x = object == 1 ? 0 : 1.44f;
    for (int i = 0; i < 4000; ++i) // the front
      scene.points.emplace_back(random(x, x + 1.4f), random(0, 0.01f), random(0, 1.7f));
    for (const float side : {0.0f, 0.02f, 1.38f, 1.4f}) // seen from both sides
      for (int i = 0; i < 1600; ++i)
        scene.points.emplace_back(
            x + side + random(-0.005f, 0.005f), random(0, 0.6f), random(0, 1.7f));
    scene.objects.resize(scene.points.size(), object);
  }
  EXPECT_EQ(renamed(partedAtGaps(sceneOfPoints(scene.points, 0.05))),
            renamed(scene.objects));
}

TEST(ObjectGaps, LeavesWhatTouchesWhole)
{
  EXPECT_EQ(segmentCount(partedAtGaps(bookcases(2, 0.002f))), 1u);
  EXPECT_EQ(segmentCount(partedAtGaps(bookcases(1, 0))), 1u);
}

TEST(ObjectGaps, LeavesWhatIsBridgedWhole)
{
  LabelledPoints scene;
  std::mt19937 rng(4);
  for (const float x : {0.0f, 0.84f})
    scene.addRectangle( // two doors
        {x, 0, 0},
        {0.8f, 0, 0},
        {0, 0, 1.8f},
        {0, -1, 0},
        1,
        0.01f,
        0.003f,
        rng);
  EXPECT_EQ(segmentCount(partedAtGaps(scene)), 2u);
  scene.addRectangle( // and what is below them
      {0, 0, -1.8f},
      {1.64f, 0, 0},
      {0, 0, 1.8f},
      {0, -1, 0},
      1,
      0.01f,
      0.003f,
      rng);
  EXPECT_EQ(segmentCount(partedAtGaps(scene)), 1u);
}

TEST(ObjectGaps, LeavesTheLinesOfAScannerTogether)
{
  for (const float distance : {0.016f, 0.02f, 0.025f, 0.03f, 0.04f, 0.05f, 0.06f}) {
    LabelledPoints lines;
    for (int line = 0; line < 30; ++line)
      for (int i = 0; i < 400; ++i)
        lines.points.emplace_back(
            static_cast<float>(line) * distance, 0.0f, static_cast<float>(i) * 0.005f);
    EXPECT_EQ(segmentCount(partedAtGaps(lines)), 1u) << distance;
  }
}

/** Rings on the floor around a scanner, so far apart, with so many points per metre. */
LabelledPoints
rings(float distance, float per_metre)
{
  constexpr float arc = 0.3f;
  LabelledPoints floor;
  for (int ring = 0; ring < 20; ++ring) {
    const float radius = 1 + distance * static_cast<float>(ring);
    const int count = static_cast<int>(radius * arc * per_metre);
    for (int i = 0; i <= count; ++i) {
      const float angle = arc * static_cast<float>(i) / static_cast<float>(count);
      floor.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
  }
  return floor;
}

TEST(ObjectGaps, LeavesTheRingsOfAScannerTogether)
{
  for (const float distance : {0.035f, 0.045f, 0.06f})
    for (const float per_metre : {33.0f, 50.0f, 100.0f})
      EXPECT_EQ(segmentCount(partedAtGaps(rings(distance, per_metre))), 1u)
          << distance << " m, " << per_metre << " per metre";
}

/** Slices of a quarter of a gap's width along x, with so many points each. */
LabelledPoints
rowOfSlices(const std::vector<int>& counts)
{
  LabelledPoints scene;
  scene.points.emplace_back(0, 0, 0); // where the first slice begins
  for (std::size_t slice = 0; slice < counts.size(); ++slice)
    for (int i = 0; i < counts[slice]; ++i)
      scene.points.emplace_back(0.00375f * (static_cast<float>(slice) + 0.5f),
                                0.01f * static_cast<float>(i),
                                0);
  return scene;
}

/** Eight slices of ten points on each side of a gap that holds a few. */
LabelledPoints
rowWithGap(int in_gap)
{
  std::vector<int> counts(20, 10);
  std::fill(counts.begin() + 8, counts.begin() + 12, 0);
  counts[9] = in_gap;
  return rowOfSlices(counts);
}

TEST(ObjectGaps, NeedsFewPointsInTheGapForTheirChance)
{
  // 40 are expected: a quarter of them, less k, less twice the root of k + 1
  EXPECT_EQ(segmentCount(partedAtGaps(rowWithGap(0))), 2u);
  EXPECT_EQ(segmentCount(partedAtGaps(rowWithGap(5))), 2u); // 10 - 5 - 4.90
  EXPECT_EQ(segmentCount(partedAtGaps(rowWithGap(6))), 1u); // 10 - 6 - 5.29
}

TEST(ObjectGaps, MustBeWiderThanOtherEmptyStretches)
{
  // Two, then three slices are empty beside the four of the gap.
  std::vector<int> counts = {20, 20, 20, 0,  0,  20, 20, 20, 0,  0,
                             0,  0,  9,  20, 20, 20, 20, 20, 20, 20};
  EXPECT_EQ(segmentCount(partedAtGaps(rowOfSlices(counts))), 2u);
  counts[2] = 0;
  EXPECT_EQ(segmentCount(partedAtGaps(rowOfSlices(counts))), 1u);
}

TEST(ObjectGaps, FollowsTheDirectionUp)
{
  auto scene = bookcases(2, 0.04f);
  const Eigen::Matrix3f rotation =
      Eigen::AngleAxisf(1.1f, Eigen::Vector3f(2, -1, 1).normalized())
          .toRotationMatrix();
  scene.turn(rotation);
  EXPECT_EQ(segmentCount(partedAtGaps(scene)), 1u);
  auto upright = sceneOfPoints(scene.points, 0.03);
  upright.up = rotation * Eigen::Vector3f::UnitZ();
  EXPECT_EQ(renamed(partedAtGaps(upright)), renamed(scene.objects));
}

TEST(ObjectGaps, KeepsOtherSegmentsAndPointsThatAreLeftOut)
{
  const auto labelled = bookcases(2, 0.04f);
  const auto scene = sceneOfPoints(labelled.points, 0.03);
  EXPECT_EQ(segmentCount(partedAtGaps(scene, true)), 1u);
  auto labels = labelled.objects; // 1 and 2
  partAtGaps(scene, std::vector<std::uint8_t>(labels.size(), 0), labels);
  EXPECT_EQ(labels, labelled.objects);
}

TEST(ObjectGaps, DependsNeitherOnTheOrderNorOnThreads)
{
  const auto scene = bookcases(4, 0.04f);
  std::mt19937 rng(8);
  const auto order = shuffledOrder(scene.points.size(), rng);
  auto with_threads = sceneOfPoints(scene.points, 0.03);
  with_threads.threads = 1;
  const auto labels = partedAtGaps(with_threads),
             other = partedAtGaps(scene.reordered(order));
  for (std::size_t i = 0; i < order.size(); ++i)
    ASSERT_EQ(other[i], labels[order[i]]);
  with_threads.threads = 3;
  EXPECT_EQ(partedAtGaps(with_threads), labels);
}

TEST(ObjectGaps, BearsPointsThatAreFewOrEqual)
{
  LabelledPoints scene;
  EXPECT_TRUE(partedAtGaps(scene).empty());
  scene.points.assign(1000, {1, 2, 3});
  EXPECT_EQ(segmentCount(partedAtGaps(scene)), 1u);
  scene.points.assign(1, {1, 2, 3});
  EXPECT_EQ(segmentCount(partedAtGaps(scene)), 1u);
}

TEST(ObjectGaps, LeavesWhatReachesTooFarWhole)
{
  auto scene = bookcases(2, 0.04f);
  EXPECT_EQ(segmentCount(partedAtGaps(scene)), 2u);
  for (const float far : {1e5f, 1e9f}) {
    scene.points.emplace_back(far, 0, 0);
    auto wide = sceneOfPoints(scene.points, 1e4);
    wide.voxel_size = 0.03;
    EXPECT_EQ(segmentCount(partedAtGaps(wide)), 1u) << far;
  }
}

} // namespace
