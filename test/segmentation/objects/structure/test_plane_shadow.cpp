/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "objects/structure/plane_shadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <set>
#include <utility>

using namespace pcl::indoor;

namespace {

struct Mark {
  PlaneCell cell;
  PlaneShadow::Flag flag;
};

struct End {
  PlaneCell cell;
  PlaneShadow::Side side;
};

const PlaneShadow::Side sides[] = {PlaneShadow::LowColumns,
                                   PlaneShadow::HighColumns,
                                   PlaneShadow::LowRows,
                                   PlaneShadow::HighRows};

/** A small raster with marks, some of them outside. */
struct ShadowScene {
  PlaneCell low{}, high{};
  std::vector<Mark> marks;
  std::vector<End> ends;

  bool
  isMarked(const PlaneCell& cell, PlaneShadow::Flag flag) const
  {
    return std::any_of(marks.begin(), marks.end(), [&](const Mark& mark) {
      return mark.flag == flag && std::abs(mark.cell[0] - cell[0]) <= 1 &&
             std::abs(mark.cell[1] - cell[1]) <= 1;
    });
  }

  bool
  isSeen(const PlaneCell& cell) const
  {
    return std::any_of(marks.begin(), marks.end(), [&](const Mark& mark) {
      return mark.cell == cell;
    });
  }

  bool
  endsAt(const PlaneCell& cell, PlaneShadow::Side side) const
  {
    return std::any_of(ends.begin(), ends.end(), [&](const End& end) {
      return end.cell == cell && end.side == side;
    });
  }

  bool
  isWithin(const PlaneCell& cell) const
  {
    return cell[0] >= low[0] && cell[0] <= high[0] && cell[1] >= low[1] &&
           cell[1] <= high[1];
  }
};

ShadowScene
randomScene(std::int64_t max_size, std::mt19937& rng)
{
  const auto random = [&](std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(rng() % static_cast<unsigned>(high - low));
  };
  ShadowScene scene;
  for (int k = 0; k < 2; ++k) {
    scene.low[k] = random(-20, 20);
    scene.high[k] = scene.low[k] + random(0, max_size);
  }
  const auto add = [&](std::int64_t count, PlaneShadow::Flag flag) {
    for (; count > 0; --count)
      scene.marks.push_back({{random(scene.low[0] - 3, scene.high[0] + 4),
                              random(scene.low[1] - 3, scene.high[1] + 4)},
                             flag});
  };
  add(random(0, 40), PlaneShadow::covered);
  add(random(0, 16), PlaneShadow::closing);
  for (auto count = random(0, 12); count > 0; --count)
    scene.ends.push_back({{random(scene.low[0], scene.high[0] + 1),
                           random(scene.low[1], scene.high[1] + 1)},
                          sides[rng() % 4]});
  return scene;
}

/** The cells of a raster that are open, found by looking at all until none changes. */
class OpenCells {
public:
  explicit OpenCells(const ShadowScene& scene)
  : scene_(scene)
  {
    for (bool changes = true; changes;) {
      changes = false;
      for (auto row = scene.low[1]; row <= scene.high[1]; ++row)
        for (auto column = scene.low[0]; column <= scene.high[0]; ++column)
          if (isOpened({column, row}) && open_.insert({column, row}).second)
            changes = true;
    }
  }

  bool
  contain(const PlaneCell& cell) const
  {
    return !scene_.isWithin(cell) || open_.count(cell) > 0;
  }

private:
  bool
  isOpened(const PlaneCell& cell) const
  {
    if (scene_.isMarked(cell, PlaneShadow::closing))
      return false;
    const auto opens = [&](int column, int row, PlaneShadow::Side side) {
      return contain({cell[0] + column, cell[1] + row}) && !scene_.endsAt(cell, side);
    };
    return !scene_.isMarked(cell, PlaneShadow::covered) ||
           opens(-1, 0, PlaneShadow::LowColumns) ||
           opens(1, 0, PlaneShadow::HighColumns) ||
           opens(0, -1, PlaneShadow::LowRows) || opens(0, 1, PlaneShadow::HighRows);
  }

  const ShadowScene& scene_;
  std::set<PlaneCell> open_;
};

std::vector<PlaneCell>
enclosedCells(const ShadowScene& scene)
{
  const OpenCells open(scene);
  const auto is_enclosed = [&](const PlaneCell& cell) {
    return !open.contain(cell) && scene.isMarked(cell, PlaneShadow::covered);
  };
  const auto is_among = [&](const PlaneCell& cell) {
    for (int row = -1; row <= 1; ++row)
      for (int column = -1; column <= 1; ++column)
        if (!is_enclosed({cell[0] + column, cell[1] + row}))
          return false;
    return true;
  };
  std::vector<PlaneCell> cells;
  for (auto row = scene.low[1]; row <= scene.high[1]; ++row)
    for (auto column = scene.low[0]; column <= scene.high[0]; ++column) {
      const PlaneCell cell{column, row};
      if (is_enclosed(cell) && (scene.isSeen(cell) || is_among(cell)))
        cells.push_back(cell);
    }
  return cells;
}

} // namespace

TEST(PlaneShadow, EnclosedCellsAreThoseThatNoWayLeadsTo)
{
  std::mt19937 rng(11);
  std::size_t enclosed = 0, covered = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto scene = randomScene(trial % 2 ? 16 : 4, rng);
    PlaneShadow shadow(scene.low, scene.high);
    for (const auto& mark : scene.marks)
      shadow.mark(mark.cell, mark.flag);
    for (const auto& end : scene.ends)
      shadow.end(end.cell, end.side);
    const auto expected = enclosedCells(scene);
    auto found = shadow.enclosed();
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return std::make_pair(a[1], a[0]) < std::make_pair(b[1], b[0]);
    });
    ASSERT_EQ(found, expected) << trial;
    enclosed += found.size();
    for (auto row = scene.low[1]; row <= scene.high[1]; ++row)
      for (auto column = scene.low[0]; column <= scene.high[0]; ++column) {
        covered += scene.isMarked({column, row}, PlaneShadow::covered);
      }
  }
  EXPECT_GT(enclosed, 3000u);
  EXPECT_GT(covered, 3 * enclosed / 2) << "there are open sides, too";
}

TEST(PlaneShadow, NothingIsEnclosedWithoutMarks)
{
  PlaneShadow shadow({-1, 5}, {3, 7});
  EXPECT_TRUE(shadow.enclosed().empty());
  shadow.mark({1, 6}, PlaneShadow::covered);
  EXPECT_TRUE(shadow.enclosed().empty());
  shadow.mark({1, 6}, PlaneShadow::closing);
  EXPECT_EQ(shadow.enclosed().size(), 1u) << "nothing was seen around it";
  EXPECT_EQ(shadow.enclosed().front(), (PlaneCell{1, 6}));
}

TEST(PlaneShadow, WhatIsCoveredAllOverIsEnclosedByARing)
{
  const auto enclosed_by = [](const std::vector<PlaneCell>& ring) {
    PlaneShadow shadow({0, 0}, {10, 8});
    shadow.coverAll();
    for (const auto& cell : ring)
      shadow.mark(cell, PlaneShadow::closing);
    return shadow.enclosed().size();
  };
  std::vector<PlaneCell> ring;
  for (std::int64_t k = 1; k <= 9; ++k)
    for (std::int64_t row : {1, 7})
      ring.push_back({k, row});
  for (std::int64_t k = 2; k <= 6; ++k)
    for (std::int64_t column : {1, 9})
      ring.push_back({column, k});
  EXPECT_EQ(enclosed_by(ring), 9u * 7u);
  ring.resize(ring.size() - 6); // their neighbours leave one cell open on both sides
  EXPECT_LT(enclosed_by(ring), 40u);
}
