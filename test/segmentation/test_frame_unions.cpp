/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/joined_segments.h"

#include <pcl/segmentation/frame_unions.h>

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr float spacing = 0.01f;

/** Boxes, each a segment of its own, given by corner and size. */
LabelledPoints
boxes(const std::vector<std::pair<Eigen::Vector3f, Eigen::Vector3f>>& list)
{
  LabelledPoints scene;
  std::mt19937 rng(2);
  for (std::size_t i = 0; i < list.size(); ++i)
    scene.addBox(list[i].first,
                 list[i].second,
                 static_cast<std::uint32_t>(i + 1),
                 spacing,
                 0,
                 rng);
  return scene;
}

/** Jambs (1, 2) and head (3) of a door of 0.9 m x 2 m in the plane y = 0. */
LabelledPoints
doorFrame()
{
  return boxes({{{0, 0, 0}, {0.08f, 0.12f, 2.08f}},
                {{0.98f, 0, 0}, {0.08f, 0.12f, 2.08f}},
                {{0.09f, 0, 2}, {0.88f, 0.12f, 0.08f}}});
}

Eigen::Matrix3f
rotationBy(float angle, const Eigen::Vector3f& axis)
{
  return Eigen::AngleAxisf(angle, axis.normalized()).toRotationMatrix();
}

/** The segments of the points after frames are joined; before, those of the scene. */
std::vector<std::uint32_t>
joined(const LabelledPoints& scene,
       const FrameUnionOptions& options = {},
       bool leave_out = false)
{
  return joinedSegments(scene, options, leave_out, joinFrames);
}

/** Whether the points of two objects are in one segment now. */
bool
areJoined(const LabelledPoints& scene,
          const std::vector<std::uint32_t>& labels,
          std::uint32_t a,
          std::uint32_t b)
{
  std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> counts;
  for (std::size_t i = 0; i < labels.size(); ++i)
    ++counts[scene.objects[i]][labels[i]];
  const auto most = [&](std::uint32_t object) {
    return std::max_element(
               counts[object].begin(),
               counts[object].end(),
               [](const auto& x, const auto& y) { return x.second < y.second; })
        ->first;
  };
  return most(a) == most(b);
}

TEST(FrameUnions, JoinsJambsAndHeadOfADoor)
{
  const auto scene = doorFrame();
  const auto labels = joined(scene);
  EXPECT_TRUE(areJoined(scene, labels, 1, 3));
  EXPECT_TRUE(areJoined(scene, labels, 2, 3));
}

TEST(FrameUnions, FollowsTheAxesAndTheDirectionUp)
{
  auto scene = doorFrame();
  const auto rotation = rotationBy(0.7f, {1, 2, -1});
  scene.turn(rotation);
  EXPECT_FALSE(areJoined(scene, joined(scene), 1, 3));
  FrameUnionOptions options;
  options.axes = rotation;
  options.up = rotation.col(2);
  EXPECT_TRUE(areJoined(scene, joined(scene, options), 1, 3));
  options.up = rotation.col(1); // the frame lies on the ground
  EXPECT_FALSE(areJoined(scene, joined(scene, options), 1, 3));
}

TEST(FrameUnions, JoinsOpenShapes)
{
  // A jamb with a part of the head, and the rest of the head
  auto scene = boxes({{{0, 0, 0}, {0.08f, 0.12f, 2.08f}},
                      {{0.09f, 0, 2}, {0.4f, 0.12f, 0.08f}},
                      {{0.5f, 0, 2}, {0.5f, 0.12f, 0.08f}}});
  for (auto& object : scene.objects)
    object = object == 3 ? 2 : 1;
  EXPECT_TRUE(areJoined(scene, joined(scene), 1, 2));
  FrameUnionOptions options;
  options.max_fill = 0.02;
  EXPECT_FALSE(areJoined(scene, joined(scene, options), 1, 2));
}

TEST(FrameUnions, LeavesADoorsLeafAndFurnitureBesideTheFrame)
{
  const auto scene = boxes({{{0, 0, 0}, {0.08f, 0.12f, 2}},
                            {{0.09f, 0.03f, 0}, {0.8f, 0.05f, 2}}, // fills its outline
                            {{-0.21f, 0, 0}, {0.2f, 0.5f, 1.5f}},  // too deep
                            {{0, 0.13f, 0.3f}, {0.06f, 0.06f, 0.2f}}, // too short
                            {{-0.42f, 0, 0}, {0.2f, 0.5f, 1.5f}}});
  const auto labels = joined(scene);
  for (const std::uint32_t object : {2, 3, 4})
    EXPECT_FALSE(areJoined(scene, labels, 1, object)) << object;
  EXPECT_FALSE(areJoined(scene, labels, 3, 5));
}

TEST(FrameUnions, LeavesBarsOfDifferentLayers)
{
  // Two posts, one before the other
  const auto scene =
      boxes({{{0, 0, 0}, {0.06f, 0.06f, 2}}, {{0, 0.07f, 0}, {0.06f, 0.06f, 2}}});
  // Along x they lie in one layer, as two posts side by side do.
  EXPECT_TRUE(areJoined(scene, joined(scene), 1, 2));
  const auto crossed = boxes(
      {{{0, 0, 0}, {0.06f, 0.06f, 2}}, {{-0.4f, 0.07f, 1}, {0.9f, 0.06f, 0.06f}}});
  EXPECT_FALSE(areJoined(crossed, joined(crossed), 1, 2));
}

TEST(FrameUnions, KeepsVoxelsThatAreLeftOut)
{
  const auto scene = doorFrame();
  EXPECT_FALSE(areJoined(scene, joined(scene, {}, true), 1, 3));
}

TEST(FrameUnions, RefusesWrongInput)
{
  const auto voxels = surfaceVoxels(doorFrame().points, {}, 0.03);
  std::vector<std::uint32_t> segments(voxels.size(), 0);
  const std::vector<std::uint8_t> left_out(voxels.size(), 0);
  FrameUnionOptions options;
  options.max_thickness = 0;
  EXPECT_THROW(joinFrames(voxels, left_out, options, segments),
               pcl::BadArgumentException);
  options = {};
  options.up = {0, 0, 0};
  EXPECT_THROW(joinFrames(voxels, left_out, options, segments),
               pcl::BadArgumentException);
  EXPECT_THROW(joinFrames(voxels, {}, {}, segments), pcl::BadArgumentException);
  std::vector<std::uint32_t> none;
  joinFrames(surfaceVoxels({}, {}, 0.03), {}, {}, none);
  EXPECT_TRUE(none.empty());
}

} // namespace
