/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/upright_scene.h"

#include <gtest/gtest.h>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

/** A seat (1), 0.625 m wide, and a back (2) behind it, both from below. */
LabelledPoints
chair(int first, int end, int bottom = 10)
{
  LabelledPoints scene;
  addBlock(scene, {1, 0, 14}, {20, 20, 15}, along_z, 1);
  addBlock(scene, {0, first, bottom}, {1, end, 40}, along_x, 2);
  return scene;
}

TEST(UprightBacks, JoinABackAsWideAsTheSeat)
{
  EXPECT_EQ(countOf(chair(0, 20)), 1u);
  EXPECT_EQ(countOf(chair(2, 18)), 1u) << "a bit less";
  EXPECT_EQ(countOf(chair(-2, 22)), 1u) << "a bit more";
  EXPECT_EQ(countOf(chair(0, 20, 15)), 1u) << "on the seat";
  EXPECT_EQ(countOf(chair(0, 20, 16)), 2u) << "above the seat";
  auto middle = deskTop(); // not at an end
  addBlock(middle, {20, 0, 21}, {21, 20, 40}, along_x, 2);
  EXPECT_EQ(countOf(middle), 1u);
}

TEST(UprightBacks, LeaveBacksOfAnotherWidthApart)
{
  EXPECT_EQ(countOf(chair(3, 17)), 2u);
  EXPECT_EQ(countOf(chair(-5, 25)), 2u);
  EXPECT_EQ(countOf(chair(6, 26)), 2u) << "shifted";
  auto options = voxelOptions();
  options.min_overlap = 0.6;
  EXPECT_EQ(countOf(chair(3, 17), options), 1u);
  EXPECT_EQ(countOf(chair(-5, 25), options), 1u);
}

TEST(UprightBacks, LeaveBacksOfWhatIsNotLevelApart)
{
  auto scene = chair(0, 20);
  addBlock(scene, {10, 0, 15}, {11, 20, 45}, along_x, 1); // 600 of 980 voxels
  EXPECT_EQ(countOf(scene), 2u);
  auto options = voxelOptions();
  options.min_level = 0.3;
  EXPECT_EQ(countOf(scene, options), 1u);
}

TEST(UprightBacks, LeaveBacksApartThatHardlyTouch)
{
  const auto with_bracket = [](int width) {
    auto scene = chair(0, 20);
    for (auto& point : scene.points)
      if (point.x() < voxel_size)
        point.x() -= 2 * voxel_size;
    addBlock(scene, {-1, 0, 14}, {1, width, 15}, along_z, 1);
    return scene;
  };
  EXPECT_EQ(countOf(with_bracket(9)), 1u);
  EXPECT_EQ(countOf(with_bracket(5)), 2u);
}

} // namespace
