/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "model/simulated_walls.h"

#include <pcl/model/model_openings.h>

#include <gtest/gtest.h>

using namespace pcl::indoor;

namespace {

WallFace
sideOf(std::uint32_t room, const Eigen::Vector2d& begin, const Eigen::Vector2d& end)
{
  WallFace face;
  face.room = room;
  face.begin = begin;
  face.end = end;
  face.ceiling = 2.6;
  face.is_seen = true;
  return face;
}

FaceHole
framedHole(const Eigen::AlignedBox2d& box, double seen)
{
  FaceHole hole;
  hole.box = box;
  hole.seen = seen;
  hole.depth = seen > 0.0 ? -0.1 : 0.0;
  hole.framed = {1.0, 1.0, 1.0, box.min().y() > 0.0 ? 1.0 : 0.0};
  return hole;
}

/** Both sides of a wall of 10 cm along x, and holes in them. */
std::vector<ModelOpening>
inInnerWall(const std::vector<FaceHole>& one,
            const std::vector<FaceHole>& other,
            const std::vector<RoomOpening>& passable = {})
{
  const std::vector<WallFace> faces{sideOf(1, {0.0, 0.1}, {4.0, 0.1}),
                                    sideOf(2, {4.0, 0.0}, {0.0, 0.0})};
  const std::vector<FaceHoles> holes{one, other};
  return modelOpenings(faces, facePairs(faces), holes, passable);
}

RoomOpening
passableAt(double x, double width)
{
  RoomOpening passable;
  passable.room_a = 1;
  passable.room_b = 2;
  passable.position = {x, 0.0, 0.1};
  passable.width = width;
  passable.area = 2.0 * width;
  return passable;
}

/** The only side of an outer wall. */
std::vector<ModelOpening>
inOuterWall(const FaceHole& hole)
{
  return modelOpenings({sideOf(1, {0.0, 0.0}, {4.0, 0.0})}, {}, {FaceHoles{hole}}, {});
}

} // namespace

TEST(ModelOpenings, AWindowInAnOuterWallIsSeenFromOneSide)
{
  const auto found = inOuterWall(framedHole(rectangle(1.0, 0.8, 2.4, 2.1), 0.9));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, ModelOpeningKind::Window);
  EXPECT_EQ(found[0].room_b, 0u);
  EXPECT_NEAR(found[0].position.x(), 1.7, 1e-9);
  EXPECT_NEAR(found[0].position.z(), 0.8, 1e-9);
  EXPECT_NEAR(found[0].sill, 0.8, 1e-9);
  EXPECT_NEAR(found[0].head(), 2.1, 1e-9);
  EXPECT_NEAR(found[0].width, 1.4, 1e-9);
}

TEST(ModelOpenings, PanesSideBySideAreOneWindow)
{
  const auto in_wall = [](double gap, double rise) {
    auto left = framedHole(rectangle(1.0, 0.8, 1.6, 2.1), 0.9);
    auto right =
        framedHole(rectangle(1.6 + gap, 0.8 + rise, 2.4 + gap, 2.1 + rise), 0.9);
    left.framed[0] = right.framed[1] = 0.8;
    return modelOpenings(
        {sideOf(1, {0.0, 0.0}, {4.0, 0.0})}, {}, {FaceHoles{right, left}}, {});
  };
  const auto found = in_wall(0.1, 0.02);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].width, 1.5, 1e-9);
  EXPECT_NEAR(found[0].position.x(), 1.75, 1e-9);
  EXPECT_NEAR(found[0].sill, 0.8, 1e-9);
  EXPECT_EQ(in_wall(0.3, 0.0).size(), 2u); // a pier
  EXPECT_EQ(in_wall(0.1, 0.2).size(), 2u); // one above the other
}

TEST(ModelOpenings, AWindowIsAtLeastHalfAMetreSquare)
{
  EXPECT_EQ(inOuterWall(framedHole(rectangle(1.0, 0.8, 1.5, 1.4), 0.9)).size(), 1u);
  EXPECT_TRUE(inOuterWall(framedHole(rectangle(1.0, 0.8, 1.4, 1.4), 0.9)).empty());
}

TEST(ModelOpenings, AGapToTheOutsideIsNoDoor)
{
  EXPECT_EQ(inOuterWall(framedHole(rectangle(1.0, 0.0, 1.8, 2.1), 0.9)).size(), 1u);
  EXPECT_TRUE(inOuterWall(framedHole(rectangle(1.0, 0.0, 1.6, 2.1), 0.9)).empty());
}

TEST(ModelOpenings, WhatNoFaceFramesOrObjectsHideIsNone)
{
  auto hole = framedHole(rectangle(1.0, 0.8, 2.4, 2.1), 0.9);
  hole.framed[2] = 0.2; // not above: the ceiling slopes
  EXPECT_TRUE(inOuterWall(hole).empty());
  hole = framedHole(rectangle(1.0, 0.8, 2.4, 2.1), 0.0);
  hole.framed[0] = 0.2; // nothing in it, and open at one side: a shadow
  EXPECT_TRUE(inOuterWall(hole).empty());
  hole = framedHole(rectangle(1.0, 0.8, 2.4, 2.1), 0.6);
  hole.hidden = 0.4;
  EXPECT_TRUE(inOuterWall(hole).empty());
}

TEST(ModelOpenings, ANicheInAnInnerWallIsNoWindow)
{
  const auto niche = framedHole(rectangle(1.0, 0.8, 2.4, 2.1), 0.9);
  EXPECT_TRUE(inInnerWall({niche}, {}).empty());
  const auto behind = framedHole(rectangle(1.6, 0.8, 3.0, 2.1), 0.9); // seen from there
  const auto found = inInnerWall({niche}, {behind});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, ModelOpeningKind::Window);
  EXPECT_EQ(found[0].room_a, 1u);
  EXPECT_EQ(found[0].room_b, 2u);
  EXPECT_NEAR(found[0].position.y(), 0.05, 1e-9); // in the middle of the wall
}

TEST(ModelOpenings, ADoorHasTheSizeOfADoor)
{
  const auto isDoor = [](const Eigen::AlignedBox2d& box) {
    const auto found = inInnerWall({framedHole(box, 0.9)}, {});
    return found.size() == 1 && found[0].kind == ModelOpeningKind::Door;
  };
  EXPECT_TRUE(isDoor(rectangle(1.0, 0.05, 1.9, 2.0)));
  EXPECT_FALSE(isDoor(rectangle(1.0, 0.0, 1.4, 2.0))); // too narrow
  EXPECT_FALSE(isDoor(rectangle(1.0, 0.0, 1.9, 1.5))); // too low
}

TEST(ModelOpenings, WhereOneCanPassTheImageTellsTheEdges)
{
  RoomOpening passable = passableAt(1.5, 0.8);
  const auto hole = framedHole(rectangle(1.02, 0.0, 1.92, 2.05), 0.0);
  auto found = inInnerWall({hole}, {}, {passable});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].is_open);
  EXPECT_EQ(found[0].kind, ModelOpeningKind::Door);
  EXPECT_NEAR(found[0].width, 0.9, 1e-9);
  EXPECT_NEAR(found[0].position.x(), 1.47, 1e-9);
  EXPECT_NEAR(found[0].height, 2.05, 1e-9);
  // a door elsewhere does not
  passable.position.x() = 3.3;
  found = inInnerWall({hole}, {}, {passable});
  ASSERT_FALSE(found.empty());
  EXPECT_NEAR(found[0].width, 0.8, 1e-9);
  EXPECT_NEAR(found[0].height, 2.0, 1e-9);
}

TEST(ModelOpenings, WideOnesWithoutALintelArePassages)
{
  const auto passable = passableAt(2.0, 2.0);
  // above a hole the ceiling is no lintel
  auto hole = framedHole(rectangle(1.0, 0.0, 3.0, 2.58), 0.0);
  EXPECT_EQ(inInnerWall({hole}, {}, {passable})[0].kind, ModelOpeningKind::Passage);
  hole = framedHole(rectangle(1.0, 0.0, 3.0, 2.1), 0.0);
  EXPECT_EQ(inInnerWall({hole}, {}, {passable})[0].kind, ModelOpeningKind::Door);
  // one side that shows it is enough, the better one or not
  auto other = hole;
  other.framed = {0.9, 0.9, 0.4, 0.0};
  hole.framed = {0.1, 0.1, 0.9, 0.0};
  other.box = rectangle(1.2, 0.0, 2.8, 2.1);
  const auto found = inInnerWall({hole}, {other}, {passable});
  EXPECT_NEAR(found[0].width, 1.6, 1e-9);
  EXPECT_EQ(found[0].kind, ModelOpeningKind::Door);
}

TEST(ModelOpenings, WhatNoImageShowsIsAPassage)
{
  EXPECT_EQ(inInnerWall({}, {}, {passableAt(2.0, 0.9)})[0].kind,
            ModelOpeningKind::Passage);
  // nor does one that is no door: too high, or wider than any gate
  auto hole = framedHole(rectangle(1.0, 0.0, 1.9, 2.5), 0.0);
  hole.box.max().y() = 3.3;
  EXPECT_EQ(inInnerWall({hole}, {}, {passableAt(1.45, 0.9)})[0].kind,
            ModelOpeningKind::Passage);
  hole = framedHole(rectangle(0.2, 0.0, 3.8, 2.1), 0.0);
  EXPECT_EQ(inInnerWall({hole}, {}, {passableAt(2.0, 3.6)})[0].kind,
            ModelOpeningKind::Passage);
}

TEST(ModelOpenings, WhereOneCanPassTheHoleGoesDownToTheFloor)
{
  // points of the floor fill the lower end of the hole
  auto hole = framedHole(rectangle(1.0, 0.2, 1.9, 2.1), 0.0);
  const auto found = inInnerWall({hole}, {}, {passableAt(1.45, 0.8)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, ModelOpeningKind::Door);
  EXPECT_NEAR(found[0].width, 0.9, 1e-9);
  EXPECT_NEAR(found[0].sill, 0.0, 1e-9);
  EXPECT_NEAR(found[0].height, 2.1, 1e-9);
  hole = framedHole(rectangle(1.0, 0.4, 1.9, 2.1), 0.0); // nobody passes through it
  EXPECT_EQ(inInnerWall({hole}, {}, {passableAt(1.45, 0.8)})[0].kind,
            ModelOpeningKind::Passage);
}

TEST(ModelOpenings, GlassAboveAKerbIsAWindow)
{
  const auto kindOf = [](double sill) {
    return inOuterWall(framedHole(rectangle(1.0, sill, 2.4, 2.1), 0.9)).at(0).kind;
  };
  EXPECT_EQ(kindOf(0.05), ModelOpeningKind::Door); // a threshold
  EXPECT_EQ(kindOf(0.1), ModelOpeningKind::Window);
}

TEST(ModelOpenings, WithoutSidesThereAreNone)
{
  EXPECT_TRUE(modelOpenings({}, {}, {}, {}).empty());
}
