/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "objects/segment_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

using namespace pcl::indoor;

namespace {

/** Points that are in voxels and segments of these numbers. */
DetailedSegmentation
segmentationOf(const std::vector<std::uint32_t>& voxel_of_point,
               std::uint32_t voxel_count,
               const std::vector<std::uint32_t>& segment_of_point)
{
  DetailedSegmentation result;
  auto& cells = result.scene.voxels.cells;
  cells.keys.resize(voxel_count);
  cells.cell_of_point = voxel_of_point;
  listPoints(cells);
  result.scene.plane_of_voxel.assign(voxel_count, 0);
  result.segment_of_point = segment_of_point;
  return result;
}

} // namespace

TEST(SegmentNames, WhatHasTooFewVoxelsOrPointsIsTheRemainder)
{
  ObjectSegmentationOptions options; // 16 voxels
  options.voxel_size = 0.03;
  options.seed_size = 0.12;
  options.fewest_points = 30;
  std::mt19937 rng(5);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<std::uint32_t> voxels, segments;
    std::map<std::uint32_t, std::set<std::uint32_t>> voxels_of;
    std::map<std::uint32_t, std::uint32_t> points_of;
    for (int i = 0; i < 400; ++i) {
      segments.push_back(rng() % 12);
      voxels.push_back(rng() % (4 + 3 * segments.back()));
      voxels_of[segments.back()].insert(voxels.back());
      ++points_of[segments.back()];
    }
    auto result = segmentationOf(voxels, 40, segments);
    nameSegments(options, result);
    std::size_t in_remainder = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const bool is_small =
          voxels_of[segments[i]].size() < 16 || points_of[segments[i]] < 30;
      in_remainder += is_small;
      EXPECT_EQ(result.structure_of_segment[result.segment_of_point[i]],
                is_small ? StructureKind::Remainder : StructureKind::None);
    }
    EXPECT_GT(in_remainder, 0u);
    EXPECT_LT(in_remainder, segments.size());
  }
}

TEST(SegmentNames, ACabinetWithMostOfAWallIsAnObject)
{
  // Voxel 0 is of a short wall, most of whose points the cabinet got; 1 of the cabinet.
  std::vector<std::uint32_t> voxels(10, 0), segments(10, 0);
  std::fill_n(segments.begin(), 7, 1u);
  voxels.insert(voxels.end(), 12, 1u);
  segments.insert(segments.end(), 12, 1u);
  auto result = segmentationOf(voxels, 2, segments);
  result.segment_count = 2;
  result.scene.plane_of_voxel[0] = 1;
  result.scene.planes.push_back({Eigen::Vector3d::UnitX(), 0, {0}});
  using Kinds = std::vector<StructureKind>;
  EXPECT_EQ(structureOfSegments(result),
            (Kinds{StructureKind::Wall, StructureKind::None}));
  std::fill_n(result.segment_of_point.begin(), 10, 1u);
  EXPECT_EQ(structureOfSegments(result),
            (Kinds{StructureKind::None, StructureKind::None}))
      << "all of the wall";
  result.scene.plane_of_voxel[1] = 1;
  EXPECT_EQ(structureOfSegments(result),
            (Kinds{StructureKind::None, StructureKind::Wall}))
      << "a wall";
}

TEST(SegmentNames, ASeedOfManyVoxelsTakesNoLonger)
{
  ObjectSegmentationOptions options;
  options.voxel_size = 0.001;
  options.seed_size = 1; // a million voxels
  std::vector<std::uint32_t> voxels(500000);
  for (std::uint32_t i = 0; i < voxels.size(); ++i)
    voxels[i] = i;
  auto result = segmentationOf(voxels, 500000, std::vector<std::uint32_t>(500000, 0));
  nameSegments(options, result);
  EXPECT_EQ(result.structure_of_segment,
            std::vector<StructureKind>(1, StructureKind::Remainder));
}
