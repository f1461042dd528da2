/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "model/simulated_walls.h"

#include <pcl/exceptions.h>
#include <pcl/model/building_model.h>

#include <gtest/gtest.h>

using namespace pcl::indoor;

namespace {

constexpr double known = 0.02; // metres: half of the spacing on each side

/** Two rooms with a wall of 12 cm between them at x = 4: a window in the first, to the
 * outside; between them a closed door at y = 1, an open one at y = 3, and in the first
 * room a niche at y = 4.3. */
SimulatedRooms
twoRooms()
{
  SimulatedRooms scene;
  scene.add(rectangle(0.0, 0.0, 4.0, 5.0),
            {{{rectangle(1.0, 0.9, 2.2, 2.1), -0.15}},
             {{rectangle(0.55, 0.0, 1.45, 2.0), -0.04},
              {rectangle(2.55, 0.0, 3.45, 2.0), 0.0},
              {rectangle(4.0, 1.0, 4.6, 1.6), -0.08}},
             {},
             {}});
  // its left side runs downwards from y = 5
  scene.add(rectangle(4.12, 0.0, 8.0, 5.0),
            {{},
             {},
             {},
             {{rectangle(3.55, 0.0, 4.45, 2.0), -0.04},
              {rectangle(1.55, 0.0, 2.45, 2.0), 0.0}}});
  return scene;
}

std::vector<RoomOpening>
openDoor()
{
  RoomOpening opening;
  opening.room_a = 1;
  opening.room_b = 2;
  opening.position = {4.05, 3.05, 0.0};
  opening.width = 0.85;
  opening.area = 1.7;
  return {opening};
}

const ModelOpening*
openingNear(const BuildingModel& model, double x, double y)
{
  for (const auto& opening : model.openings)
    if ((opening.position.head<2>() - Eigen::Vector2d(x, y)).norm() < 0.2)
      return &opening;
  return nullptr;
}

} // namespace

TEST(BuildingModel, FindsDoorsAndAWindowWhereTheyWereMade)
{
  const auto scene = twoRooms();
  const auto model = buildingModel(scene.pointsOfRooms(), scene.rooms, openDoor());
  ASSERT_EQ(model.openings.size(), 3u);

  const auto* window = openingNear(model, 1.6, 0.0);
  ASSERT_NE(window, nullptr);
  EXPECT_EQ(window->kind, ModelOpeningKind::Window);
  EXPECT_EQ(window->room_a, 1u);
  EXPECT_EQ(window->room_b, 0u);
  EXPECT_NEAR(window->width, 1.2, 2.0 * known);
  EXPECT_NEAR(window->sill, 0.9, known);
  EXPECT_NEAR(window->head(), 2.1, known);
  EXPECT_NEAR(window->position.z(), 0.9, known);

  const auto* closed = openingNear(model, 4.06, 1.0);
  ASSERT_NE(closed, nullptr);
  EXPECT_EQ(closed->kind, ModelOpeningKind::Door);
  EXPECT_EQ(closed->room_b, 2u);
  EXPECT_FALSE(closed->is_open);
  EXPECT_NEAR(closed->width, 0.9, 2.0 * known);
  EXPECT_NEAR(closed->position.x(), 4.06, 0.002);

  const auto* open = openingNear(model, 4.06, 3.0);
  ASSERT_NE(open, nullptr);
  EXPECT_EQ(open, &model.openings[0]); // those that one can pass come first
  EXPECT_EQ(open->kind, ModelOpeningKind::Door);
  EXPECT_TRUE(open->is_open);
  EXPECT_NEAR(open->width, 0.9, 2.0 * known);
  EXPECT_NEAR(open->position.y(), 3.0, known);
  EXPECT_NEAR(open->height, 2.0, known);
  EXPECT_EQ(open->sill, 0.0);
}

TEST(BuildingModel, OpeningsLieInTheirWalls)
{
  const auto scene = twoRooms();
  const auto model = buildingModel(scene.pointsOfRooms(), scene.rooms, openDoor());
  for (const auto& opening : model.openings) {
    ASSERT_LT(opening.wall, model.walls.size());
    const auto& wall = model.walls[opening.wall];
    EXPECT_EQ(wall.thickness > 0.0, opening.room_b > 0);
    if (opening.room_b > 0) {
      EXPECT_NEAR(wall.thickness, 0.12, 0.002);
    }
  }
}

TEST(BuildingModel, AnOpeningThatIsNotSeenStays)
{
  auto scene = twoRooms();
  auto openings = openDoor();
  openings[0].position.y() = 4.9;
  const auto model = buildingModel(scene.pointsOfRooms(), scene.rooms, openings);
  ASSERT_FALSE(model.openings.empty());
  EXPECT_NEAR(model.openings[0].position.y(), 4.9, 1e-9);
  EXPECT_NEAR(model.openings[0].width, 0.85, 1e-9);
  EXPECT_NEAR(model.openings[0].height, 2.0, 1e-9);
}

TEST(BuildingModel, IsTheSameForAnyNumberOfThreads)
{
  const auto scene = twoRooms();
  const auto one = buildingModel(scene.pointsOfRooms(), scene.rooms, openDoor(), 1);
  const auto eight = buildingModel(scene.pointsOfRooms(), scene.rooms, openDoor(), 8);
  ASSERT_EQ(one.openings.size(), eight.openings.size());
  for (std::size_t i = 0; i < one.openings.size(); ++i) {
    EXPECT_EQ(one.openings[i].position, eight.openings[i].position);
    EXPECT_EQ(one.openings[i].width, eight.openings[i].width);
  }
  ASSERT_EQ(one.walls.size(), eight.walls.size());
  for (std::size_t i = 0; i < one.walls.size(); ++i)
    EXPECT_EQ(one.walls[i].begin, eight.walls[i].begin);
}

TEST(BuildingModel, OfNoRoomsThereIsNone)
{
  const auto model = buildingModel(SimulatedRooms().pointsOfRooms(), {}, {});
  EXPECT_TRUE(model.walls.empty());
  EXPECT_TRUE(model.openings.empty());
  auto scene = twoRooms();
  scene.rooms[0].label = 3;
  EXPECT_THROW(buildingModel(scene.pointsOfRooms(), scene.rooms, openDoor()),
               pcl::BadArgumentException);
}
