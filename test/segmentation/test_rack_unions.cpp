/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/joined_segments.h"

#include <pcl/segmentation/rack_unions.h>

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

/** Boards (1 to 4) and uprights (5, 6) of a rack of 1 m x 0.35 m x 1.6 m. */
LabelledPoints
rack()
{
  LabelledPoints scene;
  std::mt19937 rng(4);
  for (std::uint32_t board = 1; board <= 4; ++board)
    scene.addBox({0.03f, 0, 0.4f * static_cast<float>(board) - 0.2f},
                 {0.94f, 0.35f, 0.02f},
                 board,
                 0.01f,
                 0,
                 rng);
  scene.addBox({0, 0, 0}, {0.02f, 0.35f, 1.6f}, 5, 0.01f, 0, rng);
  scene.addBox({0.98f, 0, 0}, {0.02f, 0.35f, 1.6f}, 6, 0.01f, 0, rng);
  return scene;
}

/** The segments of the points after racks are joined; before, those of the scene. */
std::vector<std::uint32_t>
joined(const LabelledPoints& scene,
       const RackUnionOptions& options = {},
       bool leave_out = false)
{
  return joinedSegments(scene, options, leave_out, joinRacks);
}

TEST(RackUnions, JoinBoardsAndUprights) { EXPECT_EQ(segmentCount(joined(rack())), 1u); }

TEST(RackUnions, FollowTheAxesAndUp)
{
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(0.5f, Eigen::Vector3f(1, 2, 3).normalized()).toRotationMatrix();
  auto scene = rack();
  scene.turn(turn);
  RackUnionOptions options;
  options.axes = turn;
  options.up = turn.col(2);
  EXPECT_EQ(segmentCount(joined(scene, options)), 1u);
  options.axes.col(0).swap(options.axes.col(2)); // the order of axes does not count
  EXPECT_EQ(segmentCount(joined(scene, options)), 1u);
  options.up = turn.col(1);
  EXPECT_GT(segmentCount(joined(scene, options)), 1u) << "seen from the front";
}

TEST(RackUnions, LeaveBoardsOfAnotherOutlineApart)
{
  LabelledPoints scene;
  std::mt19937 rng(5);
  scene.addBox({0, 0, 0.7f}, {1.6f, 0.8f, 0.03f}, 1, 0.01f, 0, rng); // a desk
  scene.addBox({0.2f, 0, 0}, {0.4f, 0.8f, 0.66f}, 2, 0.01f, 0, rng); // its drawers
  scene.addBox({0.5f, 0.2f, 0.75f}, {0.4f, 0.3f, 0.03f}, 3, 0.01f, 0, rng);
  EXPECT_EQ(segmentCount(joined(scene)), 3u);
}

TEST(RackUnions, LeaveUprightsThatReachBeyondApart)
{
  auto scene = rack();
  std::mt19937 rng(6);
  scene.addBox({0.98f, 0.35f, 0}, {0.02f, 0.5f, 1.6f}, 6, 0.01f, 0, rng);
  const auto labels = joined(scene);
  EXPECT_EQ(segmentCount(labels), 2u);
}

TEST(RackUnions, LeaveBoardsThatNothingHoldsApart)
{
  auto scene = rack();
  LabelledPoints boards;
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    if (scene.objects[i] <= 4) {
      boards.points.push_back(scene.points[i]);
      boards.normals.push_back(scene.normals[i]);
      boards.objects.push_back(scene.objects[i]);
    }
  EXPECT_EQ(segmentCount(joined(boards)), 4u);
}

/** Two boxes, the second on the first, further to the back or not. */
LabelledPoints
boxOnBox(float shift)
{
  LabelledPoints boxes;
  std::mt19937 rng(7);
  const Eigen::Vector3f size(0.5f, 0.4f, 0.4f);
  boxes.addBox({0, 0, 0}, size, 1, 0.01f, 0, rng);
  boxes.addBox({0, shift, 0.43f}, size, 2, 0.01f, 0, rng);
  return boxes;
}

TEST(RackUnions, JoinCompartmentsOfOneOutlineThatTouch)
{
  EXPECT_EQ(segmentCount(joined(boxOnBox(0))), 1u);
  EXPECT_EQ(segmentCount(joined(boxOnBox(0.04f))), 1u);
  EXPECT_EQ(segmentCount(joined(boxOnBox(0.12f))), 2u) << "0.28 m of 0.52 m are common";
  RackUnionOptions options;
  options.min_overlap = 0.5;
  EXPECT_EQ(segmentCount(joined(boxOnBox(0.12f), options)), 1u);
}

TEST(RackUnions, LeaveCompartmentsApartThatOnlyShareANeighbor)
{
  LabelledPoints scene;
  std::mt19937 rng(8);
  for (const std::uint32_t i : {1u, 2u})
    scene.addBox({0, 0, i == 1 ? 0 : 0.6f}, {0.5f, 0.4f, 0.4f}, i, 0.01f, 0, rng);
  scene.addBox({0.53f, 0, 0}, {0.5f, 0.4f, 1}, 3, 0.01f, 0, rng); // beside both
  EXPECT_EQ(segmentCount(joined(scene)), 3u);
  scene.removeIf([](const Eigen::Vector3f& p) { // a level board instead of the upper
    return p.x() < 0.52f && p.z() > 0.5f && p.z() < 0.9f;
  });
  EXPECT_EQ(segmentCount(joined(scene)), 2u);
}

TEST(RackUnions, JoinWhatLiesWithinTheirBox)
{
  const auto with_body = [](float height) { // between boards of 0.4 m distance
    auto scene = rack();
    std::mt19937 rng(9);
    scene.addBox({0.2f, 0.02f, 0.63f}, {0.5f, 0.3f, height}, 7, 0.01f, 0, rng);
    return scene;
  };
  EXPECT_EQ(segmentCount(joined(with_body(0.3f))), 1u);
  const auto on_top = [](float height, float depth) {
    auto scene = rack();
    std::mt19937 rng(9);
    scene.addBox({0.2f, 0, 1.44f}, {0.5f, depth, height}, 7, 0.01f, 0, rng);
    return scene;
  };
  EXPECT_EQ(segmentCount(joined(on_top(0.02f, 0.3f))), 1u);
  EXPECT_EQ(segmentCount(joined(on_top(0.12f, 0.3f))), 2u) << "sticks out above";
  EXPECT_EQ(segmentCount(joined(on_top(0.02f, 0.6f))), 2u) << "sticks out in front";
}

TEST(RackUnions, LeaveLeftOutVoxelsAlone)
{
  EXPECT_EQ(segmentCount(joined(rack(), {}, true)), 6u);
}

TEST(RackUnions, RefuseWrongInput)
{
  const auto scene = rack();
  RackUnionOptions options;
  options.min_overlap = 0;
  EXPECT_THROW(joined(scene, options), pcl::BadArgumentException);
  options = {};
  options.up = {0, 0, 0.5f};
  EXPECT_THROW(joined(scene, options), pcl::BadArgumentException);
  const auto voxels = surfaceVoxels(scene.points, {}, 0.03);
  std::vector<std::uint32_t> segments(voxels.size(), 0);
  EXPECT_THROW(joinRacks(voxels, {}, {}, segments), pcl::BadArgumentException);
  std::vector<std::uint32_t> none;
  EXPECT_NO_THROW(joinRacks({}, {}, {}, none));
}

} // namespace
