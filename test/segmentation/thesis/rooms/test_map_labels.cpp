/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/map_labels.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>

using pcl::indoor::label_voters;
using pcl::indoor::PixelMap;
using pcl::indoor::voter_reach;
using pcl::indoor::VoxelMap;

namespace {

struct Scene {
  VoxelMap<std::uint8_t> occupancy, interior;
  PixelMap<int> labels;
};

Scene
randomScene(int nx, int ny, int nz, std::mt19937& rng)
{
  Scene scene;
  scene.occupancy.shape = scene.interior.shape = {nx, ny, nz};
  const unsigned sparsity = 1 + rng() % 6;
  for (std::size_t i = 0; i < scene.occupancy.shape.size(); ++i) {
    scene.occupancy.values.push_back(rng() % 3 == 0);
    // some voxels are both, which must count as occupied
    scene.interior.values.push_back(rng() % sparsity == 0);
  }
  scene.labels = {nx, ny, {}};
  for (std::size_t i = 0; i < scene.labels.size(); ++i)
    scene.labels.values.push_back(static_cast<int>(rng() % 4) - 1);
  return scene;
}

int
majorityBruteForce(const Scene& s, int x, int y, int z)
{
  std::vector<std::pair<int, int>> candidates; // squared distance, label
  const auto& shape = s.occupancy.shape;
  for (int u = 0; u < shape.nx; ++u)
    for (int v = 0; v < shape.ny; ++v)
      for (int w = 0; w < shape.nz; ++w) {
        const int d = (u - x) * (u - x) + (v - y) * (v - y) + (w - z) * (w - z);
        if (s.interior.at(u, v, w) && !s.occupancy.at(u, v, w) &&
            s.labels.at(u, v) >= 0 && d <= voter_reach * voter_reach)
          candidates.emplace_back(d, s.labels.at(u, v));
      }
  std::sort(candidates.begin(), candidates.end());
  std::map<int, std::array<int, 2>> tally; // label: votes, sum of distances
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (k >= label_voters && candidates[k].first > candidates[label_voters - 1].first)
      break;
    ++tally[candidates[k].second][0];
    tally[candidates[k].second][1] += candidates[k].first;
  }
  int best = -1;
  for (const auto& [label, count] : tally)
    if (best < 0 || count[0] > tally[best][0] ||
        (count[0] == tally[best][0] && count[1] < tally[best][1]))
      best = label;
  return best;
}

} // namespace

TEST(LabelVoxels, EqualsBruteForce)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 60; ++trial) {
    auto scene = trial % 2 == 0
                     ? randomScene(1 + rng() % 9, 1 + rng() % 9, 1 + rng() % 5, rng)
                     : randomScene(40, 1 + rng() % 3, 1 + rng() % 2, rng);
    if (trial % 2 == 1) // many voxels are far from all labels
      for (std::size_t i = 0; i < scene.labels.size(); ++i)
        if (i >= scene.labels.size() / 8)
          scene.labels.values[i] = -1;
    const auto result =
        pcl::indoor::labelVoxels(scene.occupancy, scene.interior, scene.labels);
    const auto& shape = result.shape;
    for (int x = 0; x < shape.nx; ++x)
      for (int y = 0; y < shape.ny; ++y)
        for (int z = 0; z < shape.nz; ++z) {
          int expected = scene.interior.at(x, y, z) ? scene.labels.at(x, y) : -1;
          if (scene.occupancy.at(x, y, z))
            expected = majorityBruteForce(scene, x, y, z);
          ASSERT_EQ(result.at(x, y, z), expected) << "trial " << trial;
        }
    EXPECT_EQ(pcl::indoor::labelVoxels(scene.occupancy, scene.interior, scene.labels, 7)
                  .values,
              result.values);
  }
}

TEST(LabelVoxels, RejectsBadInput)
{
  std::mt19937 rng(2);
  auto scene = randomScene(3, 4, 2, rng);
  scene.labels = {4, 3, std::vector<int>(12)};
  EXPECT_THROW(pcl::indoor::labelVoxels(scene.occupancy, scene.interior, scene.labels),
               pcl::BadArgumentException);
  EXPECT_TRUE(pcl::indoor::labelVoxels({}, {}, {}).values.empty());
}

TEST(LabelPeaks, NumbersWhatWasLeftOut)
{
  const PixelMap<float> field{3,
                              4,
                              {5,
                               5,
                               0,
                               7,
                               5,
                               1,
                               0,
                               7, //
                               0,
                               6,
                               0,
                               2}};
  const PixelMap<int> labels{3,
                             4,
                             {-1,
                              -1,
                              -1,
                              0, //
                              -1,
                              -1,
                              -1,
                              -1, //
                              -1,
                              -1,
                              -1,
                              -1}};
  const auto label = [&](float threshold, std::size_t size) {
    return pcl::indoor::labelPeaks(labels, field, threshold, size).values;
  };
  EXPECT_EQ(label(5.0f, 1),
            (std::vector<int>{1, 1, -1, 0, 1, -1, -1, -1, -1, 1, -1, -1}));
  EXPECT_EQ(label(5.0f, 4),
            (std::vector<int>{1, 1, -1, 0, 1, -1, -1, -1, -1, 1, -1, -1}));
  EXPECT_EQ(label(5.0f, 5), labels.values);
  EXPECT_EQ(label(8.0f, 1), labels.values);
  EXPECT_THROW(pcl::indoor::labelPeaks(labels, {}, 1.0f), pcl::BadArgumentException);
  EXPECT_TRUE(pcl::indoor::labelPeaks({}, {}, 1.0f).values.empty());
}

TEST(LabelPeaks, TheSlopesOfAClusterAreNoPeak)
{
  // a room whose middle is labelled, a low door, a room that was left out
  const PixelMap<float> field{1, 12, {2, 4, 6, 6, 4, 2, 1, 3, 5, 5, 3, 1}};
  const PixelMap<int> labels{1, 12, {-1, -1, 0, -1, -1, -1, -1, -1, -1, -1, -1, -1}};
  EXPECT_EQ(pcl::indoor::labelPeaks(labels, field, 1.0f).values,
            (std::vector<int>{-1, -1, 0, -1, -1, -1, -1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(pcl::indoor::labelPeaks(labels, field, 4.0f).values,
            (std::vector<int>{-1, -1, 0, -1, -1, -1, -1, -1, 1, 1, -1, -1}));
  EXPECT_EQ(pcl::indoor::labelPeaks(labels, field, 4.0f, 3).values, labels.values);
}
