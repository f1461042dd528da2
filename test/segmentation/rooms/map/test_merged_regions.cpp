/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/region_borders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <tuple>

using namespace pcl::indoor;
using Labels = std::vector<std::int32_t>;

namespace {

/** mergeOpenRegions() with all borders looked at, and all labels, at each step. */
Labels
mergedSlowly(std::vector<RegionBorder> borders,
             std::vector<double> section,
             double open_share,
             const StayApart& stay_apart)
{
  Labels label(section.size());
  std::iota(label.begin(), label.end(), 0);
  const auto regionsOf = [&](std::int32_t space) {
    Labels regions;
    for (std::size_t i = 0; i < label.size(); ++i)
      if (label[i] == space)
        regions.push_back(static_cast<std::int32_t>(i));
    return regions;
  };
  std::set<std::pair<std::int32_t, std::int32_t>> apart;
  while (true) {
    const RegionBorder* widest = nullptr;
    double most = open_share;
    for (const auto& each : borders) {
      const double share =
          each.open_area /
          std::max(each.border_area, std::min(section[each.a], section[each.b]));
      if (share > most && apart.count({each.a, each.b}) == 0) {
        most = share;
        widest = &each;
      }
    }
    if (widest == nullptr)
      return label;
    const auto kept = widest->a, gone = widest->b;
    if (stay_apart(regionsOf(kept), regionsOf(gone))) {
      apart.insert({kept, gone});
      continue;
    }
    for (auto pair = apart.begin(); pair != apart.end();)
      pair = pair->first == kept || pair->second == kept || pair->first == gone ||
                     pair->second == gone
                 ? apart.erase(pair)
                 : std::next(pair);
    section[kept] = std::max(section[kept], section[gone]);
    std::replace(label.begin(), label.end(), gone, kept);
    std::map<std::pair<std::int32_t, std::int32_t>, RegionBorder> joined;
    for (const auto& each : borders) {
      const auto a = label[each.a], b = label[each.b];
      if (a == b)
        continue;
      auto& sum = joined[std::minmax(a, b)];
      std::tie(sum.a, sum.b) = std::minmax(a, b);
      sum.border_area += each.border_area;
      sum.opening_area += each.opening_area;
      sum.open_area += each.open_area;
    }
    borders.clear();
    for (const auto& pair : joined)
      borders.push_back(pair.second);
  }
}

} // namespace

TEST(MergedRegions, EqualsBruteForceWithSpacesThatStayApart)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 300; ++trial) {
    const int count = 2 + rng() % 20;
    std::vector<RegionBorder> borders;
    for (int a = 1; a <= count; ++a)
      for (int b = a + 1; b <= count; ++b)
        if (rng() % 3 == 0) {
          RegionBorder border;
          border.a = a;
          border.b = b;
          border.border_area = 2.0;
          border.open_area = 0.25 * (rng() % 8); // few values: equal shares
          border.opening_area = border.open_area;
          borders.push_back(border);
        }
    std::vector<double> section{0.0};
    for (int a = 1; a <= count; ++a)
      section.push_back(0.5 * (1 + rng() % 8));
    const unsigned salt = rng();
    const auto stay_apart = [salt](const Labels& a, const Labels& b) {
      return (a.size() * 7 + b.size() * 13 + a.back() + b.back() + salt) % 3 == 0;
    };
    MergeOptions options;
    options.open_share = 0.3;
    options.door_width = 0.0;
    EXPECT_EQ(mergeOpenRegions(borders, section, options, stay_apart),
              mergedSlowly(borders, section, 0.3, stay_apart))
        << "trial " << trial;
  }
}
