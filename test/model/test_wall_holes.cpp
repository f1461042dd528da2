/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "model/simulated_walls.h"

#include <pcl/model/wall_holes.h>

#include <gtest/gtest.h>

#include <random>

using namespace pcl::indoor;

namespace {

std::vector<FaceHole>
holesOf(const std::vector<SimulatedHole>& simulated)
{
  const auto points = simulatedSide(5.0, 2.6, simulated);
  return wallHoles(wallImage(points, 5.0, 0.0, 2.6), points);
}

/** A wall with a glazed front in a niche, as the side sees it that was fitted to the
 * frame of the glass: the niche's sides stand out of that plane.
 * \param[in] sides how many of left, right, above, below do
 * \param[in] objects before the plane, which hide it */
std::vector<FaceHole>
glassInNiche(const Eigen::AlignedBox2d& niche,
             int sides,
             const std::vector<SimulatedHole>& objects = {})
{
  constexpr double frame = 0.08, deep = 0.35; // metres
  const Eigen::AlignedBox2d glass(niche.min().array() + frame,
                                  niche.max().array() - frame);
  auto seen = objects;
  seen.push_back({glass, 0.0});
  auto points = simulatedSide(5.0, 2.6, seen);
  const auto add = [&](double u, double before, double v) {
    points.push_back(
        {static_cast<float>(u), static_cast<float>(before), static_cast<float>(v)});
  };
  for (double before = 0.0; before < deep; before += simulated_spacing) {
    for (double v = niche.min().y(); v < niche.max().y(); v += simulated_spacing) {
      add(niche.min().x(), before, v);
      if (sides > 1)
        add(niche.max().x(), before, v);
    }
    for (double u = niche.min().x(); u < niche.max().x(); u += simulated_spacing) {
      if (sides > 2)
        add(u, before, niche.max().y());
      if (sides > 3)
        add(u, before, niche.min().y());
    }
  }
  return wallHoles(wallImage(points, 5.0, 0.0, 2.6), points);
}

void
expectBox(const FaceHole& hole, const Eigen::AlignedBox2d& box)
{
  // edges are known to half of the points' spacing and half of a centimetre
  constexpr double known = 0.5 * simulated_spacing + 0.005 + 1e-6;
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(hole.box.min()[i], box.min()[i], known);
    EXPECT_NEAR(hole.box.max()[i], box.max()[i], known);
  }
}

} // namespace

TEST(WallHoles, AWindowIsWhereItWasMade)
{
  for (const double depth : {0.0, -0.05, -0.2}) {
    const auto box = rectangle(1.3, 0.9, 2.52, 2.1);
    const auto holes = holesOf({{box, depth}});
    ASSERT_EQ(holes.size(), 1u) << depth;
    expectBox(holes[0], box);
    EXPECT_FALSE(holes[0].is_proud);
    for (const double side : holes[0].framed)
      EXPECT_EQ(side, 1.0);
    EXPECT_NEAR(holes[0].depth, depth, 0.003);
    if (depth != 0.0)
      EXPECT_GT(holes[0].seen, 0.9);
    else
      EXPECT_EQ(holes[0].seen, 0.0);
  }
}

TEST(WallHoles, ALeafBeforeTheWallStandsProud)
{
  const auto box = rectangle(2.0, 0.0, 2.9, 2.0);
  const auto holes = holesOf({{box, 0.06}});
  ASSERT_EQ(holes.size(), 1u);
  expectBox(holes[0], box);
  EXPECT_TRUE(holes[0].is_proud);
}

TEST(WallHoles, AWindowBesideAGlazedDoorIsAnother)
{
  const auto door = rectangle(1.0, 0.0, 1.9, 2.1);
  const auto window = rectangle(1.9, 0.9, 3.1, 2.1);
  const auto holes = holesOf({{door, -0.1}, {window, -0.1}});
  ASSERT_EQ(holes.size(), 2u);
  // between them no face begins: the end is known to a cell and its surroundings
  EXPECT_NEAR(holes[0].box.max().x(), 1.9, 0.05);
  EXPECT_NEAR(holes[0].box.min().y(), 0.0, 0.02);
  EXPECT_NEAR(holes[1].box.min().x(), 1.9, 0.05);
  EXPECT_NEAR(holes[1].box.min().y(), 0.9, 0.02);
}

TEST(WallHoles, EdgesAmongFewPointsAreKnownToTheirSpacing)
{
  constexpr double spacing = 0.065, length = 5.0, height = 3.2, deep = 0.3; // metres
  const auto box = rectangle(1.75, 0.0, 3.25, 2.5);
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::normal_distribution<double> noise(0.0, 0.012);
    std::vector<WallPoint> points;
    const auto add = [&](double u, double before, double v) {
      points.push_back({static_cast<float>(u + noise(random)),
                        static_cast<float>(before + noise(random)),
                        static_cast<float>(v + noise(random))});
    };
    const auto count = [&](double area) {
      return static_cast<int>(area / (spacing * spacing));
    };
    for (int i = count(length * height); i > 0; --i) {
      const Eigen::Vector2d place(length * share(random), height * share(random));
      if (!box.contains(place))
        add(place.x(), 0.0, place.y());
    }
    for (const double side : {box.min().x(), box.max().x()}) // of the niche
      for (int i = count(deep * box.max().y()); i > 0; --i)
        add(side, -deep * share(random), box.max().y() * share(random));
    const auto holes = wallHoles(wallImage(points, length, 0.0, height), points);
    ASSERT_EQ(holes.size(), 1u) << seed;
    EXPECT_NEAR(holes[0].box.min().x(), box.min().x(), spacing) << seed;
    EXPECT_NEAR(holes[0].box.max().x(), box.max().x(), spacing) << seed;
    EXPECT_NEAR(holes[0].box.max().y(), box.max().y(), spacing) << seed;
  }
}

TEST(WallHoles, AFrameThatFillsANicheBelongsToTheWindow)
{
  const auto niche = rectangle(1.2, 0.4, 3.6, 2.4);
  auto holes = glassInNiche(niche, 4);
  ASSERT_EQ(holes.size(), 1u);
  expectBox(holes[0], niche);
  for (const double side : holes[0].framed)
    EXPECT_EQ(side, 1.0);
  holes = glassInNiche(niche, 3); // nothing stands out below: the glass ends there
  ASSERT_EQ(holes.size(), 1u);
  expectBox(holes[0], rectangle(1.2, 0.48, 3.6, 2.4));
}

TEST(WallHoles, WhatHidesTheEndOfANicheIsPartOfIt)
{
  const auto niche = rectangle(1.2, 0.4, 3.6, 2.4);
  const auto below = rectangle(1.2, 0.2, 3.6, 0.48); // a slab between two windows
  const auto holes = glassInNiche(niche, 3, {{below, 0.35}});
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_GT(holes[0].framed[3], 0.9);
}

TEST(WallHoles, ACornerBesideAWindowIsNoNiche)
{
  const auto niche = rectangle(1.2, 0.4, 3.6, 2.4);
  const auto holes = glassInNiche(niche, 2); // walls to both sides
  ASSERT_EQ(holes.size(), 1u);
  expectBox(holes[0], rectangle(1.28, 0.48, 3.52, 2.32));
}

TEST(WallHoles, APlainWallHasNone)
{
  EXPECT_TRUE(holesOf({}).empty());
  EXPECT_TRUE(holesOf({{rectangle(1.0, 1.0, 1.2, 1.2), 0.0}}).empty()); // too small
}
