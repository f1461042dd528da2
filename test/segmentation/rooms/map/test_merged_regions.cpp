/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/region_borders.h"
#include "support/room_labels.h"

#include <pcl/segmentation/building_rooms.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <tuple>

using namespace pcl::indoor;
using RegionLabels = std::vector<std::int32_t>;

namespace {

/** mergeOpenRegions() with all borders looked at, and all labels, at each step. */
RegionLabels
mergedSlowly(std::vector<RegionBorder> borders,
             std::vector<double> section,
             double open_share,
             const StayApart& stay_apart)
{
  RegionLabels label(section.size());
  std::iota(label.begin(), label.end(), 0);
  const auto regionsOf = [&](std::int32_t space) {
    RegionLabels regions;
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

RegionOpening
openingOf(std::int32_t a, std::int32_t b, double width)
{
  RegionOpening opening;
  opening.a = a;
  opening.b = b;
  opening.width = width;
  return opening;
}

TEST(MergedNiches, AreSmallHigherAndOpenOverAllTheirWidth)
{
  const auto merged = [](double width, double niche_height, double niche_area) {
    const auto labels = mergeNiches({openingOf(1, 2, width)},
                                    {0.0, niche_area, 100.0},
                                    {0.0, niche_area * niche_height, 250.0});
    EXPECT_EQ(labels[0], 0);
    EXPECT_EQ(labels[2], 2);
    return labels[1] == 2;
  };
  EXPECT_TRUE(merged(0.9, 3.0, 1.0));
  EXPECT_FALSE(merged(0.8, 3.0, 1.0)) << "a door";
  EXPECT_FALSE(merged(0.9, 2.5, 1.0)) << "as high";
  EXPECT_FALSE(merged(0.9, 2.3, 1.0)) << "lower";
  EXPECT_FALSE(merged(1.6, 3.0, 3.9));
  EXPECT_TRUE(merged(1.7, 3.0, 3.9));
  EXPECT_FALSE(merged(9.0, 3.0, 4.1)) << "large";
}

TEST(MergedNiches, OneBehindTheOther)
{
  const std::vector<RegionOpening> openings = {openingOf(1, 2, 1.0),
                                               openingOf(2, 3, 1.3)};
  // 2 is higher than 1, and both together are higher than 3
  EXPECT_EQ(mergeNiches(openings, {0, 1, 1, 50}, {0, 2.8, 3.0, 125}),
            (std::vector<std::int32_t>{0, 3, 3, 3}));
  EXPECT_EQ(mergeNiches({}, {0, 1, 1}, {0, 3, 2}),
            (std::vector<std::int32_t>{0, 1, 2}));
}

TEST(MergedNiches, UnderACeilingThatMirrorsAreOneRoomWithTheCorridor)
{
  const Eigen::AlignedBox3f opening(Eigen::Vector3f(5.9f, 0.05f, -1.0f),
                                    Eigen::Vector3f(6.1f, 1.55f, 2.45f));
  const auto scene = test::rooms(
      {{{0, 0, 0}, {6, 1.6f, 2.5f}, 1}, {{6, 0, 0}, {7.5f, 1.6f, 3.1f}, 2}}, {opening});
  EXPECT_EQ(segmentBuilding(scene.points).rooms.size(), 1u);
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
    const auto stay_apart = [salt](const RegionLabels& a, const RegionLabels& b) {
      return (a.size() * 7 + b.size() * 13 + a.back() + b.back() + salt) % 3 == 0;
    };
    MergeOptions options;
    options.open_share = 0.3;
    EXPECT_EQ(mergeOpenRegions(borders, section, options, 0.0, stay_apart),
              mergedSlowly(borders, section, 0.3, stay_apart))
        << "trial " << trial;
  }
}
