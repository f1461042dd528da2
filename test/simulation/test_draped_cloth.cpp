/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "closed_shell.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace pcl::indoor;

// A box of 1.0 x 0.6 x 0.5 m in the middle of a room, with a blanket of 1.4 x 0.4 m
// over it whose hem is 0.2 m above the floor.
std::string
planWith(const std::string& blanket)
{
  return R"({"name": "one room", "wall_thickness": 0.2, "storeys": [{
    "name": "ground", "elevation": 0, "ceiling_height": 2.6,
    "rooms": [{"name": "room", "polygon": [[0, 0], [5, 0], [5, 4], [0, 4]]}],
    "furniture": [{"class": "beam", "at": [2.5, 2], "elevation": 0,
                   "size": [1.0, 0.6, 0.5], "rotation": 30})" +
         blanket + "]}]}";
}

const std::string cloth = R"(, {"class": "blanket", "at": [2.5, 2], "rotation": 30,
  "size": [1.4, 0.4, 0.36], "elevation": 0.2, "seed": 4)";

const Building&
draped()
{
  static const Building building = buildText(planWith(cloth + R"(, "lies": "over"})"));
  return building;
}

// At the middle the cloth lies on the box, at most its thickness and folds above it.
TEST(DrapedCloth, LiesOnWhatIsBelow)
{
  const Prober probe(draped());
  for (const double x : {-0.4, -0.1, 0.0, 0.3}) {
    const Eigen::Vector3d from = Eigen::Vector3d(2.5, 2, 2) +
                                 Eigen::AngleAxisd(M_PI / 6, Eigen::Vector3d::UnitZ()) *
                                     Eigen::Vector3d(x, 0.01, 0);
    EXPECT_EQ(probe.category(from, {0, 0, -1}), "blanket") << x;
    const double height = 2 - probe.distance(from, {0, 0, -1});
    EXPECT_GT(height, 0.5) << x;
    EXPECT_LT(height, 0.5 + 0.061) << x;
  }
}

// It hangs down at the ends of the box, and ends at its hem.
TEST(DrapedCloth, HangsDownToItsHem)
{
  float lowest = 9, highest = 0, farthest = 0;
  const auto& building = draped();
  const auto blanket = building.category("blanket");
  for (std::size_t i = 0; i < building.triangles.size(); ++i)
    if (building.surfaces[i].labels.category == blanket)
      for (const auto& p : {building.triangles[i].a, building.triangles[i].b}) {
        lowest = std::min(lowest, p.z());
        highest = std::max(highest, p.z());
        farthest = std::max(farthest, (p.head<2>() - Eigen::Vector2f(2.5f, 2)).norm());
      }
  EXPECT_GE(lowest, 0.2f - 1e-5f);
  EXPECT_LT(lowest, 0.25f); // a steep fall ends within a cell of the hem
  EXPECT_LE(highest, 0.56f + 1e-5f);
  EXPECT_GT(farthest, 0.52f); // beyond the end of the box
  EXPECT_LT(farthest, 0.74f);
}

// Without support it is the class's own shape.
TEST(DrapedCloth, OverNothingItStaysAsItIs)
{
  const auto alone = buildText(planWith(
      R"(, {"class": "blanket", "at": [1.2, 3.2], "size": [1.4, 0.4, 0.36],
           "elevation": 0.2, "lies": "over"})"));
  const auto blanket = alone.category("blanket");
  EXPECT_TRUE(std::any_of(alone.surfaces.begin(),
                          alone.surfaces.end(),
                          [&](const auto& s) { return s.labels.category == blanket; }));
}

TEST(DrapedCloth, OnlyClothLiesOverObjects)
{
  EXPECT_THROW(
      buildText(planWith(R"(, {"class": "chair", "at": [1, 1], "lies": "over"})")),
      PlanError);
  EXPECT_THROW(
      buildText(planWith(R"(, {"class": "towel", "at": [1, 1], "lies": "over"})")),
      PlanError); // no size
  EXPECT_THROW(buildText(planWith(cloth + R"(, "lies": "under"})")), PlanError);
}

} // namespace
