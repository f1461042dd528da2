/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/object_scene.h"

#include <pcl/exceptions.h>
#include <pcl/segmentation/door_unions.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr std::uint32_t in_wall = 0, frame = 1, leaf = 2, second_leaf = 3;
constexpr float right_angle = static_cast<float>(M_PI) / 2;

void
addBody(LabelledPoints& scene,
        const Eigen::Vector3f& low,
        const Eigen::Vector3f& size,
        std::uint32_t object)
{
  std::mt19937 rng(6);
  scene.addBox(low, size, object, 0.02f, 0.002f, rng);
}

/** A wall along x before which the room is in y, with a frame of 1 m in it. */
LabelledPoints
frameInWall(float height = 2.05f, float depth_behind = 0.12f)
{
  LabelledPoints scene;
  std::mt19937 rng(5);
  scene.addRectangle(
      {0, 0, 0}, {3, 0, 0}, {0, 0, 2.5f}, {0, 1, 0}, in_wall, 0.03f, 0.002f, rng);
  scene.removeIf([&](const Eigen::Vector3f& p) {
    return p.x() > 1 && p.x() < 2 && p.z() < height;
  });
  const float depth = depth_behind + 0.03f;
  for (const float x : {1.0f, 1.94f})
    addBody(scene, {x, -depth_behind, 0}, {0.06f, depth, height - 0.06f}, frame);
  addBody(scene, {1, -depth_behind, height - 0.06f}, {1, depth, 0.06f}, frame);
  return scene;
}

struct Leaf {
  float angle = right_angle;
  Eigen::Vector3f size{0.88f, 0.04f, 2};
  Eigen::Vector3f hinge{1.06f, 0, 0};
  std::uint32_t object = leaf;
};

void
add(LabelledPoints& scene, const Leaf& leaf)
{
  LabelledPoints body;
  addBody(body, {0, 0, 0}, leaf.size, leaf.object);
  body.turn(Eigen::AngleAxisf(leaf.angle, Eigen::Vector3f::UnitZ()).matrix());
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    scene.points.emplace_back(leaf.hinge + body.points[i]);
    scene.normals.push_back(body.normals[i]);
    scene.objects.push_back(body.objects[i]);
  }
}

/** What the scene's objects become, each of its points in a voxel of its own. */
std::vector<std::uint32_t>
joined(const LabelledPoints& scene,
       std::size_t expected_leaves,
       const DoorUnionOptions& options = {},
       const Eigen::Matrix3f& turn = Eigen::Matrix3f::Identity())
{
  SurfaceVoxels voxels;
  voxels.centroids = scene.points;
  StructurePlane wall;
  wall.normal = (turn * Eigen::Vector3f::UnitY()).cast<double>();
  std::vector<std::uint32_t> plane_of_voxel;
  for (std::uint32_t i = 0; i < scene.points.size(); ++i) {
    voxels.cells.cell_of_point.push_back(i);
    plane_of_voxel.push_back(scene.objects[i] == in_wall);
  }
  auto segments = scene.objects;
  EXPECT_EQ(
      joinDoorLeaves(scene.points, voxels, {wall}, plane_of_voxel, options, segments),
      expected_leaves);
  EXPECT_EQ(segmentCount(segments) + expected_leaves, segmentCount(scene.objects));
  return segments;
}

void
expectJoined(const Leaf& open, std::size_t expected_leaves)
{
  auto scene = frameInWall();
  add(scene, open);
  const auto segments = joined(scene, expected_leaves);
  for (std::size_t i = 0; i < segments.size(); ++i)
    ASSERT_EQ(segments[i] == in_wall, scene.objects[i] == in_wall);
}

TEST(DoorUnions, JoinALeafThatIsOpen)
{
  for (const float angle : {0.5f, 1.0f, right_angle, 2.0f}) {
    Leaf open;
    open.angle = angle;
    SCOPED_TRACE(angle);
    expectJoined(open, 1);
  }
}

TEST(DoorUnions, JoinALeafThatHasAJambAndMore)
{
  for (const float part_of_leaf : {1.08f, 1.6f, 1.92f}) { // the last leaves one jamb
    auto scene = frameInWall();
    add(scene, {});
    for (std::size_t i = 0; i < scene.points.size(); ++i)
      if (scene.objects[i] == frame && scene.points[i].x() < part_of_leaf)
        scene.objects[i] = leaf;
    SCOPED_TRACE(part_of_leaf);
    joined(scene, 1);
  }
}

TEST(DoorUnions, JoinBothLeavesOfADoubleDoor)
{
  auto scene = frameInWall();
  Leaf half;
  half.size.x() = 0.44f;
  add(scene, half);
  half.object = second_leaf;
  half.hinge.x() = 1.94f;
  add(scene, half);
  joined(scene, 2);
  DoorUnionOptions options;
  options.min_width_ratio = 0.6;
  joined(scene, 0, options);
}

TEST(DoorUnions, FollowTheDirectionUp)
{
  auto scene = frameInWall();
  add(scene, {});
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(1.3f, Eigen::Vector3f(1, 2, -0.5f).normalized()).matrix();
  scene.turn(turn);
  DoorUnionOptions options;
  options.up = turn.col(2);
  joined(scene, 1, options, turn);
  options.up = turn.col(1); // the wall is level
  joined(scene, 0, options, turn);
}

TEST(DoorUnions, LeaveWhatIsNoLeaf)
{
  const auto expectApart = [](const char* what, auto change) {
    Leaf other;
    change(other);
    SCOPED_TRACE(what);
    expectJoined(other, 0);
  };
  expectApart("lower", [](auto& o) { o.size.z() = 1.5f; });
  expectApart("higher", [](auto& o) { o.size.z() = 2.7f; });
  expectApart("a cabinet", [](auto& o) { o.size.y() = 0.3f; });
  expectApart("a wall of its own", [](auto& o) { o.size.x() = 1.4f; });
  expectApart("narrow", [](auto& o) { o.size.x() = 0.3f; });
  expectApart("beside the frame", [](auto& o) { o.hinge.x() = 0.8f; });
  expectApart("before the wall", [](auto& o) { o.hinge.y() = 0.1f; });
  expectApart("shut", [](auto& o) { o.angle = 0; });
}

TEST(DoorUnions, HangOnMostOfTheirHeight)
{
  auto scene = frameInWall();
  Leaf screen;
  screen.hinge.y() = 0.1f;
  add(scene, screen);
  addBody(scene, {1.02f, 0, 0}, {0.04f, 0.1f, 0.9f}, leaf);
  joined(scene, 0);
  DoorUnionOptions options;
  options.min_hinge = 0.4;
  joined(scene, 1, options);
}

TEST(DoorUnions, AreNotWiderThanDoorsAre)
{
  auto scene = frameInWall();
  add(scene, {});
  DoorUnionOptions options;
  options.max_width = 0.8;
  joined(scene, 0, options);
}

TEST(DoorUnions, LeaveWhatIsFlatOnTheWall)
{
  auto scene = frameInWall();
  std::mt19937 rng(7);
  const float thickness = 0.1f, height = 2;
  const auto add = [&](const Eigen::Vector3f& corner, const Eigen::Vector3f& u) {
    scene.addRectangle(corner, u, {0, 0, height}, {0, 1, 0}, leaf, 0.02f, 0.002f, rng);
  };
  add({2.03f, thickness, 0}, {0.9f, 0, 0});
  add({2.03f, 0, 0}, {0, thickness, 0});
  add({2.93f, 0, 0}, {0, thickness, 0});
  joined(scene, 0);
}

TEST(DoorUnions, LeaveABlindBeforeTheFrame)
{
  auto scene = frameInWall();
  std::mt19937 rng(7);
  const Eigen::Vector3f up(0, 0, 2);
  scene.addRectangle(
      {1.06f, 0.1f, 0}, {0.88f, 0, 0}, up, {0, 1, 0}, leaf, 0.02f, 0.002f, rng);
  scene.addRectangle(
      {1.06f, 0, 0}, {0, 0.1f, 0}, up, {1, 0, 0}, leaf, 0.02f, 0.002f, rng);
  joined(scene, 0);
}

TEST(DoorUnions, LeaveAPanelBesideTheFrame)
{
  auto scene = frameInWall();
  addBody(scene, {0.87f, 0, 0}, {0.1f, 0.9f, 2}, leaf);
  joined(scene, 0);
  addBody(scene, {1.06f, 0, 0}, {0.1f, 0.9f, 2}, second_leaf);
  const auto segments = joined(scene, 1);
  for (std::size_t i = 0; i < segments.size(); ++i)
    ASSERT_EQ(segments[i] == leaf, scene.objects[i] == leaf)
        << "the other one is in the opening";
}

TEST(DoorUnions, JoinOnlyTheFrameOfTheLeaf)
{
  constexpr std::uint32_t second_frame = 4;
  auto scene = frameInWall();
  const auto one = scene.points.size();
  scene.removeIf([](const Eigen::Vector3f& p) { return p.x() > 2.01f; });
  for (std::size_t i = 0; i < std::min(one, scene.points.size()); ++i)
    if (scene.objects[i] == frame) {
      scene.points.emplace_back(scene.points[i] + Eigen::Vector3f(1.05f, 0, 0));
      scene.normals.emplace_back(scene.normals[i]);
      scene.objects.push_back(second_frame);
    }
  Leaf open;
  open.hinge.x() = 1.94f;
  open.angle = right_angle;
  add(scene, open);
  const auto segments = joined(scene, 1);
  for (std::size_t i = 0; i < segments.size(); ++i)
    ASSERT_EQ(segments[i] == second_frame, scene.objects[i] == second_frame);
}

TEST(DoorUnions, NeedAFrame)
{
  for (const float height : {0.9f, 2.05f}) {
    auto scene = frameInWall(height, height < 1 ? 0.12f : 0);
    Leaf other;
    other.size.z() = height - 0.05f;
    add(scene, other);
    SCOPED_TRACE(height);
    joined(scene, 0);
  }
}

TEST(DoorUnions, RefuseWhatDoesNotFit)
{
  const auto scene = frameInWall();
  SurfaceVoxels voxels;
  voxels.centroids = scene.points;
  voxels.cells.cell_of_point.assign(scene.points.size(), 0);
  const std::vector<std::uint32_t> planes(scene.points.size(), 0);
  auto segments = scene.objects;
  const auto refused = [&](auto change) {
    DoorUnionOptions options;
    change(options);
    EXPECT_THROW(joinDoorLeaves(scene.points, voxels, {}, planes, options, segments),
                 pcl::BadArgumentException);
  };
  refused([](auto& o) { o.voxel_size = 0; });
  refused([](auto& o) { o.up *= 2; });
  refused([](auto& o) { o.min_height = -1; });
  refused([](auto& o) { o.max_thickness = -1; });
  refused([](auto& o) { o.max_width = std::nan(""); });
  refused([](auto& o) { o.min_width_ratio = 2; });
  refused([](auto& o) { o.max_ratio = 0.9; });
  refused([](auto& o) { o.min_hinge = 1.1; });
  EXPECT_EQ(joinDoorLeaves(scene.points, voxels, {}, planes, {}, segments), 0u);
  segments.pop_back();
  refused([](auto&) {});
}

} // namespace
