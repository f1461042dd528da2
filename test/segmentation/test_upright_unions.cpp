/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/upright_scene.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

/** The desk top with an end board (2) that is seen from under the top. */
LabelledPoints
desk(int thickness = 1)
{
  auto scene = deskTop();
  addBlock(scene, {0, 0, 0}, {thickness, 20, 20}, along_x, 2);
  return scene;
}

TEST(UprightUnions, JoinAnEndBoardToTheTopAboveIt)
{
  auto scene = desk();
  EXPECT_EQ(countOf(scene), 1u);
  for (auto& normal : scene.normals)
    normal = -normal; // the top from below, the board from outside
  EXPECT_EQ(countOf(scene), 1u);
}

TEST(UprightUnions, JoinThinLegs)
{
  auto scene = deskTop();
  std::uint32_t leg = 2;
  for (const int x : {0, 38})
    for (const int y : {0, 18})
      addBlock(scene, {x, y, 0}, {x + 2, y + 2, 20}, along_y, leg++);
  EXPECT_EQ(countOf(scene), 1u);
}

TEST(UprightUnions, StandAtAnyAngleAndFollowUp)
{
  const auto expectJoinedAlongUp = [](float angle, const Eigen::Vector3f& axis) {
    const Eigen::Matrix3f turn =
        Eigen::AngleAxisf(angle, axis.normalized()).toRotationMatrix();
    auto scene = deskTop();
    addBlock(scene, {0, 4, 0}, {1, 16, 20}, along_x, 2);
    scene.turn(turn);
    auto options = voxelOptions();
    options.up = turn.col(2);
    EXPECT_EQ(countOf(scene, options), 1u) << turn;
    options.up = turn.col(1);
    EXPECT_EQ(countOf(scene, options), 2u) << turn;
    options.up = -turn.col(2);
    EXPECT_EQ(countOf(scene, options), 2u) << turn << ", stands on its top";
  };
  expectJoinedAlongUp(0.5f, along_z);
  expectJoinedAlongUp(0.8f, along_z);
  expectJoinedAlongUp(1.6f, along_x);
  expectJoinedAlongUp(3, along_x);
  expectJoinedAlongUp(0.5f, {1, 2, 3});
}

TEST(UprightUnions, LeaveWhatIsThickApart)
{
  EXPECT_EQ(countOf(desk(6)), 1u) << "0.188 m";
  EXPECT_EQ(countOf(desk(7)), 2u) << "0.219 m";
  EXPECT_EQ(countOf(desk(15)), 2u) << "drawers";
  auto options = voxelOptions();
  options.max_thickness = 0.5;
  EXPECT_EQ(countOf(desk(15), options), 1u);
  auto scene = desk();
  addBlock(scene, {1, 10, 8}, {11, 11, 9}, along_y, 2); // 10 of 410 voxels
  EXPECT_EQ(countOf(scene), 1u) << "a handle counts as an outlier";
}

TEST(UprightUnions, LeaveWhatIsLowApart)
{
  const auto with_strip = [](int height) {
    auto scene = deskTop();
    addBlock(scene, {0, 0, 20 - height}, {1, 20, 20}, along_x, 2);
    return scene;
  };
  EXPECT_EQ(countOf(with_strip(4)), 1u) << "0.125 m";
  EXPECT_EQ(countOf(with_strip(3)), 2u) << "0.094 m";
  auto options = voxelOptions();
  options.min_height = 0.14;
  EXPECT_EQ(countOf(with_strip(4), options), 2u);
}

TEST(UprightUnions, LeaveWhatLiesApart)
{
  const auto with_bar = [](int height) { // 0.16 m wide, under the top
    auto scene = deskTop();
    addBlock(scene, {0, 4, 20 - height}, {5, 16, 20}, along_x, 2);
    return scene;
  };
  EXPECT_EQ(countOf(with_bar(6)), 1u);
  EXPECT_EQ(countOf(with_bar(4)), 2u) << "0.12 m high";
}

TEST(UprightUnions, LeaveApartWhatTouchesALittleOfTheUpperEdge)
{
  // Voxels touch those beside them, too: one column more than is below the top.
  const auto beyond = [](int below) { // board of 20 columns, front part under the top
    auto scene = deskTop();
    addBlock(scene, {0, 20 - below, 0}, {1, 40 - below, 20}, along_x, 2);
    return scene;
  };
  EXPECT_EQ(countOf(beyond(9)), 1u);
  EXPECT_EQ(countOf(beyond(5)), 2u);
  auto options = voxelOptions();
  options.min_cover = 0.25;
  EXPECT_EQ(countOf(beyond(5), options), 1u);
  options.min_cover = 0.6;
  EXPECT_EQ(countOf(beyond(9), options), 2u);
  options.min_cover = 1;
  EXPECT_EQ(countOf(beyond(20), options), 1u);
}

TEST(UprightUnions, LeaveWhatTheUpperEdgeDoesNotTouchApart)
{
  auto on_board = deskTop(); // 1 below 2
  addBlock(on_board, {0, 4, 21}, {1, 16, 41}, along_x, 2);
  EXPECT_EQ(countOf(on_board), 2u);
  auto shelf = deskTop(); // halfway up a board
  addBlock(shelf, {-1, 4, 0}, {0, 16, 40}, along_x, 2);
  EXPECT_EQ(countOf(shelf), 2u);
  auto gap = deskTop();
  addBlock(gap, {0, 0, 0}, {1, 20, 19}, along_x, 2);
  EXPECT_EQ(countOf(gap), 2u);
}

TEST(UprightUnions, LeaveWhatIsNotLevelApart)
{
  LabelledPoints scene; // a leaf above a panel, then one with a level part
  addBlock(scene, {0, 0, 20}, {1, 20, 30}, along_x, 1);
  addBlock(scene, {0, 0, 0}, {1, 20, 20}, along_x, 2);
  EXPECT_EQ(countOf(scene), 2u);
  addBlock(scene, {1, 0, 26}, {5, 20, 27}, along_z, 1); // 80 of 280 voxels, high up
  EXPECT_EQ(countOf(scene), 2u);
  auto options = voxelOptions();
  options.min_level = 0.25;
  EXPECT_EQ(countOf(scene, options), 1u);
}

TEST(UprightUnions, JoinALevelTopWithAnApronOrDrawers)
{
  auto apron = deskTop(); // of the top, 0.1 m deep; the board ends at it
  addBlock(apron, {0, 0, 15}, {1, 20, 20}, along_x, 1);
  addBlock(apron, {0, 0, 0}, {1, 20, 15}, along_x, 2);
  EXPECT_EQ(countOf(apron), 1u) << "level as a whole";
  auto options = voxelOptions();
  options.min_level = 0.95;
  EXPECT_EQ(countOf(apron, options), 2u);
  auto drawers = desk(); // most of what is carried is not level
  for (const int x : {24, 32, 39})
    addBlock(drawers, {x, 0, 0}, {x + 1, 20, 20}, along_x, 1);
  EXPECT_EQ(countOf(drawers), 1u) << "level at the edge of the board";
  options.min_level = 0.8;
  EXPECT_EQ(countOf(drawers, options), 2u);
}

TEST(UprightUnions, FollowTheUpperEdgeOfASlope)
{
  const auto slope = [](const Eigen::Vector3f& normal) {
    LabelledPoints scene; // a board along x that rises by 1 per 2, a top on it
    for (int x = 0; x < 40; ++x) {
      addBlock(scene, {x, 0, 0}, {x + 1, 1, 4 + x / 2}, along_y, 2);
      addBlock(scene, {x, 0, 4 + x / 2}, {x + 1, 20, 5 + x / 2}, normal, 1);
    }
    return scene;
  };
  EXPECT_EQ(countOf(slope({-1, 0, 2})), 1u) << "27 degrees";
  EXPECT_EQ(countOf(slope({-2, 0, 1})), 2u) << "63 degrees";
}

TEST(UprightUnions, LeaveWhatRisesHighApart)
{
  const auto with_upper_part = [](int width, int height) {
    auto scene = desk(); // 800 voxels of the top
    addBlock(scene, {10, 0, 21}, {10 + width, 20, 21 + height}, along_x, 1);
    return scene;
  };
  EXPECT_EQ(countOf(with_upper_part(4, 10)), 1u) << "0.34 m above the edge";
  EXPECT_EQ(countOf(with_upper_part(4, 14)), 2u) << "0.47 m above the edge";
  auto options = voxelOptions();
  options.max_above = 0.5;
  EXPECT_EQ(countOf(with_upper_part(4, 14), options), 1u);
  auto lamp = desk();
  addBlock(lamp, {10, 10, 21}, {11, 11, 41}, along_x, 1);
  EXPECT_EQ(countOf(lamp), 1u) << "20 of 820 voxels are outliers";
}

TEST(UprightUnions, LeaveLeftOutVoxelsAlone)
{
  auto scene = desk();
  EXPECT_EQ(joined(scene, voxelOptions(), 1), scene.objects) << "all";
  EXPECT_EQ(joined(scene, voxelOptions(), 2), scene.objects) << "the board";
  for (auto& object : scene.objects)
    object = 3 - object;
  EXPECT_EQ(joined(scene, voxelOptions(), 2), scene.objects) << "the top";
  auto part = desk(); // of both segments, the front is left out
  const auto voxels = voxelsOf(part);
  std::vector<std::uint32_t> before(voxels.size());
  for (std::size_t i = 0; i < part.points.size(); ++i)
    before[voxels.cells.cell_of_point[i]] = part.objects[i];
  std::vector<std::uint8_t> left_out;
  for (const auto& place : voxels.centroids)
    left_out.push_back(place.y() < 5 * voxel_size);
  auto after = before;
  joinUprights(voxels, left_out, voxelOptions(), after);
  std::vector<std::uint32_t> rest;
  for (std::size_t v = 0; v < voxels.size(); ++v)
    if (left_out[v])
      EXPECT_EQ(after[v], before[v]);
    else
      rest.push_back(after[v]);
  EXPECT_EQ(segmentCount(rest), 1u);
}

TEST(UprightUnions, OrderOfPointsAndNumbersChangesNothing)
{
  auto scene = desk();
  addBlock(scene, {38, 0, 0}, {40, 2, 20}, along_y, 3);  // a leg
  addBlock(scene, {20, 0, 0}, {30, 20, 20}, along_y, 4); // drawers
  addBlock(scene, {0, 4, 21}, {1, 16, 31}, along_x, 5);  // stands on the top
  const auto labels = joined(scene);
  EXPECT_EQ(segmentCount(labels), 3u);
  std::mt19937 rng(3);
  LabelledPoints shuffled;
  std::vector<std::uint32_t> expected;
  for (const auto i : shuffledOrder(scene.points.size(), rng)) {
    shuffled.points.push_back(scene.points[i]);
    shuffled.normals.push_back(scene.normals[i]);
    shuffled.objects.push_back(7 * scene.objects[i] % 11); // 7, 3, 10, 6, 2
    expected.push_back(labels[i]);
  }
  EXPECT_EQ(renamed(joined(shuffled)), renamed(expected));
}

TEST(UprightUnions, TakeTheSmallestSegments)
{
  LabelledPoints scene;
  addBlock(scene, {0, 0, 0}, {1, 1, 1}, along_x, 0);
  EXPECT_EQ(joined(scene), scene.objects) << "nothing but a voxel";
  auto options = voxelOptions();
  options.min_height = 0;
  EXPECT_EQ(joined(scene, options), scene.objects);
  addBlock(scene, {0, 0, 1}, {1, 1, 2}, along_z, 1);
  EXPECT_EQ(countOf(scene), 2u);
  EXPECT_EQ(countOf(scene, options), 1u) << "a voxel carries a voxel";
  auto rod = deskTop();
  addBlock(rod, {20, 10, 10}, {21, 11, 20}, Eigen::Vector3f::Zero(), 2); // no normals
  EXPECT_EQ(countOf(rod), 1u);
  auto sheet = deskTop(); // two flat segments, one on the other
  addBlock(sheet, {0, 0, 19}, {40, 20, 20}, along_z, 2);
  EXPECT_EQ(countOf(sheet, options), 2u);
}

TEST(UprightUnions, RefuseWrongInput)
{
  const auto voxels = voxelsOf(desk());
  std::vector<std::uint32_t> segments(voxels.size(), 0);
  const std::vector<std::uint8_t> left_out(voxels.size(), 0);
  EXPECT_NO_THROW(joinUprights(voxels, left_out, voxelOptions(), segments));
  const auto expectRefused = [&](double UprightUnionOptions::*option, double value) {
    auto options = voxelOptions();
    options.*option = value;
    EXPECT_THROW(joinUprights(voxels, left_out, options, segments),
                 pcl::BadArgumentException)
        << value;
  };
  for (const auto option : {&UprightUnionOptions::voxel_size,
                            &UprightUnionOptions::max_thickness,
                            &UprightUnionOptions::min_height,
                            &UprightUnionOptions::min_cover,
                            &UprightUnionOptions::min_level,
                            &UprightUnionOptions::max_above,
                            &UprightUnionOptions::min_overlap}) {
    expectRefused(option, -1);
    expectRefused(option, std::nan(""));
  }
  for (const double share : {0.0, 1.1}) {
    expectRefused(&UprightUnionOptions::min_cover, share);
    expectRefused(&UprightUnionOptions::min_level, share);
    expectRefused(&UprightUnionOptions::min_overlap, share);
  }
  expectRefused(&UprightUnionOptions::voxel_size, 0);
  expectRefused(&UprightUnionOptions::max_thickness, 0);
  auto options = voxelOptions();
  options.up = {0, 0, 0.5f};
  EXPECT_THROW(joinUprights(voxels, left_out, options, segments),
               pcl::BadArgumentException);
  EXPECT_THROW(joinUprights(voxels, {}, {}, segments), pcl::BadArgumentException);
  std::vector<std::uint32_t> none;
  EXPECT_THROW(joinUprights(voxels, left_out, {}, none), pcl::BadArgumentException);
  EXPECT_NO_THROW(joinUprights({}, {}, {}, none));
  EXPECT_THROW(joinUprights(surfaceVoxels(desk().points, {}, voxel_size),
                            left_out,
                            voxelOptions(),
                            segments),
               pcl::BadArgumentException)
      << "without normals";
}

} // namespace
