/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "model/simulated_walls.h"

#include <pcl/model/wall_face.h>

#include <gtest/gtest.h>

using namespace pcl::indoor;

namespace {

std::vector<WallFace>
facesOf(const SimulatedRooms& scene, int threads = 1)
{
  return wallFaces(scene.rooms, scene.pointsOfRooms(), threads);
}

} // namespace

TEST(WallFaces, LieOnTheWallsAlthoughTheOutlineDoesNot)
{
  SimulatedRooms scene;
  scene.add(rectangle(1.0, 2.0, 5.0, 5.0), {{}, {}, {}, {}}, 0.06);
  const auto faces = facesOf(scene);
  ASSERT_EQ(faces.size(), 4u);
  const Eigen::Vector2d corners[] = {{1.0, 2.0}, {5.0, 2.0}, {5.0, 5.0}, {1.0, 5.0}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(faces[i].is_seen);
    // the mean of ten thousand points with 3 mm of noise is known to 0.03 mm; a slope
    // over 3 m moves the corners by little more
    EXPECT_LT((faces[i].begin - corners[i]).norm(), 1e-3);
    EXPECT_LT((faces[i].end - corners[(i + 1) % 4]).norm(), 1e-3);
    EXPECT_GT(faces[i].inward().dot(Eigen::Vector2d(3.0, 3.5) - faces[i].begin), 0.0);
  }
}

TEST(WallFaces, ALeafThatFillsMostOfAWallDoesNotMoveIt)
{
  SimulatedRooms scene;
  scene.add(rectangle(0.0, 0.0, 3.0, 4.0),
            {{{rectangle(0.5, 0.0, 2.5, 2.3), -0.08}}, {}, {}, {}});
  const auto faces = facesOf(scene);
  ASSERT_EQ(faces.size(), 4u);
  EXPECT_NEAR(faces[0].begin.y(), 0.0, 1e-3);
  EXPECT_NEAR(faces[0].end.y(), 0.0, 1e-3);
}

TEST(WallFaces, CornersWithinAStraightWallAreLeftOut)
{
  SimulatedRooms scene;
  scene.add(rectangle(0.0, 0.0, 4.0, 4.0), {{}, {}, {}, {}});
  auto& line = scene.rooms[0].footprint[0];
  line.insert(line.begin() + 1, Eigen::Vector3d(2.0, 0.05, 0.0));
  EXPECT_EQ(facesOf(scene).size(), 4u);
}

namespace {

/** How many faces a square room of 4 m has whose outline goes on from its first corner
 * along these corners. */
std::size_t
facesWithCorners(const std::vector<Eigen::Vector2d>& corners)
{
  SimulatedRooms scene;
  scene.add(rectangle(0.0, 0.0, 4.0, 4.0), {{}, {}, {}, {}}, 0.0);
  scene.points.clear();
  scene.room_of_point.clear();
  auto& line = scene.rooms[0].footprint[0];
  std::size_t place = 1;
  for (const auto& corner : corners)
    line.insert(line.begin() + static_cast<std::ptrdiff_t>(place++),
                Eigen::Vector3d(corner.x(), corner.y(), 0.0));
  return facesOf(scene).size();
}

} // namespace

TEST(WallFaces, NichesAreWithinTheirWall)
{
  // a niche; two, whose outline cuts across the wall between them; one at a corner
  EXPECT_EQ(facesWithCorners({{1.0, 0.0}, {1.0, -0.2}, {2.0, -0.2}, {2.0, 0.0}}), 4u);
  EXPECT_EQ(facesWithCorners({{0.5, 0.0}, {0.7, -0.2}, {1.8, 0.05}, {2.2, -0.15}}), 4u);
  EXPECT_EQ(facesWithCorners({{1.0, 0.0}, {1.1, -0.2}, {3.0, -0.2}}), 4u);
}

TEST(WallFaces, AlcovesAndPillarsHaveWallsOfTheirOwn)
{
  EXPECT_EQ(facesWithCorners({{1.0, 0.0}, {1.0, -0.6}, {2.0, -0.6}, {2.0, 0.0}}), 8u);
  EXPECT_EQ(facesWithCorners({{1.0, 0.0}, {1.0, 0.2}, {2.0, 0.2}, {2.0, 0.0}}), 8u);
  EXPECT_EQ(facesWithCorners({{2.0, -0.6}}), 5u);
}

TEST(WallFaces, WithoutPointsOutlinesStay)
{
  SimulatedRooms scene;
  scene.add(rectangle(0.0, 0.0, 4.0, 4.0), {{}, {}, {}, {}}, 0.0);
  scene.points.clear();
  scene.room_of_point.clear();
  const auto faces = facesOf(scene);
  ASSERT_EQ(faces.size(), 4u);
  EXPECT_FALSE(faces[0].is_seen);
  EXPECT_NEAR(faces[0].length(), 4.0, 1e-9);
}
