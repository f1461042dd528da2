/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/voted_structure.h"

#include <pcl/segmentation/object_segmentation.h>

#include <gtest/gtest.h>

#include <set>

using namespace pcl::indoor;

namespace {

TEST(VotedStructure, WhatHardlyAnybodyTakesForTheBuildingLeavesItsPlane)
{
  VoxelClasses votes;
  votes.class_count = 5; // two of objects
  votes.probabilities = {0.0f, 0.1f, 0.0f, 0.6f, 0.3f, 0.0f, 0.2f, 0.0f, 0.4f, 0.4f};
  votes.voxel_of_point = {0, 1, 0, 1};
  std::vector<std::uint32_t> planes = {1, 1, 0, 2};
  yieldToVotes(votes, planes);
  EXPECT_EQ(planes, (std::vector<std::uint32_t>{0, 1, 0, 2}));
}

/** A floor, two boards of a wall that is no plane of the room, and a box. */
class ScanOfParts : public testing::Test {
protected:
  void
  SetUp() override
  {
    constexpr float step = 0.02f;
    const auto board = [&](float x, float z, float width, float height) {
      for (float u = 0; u < width; u += step)
        for (float v = 0; v < height; v += step)
          input.points.emplace_back(x + u, 0.0f, z + v);
    };
    for (float x = 0; x < 4; x += step)
      for (float y = 0; y < 3; y += step)
        input.points.emplace_back(x, y, 0.0f);
    floor_count = input.points.size();
    board(0.5f, 0.6f, 0.8f, 0.9f);
    board(2.5f, 0.6f, 0.8f, 0.9f);
    boards_end = input.points.size();
    for (float u = 0; u < 0.8f; u += step)
      for (float v = 0; v < 0.6f; v += step) {
        input.points.emplace_back(1.6f + u, 1.2f + v, 0.7f);
        input.points.emplace_back(1.6f + u, 1.2f, 0.1f + v);
        input.points.emplace_back(1.6f, 1.2f + v, 0.1f + v);
      }
    input.voter.classify = [this](const std::vector<Eigen::Vector3f>& points) {
      VoxelClasses votes;
      votes.class_count = 4;
      votes.to_middle.assign(points.size(), Eigen::Vector3f::Zero());
      for (std::uint32_t i = 0; i < points.size(); ++i) {
        votes.voxel_of_point.push_back(i);
        const float wall = i >= floor_count && i < boards_end ? 0.6f : 0.0f;
        const float floor = i < floor_count ? share_of_floor : 0.0f;
        for (const float share : {floor, wall, 0.0f, 1.0f - floor - wall})
          votes.probabilities.push_back(share);
      }
      return votes;
    };
  }

  std::set<StructureKind>
  kindsOf(const ObjectSegmentation& result, std::size_t first, std::size_t end) const
  {
    std::set<StructureKind> kinds;
    for (auto i = first; i < end; ++i)
      kinds.insert(result.structure_of_segment[result.segment_of_point[i]]);
    return kinds;
  }

  ObjectSegmentationInput input;
  float share_of_floor = 1.0f;
  std::size_t floor_count = 0, boards_end = 0;
};

TEST_F(ScanOfParts, BoardsThatAreVotedToBeAWallAreOne)
{
  const auto count = input.points.size();
  auto alone = input;
  alone.voter = {};
  EXPECT_EQ(kindsOf(segmentObjects(alone, {}), floor_count, boards_end),
            std::set<StructureKind>{StructureKind::None});
  const auto result = segmentObjects(input, {});
  EXPECT_EQ(kindsOf(result, floor_count, boards_end),
            std::set<StructureKind>{StructureKind::Wall});
  EXPECT_EQ(result.segment_of_point[floor_count],
            result.segment_of_point[boards_end - 1]);
  EXPECT_EQ(kindsOf(result, boards_end, count),
            std::set<StructureKind>{StructureKind::None});
}

TEST_F(ScanOfParts, AFloorThatIsVotedToBeAnObjectIsNone)
{
  const auto floorOf = [&](const ObjectSegmentation& result) {
    return result.structure_of_segment[result.segment_of_point[floor_count / 2]];
  };
  share_of_floor = 0.2f; // little, but there is the plane
  EXPECT_EQ(floorOf(segmentObjects(input, {})), StructureKind::Floor);
  share_of_floor = 0.1f;
  EXPECT_EQ(floorOf(segmentObjects(input, {})), StructureKind::None);
}

} // namespace
