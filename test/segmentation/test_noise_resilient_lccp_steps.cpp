/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/segmented_scene.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
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
  const float width = 3 * std::cos(static_cast<float>(M_PI) / 6);
  scene.addRoomSide({0, 0, 0}, {width, 0, 0}, {0, 4, 0}, {0, 0, 1}, 3, rng);
  scene.removeIf([](const Eigen::Vector3f& p) { // of the floor, what is behind the wall
    return p.z() < 0.05f &&
           p.y() < std::tan(static_cast<float>(M_PI) / 6) * p.x() - 0.05f;
  });
  scene.addRoomSide({0, 0, 0}, {0, 4, 0}, {0, 0, 2.5f}, {1, 0, 0}, 4, rng);
  scene.addRoomSide({0, 4, 0}, {width, 0, 0}, {0, 0, 2.5f}, {0, -1, 0}, 5, rng);
}

/** A room of 3 m x 3 m (4, 5, 6) before a wall along x (1). */
LabelledPoints
roomBeforeWall()
{
  LabelledPoints scene;
  std::mt19937 rng(11);
  const Eigen::Vector3f x(3, 0, 0), y(0, 3, 0), z(0, 0, 2.5f);
  scene.addRoomSide({0, 0, 0}, x, z, {0, 1, 0}, 1, rng);
  scene.addRoomSide({0, 0, 0}, x, y, {0, 0, 1}, 4, rng);
  scene.addRoomSide({0, 0, 0}, y, z, {1, 0, 0}, 5, rng);
  scene.addRoomSide(x, y, z, {-1, 0, 0}, 6, rng);
  return scene;
}

/** The room with two leaves (2, 3) in the wall, closed boxes 1.2 m high that stand
 * against each other, that far into the room. */
LabelledPoints
leavesInWall(float into_room)
{
  auto scene = roomBeforeWall();
  std::mt19937 rng(11);
  scene.removeIf([](const Eigen::Vector3f& p) {
    return p.y() < 0.05f && p.x() > 0.9f && p.x() < 2.1f && p.z() > 0.6f &&
           p.z() < 1.8f;
  });
  for (const std::uint32_t leaf : {2u, 3u})
    scene.addBox({leaf == 2 ? 0.9f : 1.505f, into_room - 0.19f, 0.6f},
                 {0.6f, 0.19f, 1.2f},
                 leaf,
                 0.012f,
                 0.003f,
                 rng);
  return scene;
}

/** The room with a door (2) in the wall, whose leaf stands open. */
LabelledPoints
openDoor()
{
  auto scene = roomBeforeWall();
  std::mt19937 rng(13);
  const auto add = [&](const Eigen::Vector3f& low, const Eigen::Vector3f& size) {
    scene.addBox(low, size, 2, 0.012f, 0.003f, rng);
  };
  scene.removeIf([](const Eigen::Vector3f& p) {
    return p.y() < 0.05f && p.x() > 1 && p.x() < 2 && p.z() < 2.06f;
  });
  add({1, -0.12f, 0}, {0.06f, 0.15f, 2});
  add({1.94f, -0.12f, 0}, {0.06f, 0.15f, 2});
  add({1, -0.12f, 2}, {1, 0.15f, 0.06f});
  add({1.02f, 0.03f, 0.01f}, {0.04f, 0.88f, 1.99f});
  return scene;
}

/** A cupboard (1) whose front is cut in two by the shadow of a box (2) before it, with
 * nothing inside. */
LabelledPoints
cupboardInShadow()
{
  LabelledPoints scene;
  std::mt19937 rng(12);
  scene.addBox({0, 0, 0}, {1.5f, 0.5f, 0.7f}, 1, 0.012f, 0.003f, rng);
  scene.removeIf([](const Eigen::Vector3f& p) {
    return (p.x() > 0.7f && p.x() < 0.95f) || p.y() > 0.49f;
  });
  scene.addBox({0.65f, -0.6f, 0}, {0.3f, 0.3f, 0.7f}, 2, 0.012f, 0.003f, rng);
  return scene;
}

/** A column (2) of 0.5 m that a beam (1) of 6.5 m x 0.4 m x 0.4 m runs through. */
LabelledPoints
beamThroughColumn()
{
  LabelledPoints scene;
  std::mt19937 rng(12);
  scene.addBox({0, 0.05f, 2.6f}, {6.5f, 0.4f, 0.4f}, 1, 0.015f, 0.003f, rng);
  scene.removeIf([](const Eigen::Vector3f& p) { return p.x() > 3 && p.x() < 3.5f; });
  scene.addBox({3, 0, 0}, {0.5f, 0.5f, 3.3f}, 2, 0.015f, 0.003f, rng);
  return scene;
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

/** Sets the scene as input. */
Labels
segmentedFrom(const Eigen::Vector3f& viewpoint,
              const LabelledPoints& scene,
              Segmentation& segmentation)
{
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
  Segmentation segmentation;
  auto labels = segmentedFrom({2, 1, 3}, scene, segmentation);
  const auto errors = errorsOf(scene, labels);
  EXPECT_LT(errors.over, 0.02);
  EXPECT_LT(errors.under, 0.02);
  auto options = segmentation.getOptions();
  options.separate_things = false;
  segmentation.setOptions(options);
  segmentation.segment(labels);
  EXPECT_GT(errorsOf(scene, labels).under, 0.05);
  options.up = {0, 0, 0};
  segmentation.setOptions(options);
  segmentation.segment(labels);
  EXPECT_TRUE(labels.empty());
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
  Segmentation segmentation;
  auto labels = segmentedFrom({0.8f, -1, 2}, scene, segmentation);
  EXPECT_LT(errorsOf(scene, labels).under, 0.01);
  labels = segmentedWithout(&ObjectSegmentationOptions::separate_gaps, segmentation);
  EXPECT_GT(errorsOf(scene, labels).under, 0.2);
}

TEST(NoiseResilientLCCPSteps, PartsCabinetsThatStandAgainstEachOther)
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
  auto labels = segmentedFrom({0.6f, -2, 2}, scene, segmentation);
  EXPECT_LT(errorsOf(scene, labels).under, 0.05);
  labels = segmentedWithout(&ObjectSegmentationOptions::separate_seams, segmentation);
  EXPECT_GT(errorsOf(scene, labels).under, 0.5);
}

TEST(NoiseResilientLCCPSteps, JoinsTheBoardsOfABookcase)
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
  const auto joined = errorsOf(scene, labels).over;
  labels = segmentedWithout(&ObjectSegmentationOptions::join_racks, segmentation);
  const auto apart = errorsOf(scene, labels).over;
  EXPECT_GT(apart, 0.4);
  EXPECT_LT(joined, 0.7 * apart);
}

TEST(NoiseResilientLCCPSteps, JoinsTheEndBoardsOfADeskThatIsSeenFromBelow)
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
  for (const auto partition : {Partition::Graph, Partition::Lccp}) {
    segmentation.setPartition(partition);
    Labels labels;
    segmentation.segment(labels);
    EXPECT_GT(largestShareOf(1, scene, labels), 0.97);
    auto options = segmentation.getOptions();
    labels = segmentedWithout(&ObjectSegmentationOptions::join_uprights, segmentation);
    EXPECT_LT(largestShareOf(1, scene, labels), 0.6);
    segmentation.setOptions(options);
  }
}

TEST(NoiseResilientLCCPSteps, JoinsTheFrameOfADoorInAWallThatStandsAskew)
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

TEST(NoiseResilientLCCPSteps, LeavesAWindowInItsWallWhole)
{
  Segmentation segmentation;
  const auto largestOfBoth = [&](float into_room) {
    auto scene = leavesInWall(into_room);
    const auto labels = segmentedFrom({1.5f, 2, 1.4f}, scene, segmentation);
    for (auto& object : scene.objects)
      object = object == 3 ? 2 : object;
    return largestShareOf(2, scene, labels);
  };
  EXPECT_GT(largestOfBoth(0.09f), 0.95);
  EXPECT_LT(largestOfBoth(0.2f), 0.6) << "wall cabinets";
}

TEST(NoiseResilientLCCPSteps, JoinsAFrontThatAShadowCuts)
{
  const auto scene = cupboardInShadow();
  Segmentation segmentation;
  auto labels = segmentedFrom({0.8f, -3, 2}, scene, segmentation);
  EXPECT_GT(largestShareOf(1, scene, labels), 0.97);
  EXPECT_LT(errorsOf(scene, labels).under, 0.01);
  labels = segmentedWithout(&ObjectSegmentationOptions::join_shadowed, segmentation);
  EXPECT_LT(largestShareOf(1, scene, labels), 0.6);
}

TEST(NoiseResilientLCCPSteps, TakesABeamOutOfTheColumnThatItRunsThrough)
{
  const auto scene = beamThroughColumn();
  Segmentation segmentation;
  auto options = segmentation.getOptions();
  options.separate_structure = false; // the beam reaches through the whole scene
  segmentation.setOptions(options);
  auto labels = segmentedFrom({2, -4, 1.5f}, scene, segmentation);
  EXPECT_GT(largestShareOf(1, scene, labels), 0.97);
  EXPECT_LT(errorsOf(scene, labels).under, 0.05);
  labels = segmentedWithout(&ObjectSegmentationOptions::separate_bars, segmentation);
  EXPECT_LT(largestShareOf(1, scene, labels), 0.6);
}

TEST(NoiseResilientLCCPSteps, JoinsTheLeafOfAnOpenDoorWithItsFrame)
{
  const auto scene = openDoor();
  Segmentation segmentation;
  auto labels = segmentedFrom({1.7f, 2, 1.4f}, scene, segmentation);
  EXPECT_GT(largestShareOf(2, scene, labels), 0.95);
  EXPECT_LT(errorsOf(scene, labels).under, 0.05);
  labels = segmentedWithout(&ObjectSegmentationOptions::join_doors, segmentation);
  EXPECT_LT(largestShareOf(2, scene, labels), 0.85);
}
