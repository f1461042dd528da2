/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/indoor/disjoint_sets.h>
#include <pcl/indoor/flood_fill.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

using namespace pcl::indoor;

namespace {

constexpr std::uint32_t count = 60;

using Links = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Links
randomLinks(std::mt19937& rng)
{
  Links links;
  for (int i = 0; i < 40; ++i)
    links.emplace_back(rng() % count, rng() % count);
  return links;
}

Adjacency
neighborsOf(const Links& links)
{
  Adjacency neighbors;
  neighbors.offsets.push_back(0);
  for (std::uint32_t place = 0; place < count; ++place) {
    for (const auto& [a, b] : links)
      if (a == place || b == place)
        neighbors.targets.push_back(a == place ? b : a);
    neighbors.offsets.push_back(static_cast<std::uint32_t>(neighbors.targets.size()));
  }
  return neighbors;
}

} // namespace

TEST(FloodFill, ReachesThePlacesOfTheSameSet)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 100; ++trial) {
    const auto links = randomLinks(rng);
    DisjointSets sets(count);
    for (const auto& [a, b] : links)
      sets.merge(sets.find(a), sets.find(b));
    std::vector<char> seen(count, 0);
    std::vector<std::uint32_t> reached{static_cast<std::uint32_t>(trial) % count};
    seen[reached[0]] = 1;
    floodFill(reached, neighborsOf(links), [&](auto other, auto) {
      return !std::exchange(seen[other], 1);
    });
    std::vector<std::uint32_t> expected;
    for (std::uint32_t place = 0; place < count; ++place)
      if (sets.find(place) == sets.find(reached[0]))
        expected.push_back(place);
    std::sort(reached.begin(), reached.end());
    EXPECT_EQ(reached, expected) << trial;
  }
}

TEST(FloodFill, ReachesTheNearestFirst)
{
  // By relaxation: the fewest steps from one of two places.
  std::mt19937 rng(2);
  for (int trial = 0; trial < 100; ++trial) {
    const auto links = randomLinks(rng);
    std::vector<int> expected(count, -1);
    expected[3] = expected[40] = 0;
    for (int step = 0; step < static_cast<int>(count); ++step)
      for (const auto& [a, b] : links) {
        if (expected[a] == step && expected[b] < 0)
          expected[b] = step + 1;
        if (expected[b] == step && expected[a] < 0)
          expected[a] = step + 1;
      }
    std::vector<int> steps(count, -1);
    steps[3] = steps[40] = 0;
    std::vector<std::uint32_t> reached{3, 40};
    floodFill(reached, neighborsOf(links), [&](auto other, auto from) {
      if (steps[other] >= 0)
        return false;
      steps[other] = steps[from] + 1;
      return true;
    });
    EXPECT_EQ(steps, expected) << trial;
    EXPECT_TRUE(std::is_sorted(reached.begin(), reached.end(), [&](auto a, auto b) {
      return steps[a] < steps[b];
    }));
  }
}
