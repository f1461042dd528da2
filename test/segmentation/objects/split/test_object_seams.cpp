/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/labelled_points.h"

#include "objects/split/object_seams.h"
#include "rooms/space/voxel_normals.h"
#include "segmentation/objects/scene_of_points.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr float spacing = 0.015f, noise = 0.004f;

/** Closed cabinets of 0.6 m in a row (objects 1, 2 ...), seen between each other as far
 * as a depth from the front. */
LabelledPoints
cabinets(int count, float seen_depth = 0.3f)
{
  LabelledPoints scene;
  std::mt19937 rng(5);
  for (int i = 0; i < count; ++i)
    scene.addBox({static_cast<float>(i) * 0.61f, 0, 0},
                 {0.6f, 0.6f, 0.9f},
                 static_cast<std::uint32_t>(i + 1),
                 spacing,
                 noise,
                 rng);
  const float width = 0.61f * static_cast<float>(count) - 0.01f;
  scene.removeIf([&](const Eigen::Vector3f& p) { // not seen
    const bool is_within = p.x() > 0.05f && p.x() < width - 0.05f && p.z() < 0.85f;
    return p.y() > 0.58f || (is_within && p.y() > seen_depth && p.y() < 0.58f);
  });
  return scene;
}

/** A shelf of 1.21 m with boards each 0.3 m and an upright in its middle; the back is
 * closed, its normals and those of the boards point into it. */
LabelledPoints
openShelf()
{
  LabelledPoints scene;
  std::mt19937 rng(6);
  const Eigen::Vector3f x(1.21f, 0, 0), y(0, 0.4f, 0), z(0, 0, 1.5f);
  scene.addRectangle({0, 0.4f, 0}, x, z, {0, -1, 0}, 1, spacing, noise, rng);
  for (int board = 0; board <= 5; ++board)
    scene.addRectangle({0, 0, 0.3f * static_cast<float>(board)},
                       x,
                       y,
                       {0, 0, board == 5 ? -1.0f : 1.0f},
                       1,
                       spacing,
                       noise,
                       rng);
  for (const float side : {0.0f, 0.6f, 0.61f, 1.21f})
    scene.addRectangle(
        {side, 0, 0}, y, z, {side > 0.6f ? 1.0f : -1.0f, 0, 0}, 1, spacing, noise, rng);
  return scene;
}

/** All points of one segment in the input, with their own normals. */
std::vector<std::uint32_t>
partedAtSeams(const ObjectScene& scene, bool leave_out = false)
{
  std::vector<std::uint32_t> labels(scene.points.size(), 1);
  partAtSeams(scene, std::vector<std::uint8_t>(scene.points.size(), leave_out), labels);
  return labels;
}

ObjectScene
sceneOf(const LabelledPoints& labelled)
{
  auto scene = sceneOfPoints(labelled.points, 0.03);
  averageNormals(labelled.normals, scene.voxels);
  return scene;
}

std::vector<std::uint32_t>
partedAtSeams(const LabelledPoints& labelled)
{
  return partedAtSeams(sceneOf(labelled));
}

/** Share of the points that are in another segment than most of their object. */
double
strayShare(const LabelledPoints& scene, const std::vector<std::uint32_t>& labels)
{
  std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> counts;
  for (std::size_t i = 0; i < labels.size(); ++i)
    ++counts[scene.objects[i]][labels[i]];
  std::size_t stray = labels.size();
  for (const auto& [object, count] : counts) {
    std::size_t most = 0;
    for (const auto& [label, size] : count)
      most = std::max(most, size);
    stray -= most;
  }
  return static_cast<double>(stray) / static_cast<double>(labels.size());
}

TEST(ObjectSeams, PartCabinetsWhicheverWayTheyStand)
{
  for (const float angle : {0.0f, 0.3f, 1.2f, 2.8f}) {
    auto scene = cabinets(3);
    scene.turn(Eigen::AngleAxisf(angle, Eigen::Vector3f::UnitZ()).toRotationMatrix());
    const auto labels = partedAtSeams(scene);
    EXPECT_EQ(segmentCount(labels), 3u) << angle;
    // a cut, in steps of 3 degrees, leaves the seam by up to 8 mm
    EXPECT_LT(strayShare(scene, labels), 0.03) << angle;
  }
}

TEST(ObjectSeams, AreNotSeenWhereNothingIsSeenBetween)
{
  EXPECT_EQ(segmentCount(partedAtSeams(cabinets(2, 0.03f))), 1u);
  EXPECT_EQ(segmentCount(partedAtSeams(cabinets(1))), 1u);
}

TEST(ObjectSeams, LeaveTheCompartmentsOfAnOpenShelfTogether)
{
  EXPECT_EQ(segmentCount(partedAtSeams(openShelf())), 1u);
  auto closed = openShelf();
  for (auto& normal : closed.normals)
    normal *= -1;
  EXPECT_EQ(segmentCount(partedAtSeams(closed)), 2u) << "it is the normals that tell";
}

TEST(ObjectSeams, LeaveATableOnItsPanelWhole)
{
  LabelledPoints table;
  std::mt19937 rng(3);
  table.addRectangle(
      {0, 0, 0.7f}, {1.6f, 0, 0}, {0, 0.8f, 0}, {0, 0, 1}, 1, spacing, noise, rng);
  table.addRectangle(
      {0.8f, 0.05f, 0}, {0, 0.7f, 0}, {0, 0, 0.68f}, {1, 0, 0}, 1, spacing, noise, rng);
  EXPECT_EQ(segmentCount(partedAtSeams(table)), 1u) << "what is below it is open";
}

TEST(ObjectSeams, NeedBodiesOnBothSides)
{
  auto cut_off = cabinets(2); // 0.1 m of the second is left
  cut_off.removeIf([](const Eigen::Vector3f& p) { return p.x() > 0.7f; });
  EXPECT_EQ(segmentCount(partedAtSeams(cut_off)), 1u);
}

TEST(ObjectSeams, LeaveLeftOutAndOtherSegmentsAlone)
{
  const auto labelled = cabinets(2);
  const auto scene = sceneOf(labelled);
  EXPECT_EQ(segmentCount(partedAtSeams(scene, true)), 1u);
  auto labels = labelled.objects;
  partAtSeams(scene, std::vector<std::uint8_t>(labels.size(), 0), labels);
  EXPECT_EQ(labels, labelled.objects);
}

TEST(ObjectSeams, AreTheSameForAnyThreadsAndOrder)
{
  const auto scene = cabinets(3);
  auto with_threads = sceneOf(scene);
  with_threads.threads = 1;
  const auto labels = partedAtSeams(with_threads);
  with_threads.threads = 3;
  EXPECT_EQ(partedAtSeams(with_threads), labels);
  std::mt19937 rng(2);
  const auto order = shuffledOrder(scene.points.size(), rng);
  std::vector<std::uint32_t> expected;
  for (const auto i : order)
    expected.push_back(labels[i]);
  EXPECT_EQ(renamed(partedAtSeams(scene.reordered(order))), renamed(expected));
}

TEST(ObjectSeams, LeaveWhatReachesTooFarWhole)
{
  auto points = cabinets(2).points;
  points.emplace_back(0, 0, 5e6f);
  auto scene = sceneOfPoints(points, 1e3); // voxels of any size
  scene.voxel_size = 0.03;
  scene.voxels.normals.assign(scene.voxels.size(), Eigen::Vector3f::UnitZ());
  EXPECT_EQ(segmentCount(partedAtSeams(scene)), 1u);
}

TEST(ObjectSeams, LeaveDegenerateInputAlone)
{
  EXPECT_TRUE(partedAtSeams(LabelledPoints()).empty());
  LabelledPoints same;
  same.points.assign(500, {1, 2, 3});
  same.normals.assign(500, {0, 0, 1});
  same.objects.assign(500, 1);
  EXPECT_EQ(segmentCount(partedAtSeams(same)), 1u);
}

TEST(ObjectSeams, LeaveFewPointsFarFromTheOriginWhole)
{
  constexpr float voxel = 0.45f; // metres
  std::mt19937 rng(3);
  std::uniform_real_distribution<float> far(300, 480), high(0, 6);
  for (int run = 0; run < 50; ++run) { // rounding hardly ever moves a point away
    std::vector<Eigen::Vector3f> points;
    while (points.size() < 60) {
      const float x = far(rng), y = far(rng);
      points.emplace_back(x, y, high(rng));
    }
    auto scene = sceneOfPoints(points, voxel);
    scene.voxels.normals.assign(scene.voxels.size(), Eigen::Vector3f::UnitZ());
    EXPECT_EQ(segmentCount(partedAtSeams(scene)), 1u);
  }
}

} // namespace
