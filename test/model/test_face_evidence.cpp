/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "face_evidence.h"
#include "model/simulated_walls.h"

#include <gtest/gtest.h>

using namespace pcl::indoor;

namespace {

constexpr double height = 2.6; // metres, of all sides

/** Sides of a room of 4 m x 3 m, and what is seen of each. */
struct Seen {
  std::vector<WallFace> faces;
  std::vector<SeenColumns> columns;
  std::vector<FaceHoles> holes;
  std::vector<ModelOpening> openings;

  Seen()
  {
    const Eigen::Vector2d corners[] = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {0.0, 3.0}};
    for (std::size_t i = 0; i < 4; ++i) {
      WallFace face;
      face.room = 1;
      face.begin = corners[i];
      face.end = corners[(i + 1) % 4];
      face.ceiling = height;
      face.is_seen = true;
      faces.push_back(face);
      show(i, {});
    }
    holes.resize(4);
  }

  /** Take another look at a side, in which there are holes. */
  void
  show(std::size_t side, const std::vector<SimulatedHole>& seen_holes)
  {
    columns.resize(4);
    const double length = faces[side].length();
    columns[side] = seenColumns(
        wallImage(simulatedSide(length, height, seen_holes), length, 0.0, height));
  }

  /** Add an opening to the first side. */
  ModelOpening&
  addOpening(ModelOpeningKind kind, const Eigen::AlignedBox2d& box)
  {
    ModelOpening opening;
    opening.kind = kind;
    opening.room_a = 1;
    opening.position = {box.center().x(), -0.1, box.min().y()};
    opening.width = box.sizes().x();
    opening.height = box.sizes().y();
    openings.push_back(opening);
    return openings.back();
  }

  std::vector<FaceEvidence>
  evidence() const
  {
    return faceEvidence(faces, columns, holes, openings);
  }
};

} // namespace

TEST(SeenColumns, AreTheSharesThatShowTheWall)
{
  const auto points = simulatedSide(
      4.0,
      height,
      {{rectangle(1.0, 0.0, 2.0, 1.3), 0.0}, {rectangle(3.0, 0.0, 4.0, 1.3), 0.5}});
  const auto columns = seenColumns(wallImage(points, 4.0, 0.0, height));
  const auto at = [&](double along) {
    return columns.share[static_cast<std::size_t>(along / columns.cell)];
  };
  EXPECT_NEAR(at(0.5), 1.0, 1e-9);
  EXPECT_NEAR(at(1.5), 0.5, 0.05);
  EXPECT_NEAR(at(3.5), 1.0, 0.05) << "what an object hides does not count";
}

TEST(FaceEvidence, WhereHardlyAPointIsNoWallIs)
{
  Seen seen;
  for (const auto& each : seen.evidence())
    EXPECT_TRUE(each.is_wall);
  seen.show(1, {{rectangle(0.0, 0.0, 3.0, 2.1), 0.0}}); // only above a lintel
  auto evidence = seen.evidence();
  EXPECT_TRUE(evidence[0].is_wall);
  EXPECT_FALSE(evidence[1].is_wall);
  seen.columns[2] = {}; // a side without an image
  EXPECT_FALSE(seen.evidence()[2].is_wall);
}

TEST(FaceEvidence, OfARoomOfWhichLittleIsSeenAllSidesAreWalls)
{
  Seen seen;
  for (std::size_t i = 0; i < 4; ++i)
    seen.show(i, {{rectangle(0.0, 0.8, 4.0, height), 0.0}});
  for (const auto& each : seen.evidence())
    EXPECT_TRUE(each.is_wall);
}

TEST(FaceEvidence, GlassAndOpenDoorsDoNotCount)
{
  const auto front = rectangle(0.3, 0.0, 3.7, 2.5);
  Seen seen;
  seen.show(0, {{front, 0.0}});
  EXPECT_FALSE(seen.evidence()[0].is_wall);
  seen.addOpening(ModelOpeningKind::Window, front);
  EXPECT_TRUE(seen.evidence()[0].is_wall);
  // neither does a passage, but what is beside it does
  seen.openings[0].kind = ModelOpeningKind::Passage;
  EXPECT_TRUE(seen.evidence()[0].is_wall);
}

TEST(FaceEvidence, ASideThatIsAllPassageIsNoWallButOneThatIsAllWindowIs)
{
  const auto whole = rectangle(0.0, 0.0, 4.0, 2.5);
  Seen seen;
  seen.show(0, {{whole, 0.0}});
  seen.addOpening(ModelOpeningKind::Passage, whole);
  EXPECT_FALSE(seen.evidence()[0].is_wall);
  seen.openings[0].kind = ModelOpeningKind::Window;
  EXPECT_TRUE(seen.evidence()[0].is_wall);
}

TEST(FaceEvidence, TellsHowDeepWindowsLie)
{
  Seen seen;
  const auto box = rectangle(1.0, 0.9, 2.0, 2.1);
  FaceHole hole;
  hole.box = box;
  hole.depth = -0.15;
  seen.holes[0] = {hole};
  EXPECT_EQ(seen.evidence()[0].depth, 0.0) << "a hole that is no window";
  seen.addOpening(ModelOpeningKind::Window, box);
  EXPECT_NEAR(seen.evidence()[0].depth, 0.15, 1e-12);
  EXPECT_EQ(seen.evidence()[1].depth, 0.0);
  seen.openings[0].room_b = 2; // between rooms both sides are known
  EXPECT_EQ(seen.evidence()[0].depth, 0.0);
}

TEST(FaceEvidence, OfNoSidesThereIsNone)
{
  EXPECT_TRUE(faceEvidence({}, {}, {}, {}).empty());
}
