/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/model/model_columns.h>

#include "model/simulated_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::indoor;

namespace {

/** A hole in an outline, drawn roughly. */
std::vector<Eigen::Vector3d>
holeAround(const Eigen::Vector2d& middle, double half)
{
  const double x = middle.x(), y = middle.y();
  return {{x - half, y - half + 0.04, 0.0},
          {x - half + 0.03, y + half, 0.0},
          {x + half, y + half - 0.04, 0.0},
          {x + half - 0.03, y - half, 0.0}};
}

/** A room with a column, of whose sides only those towards a scanner were seen. */
class Column {
public:
  Column()
  {
    rooms_.add({Eigen::Vector2d(0, 0), Eigen::Vector2d(6, 5)}, {{}, {}, {}, {}});
  }

  template <typename SideAt>
  ModelColumn
  found(double half, const SideAt& sideAt)
  {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 0.006);
    std::uniform_real_distribution<double> around(0.0, 1.0), height(0.0, 2.6);
    for (int i = 0; i < 3000; ++i) {
      const Eigen::Vector2d place = middle + sideAt(around(random), noise(random));
      rooms_.points.push_back({static_cast<float>(place.x()),
                               static_cast<float>(place.y()),
                               static_cast<float>(height(random))});
      rooms_.room_of_point.push_back(1);
    }
    rooms_.rooms[0].footprint.push_back(holeAround(middle, half));
    const auto columns = modelColumns(rooms_.rooms, rooms_.pointsOfRooms());
    EXPECT_EQ(columns.size(), 1u);
    return columns.empty() ? ModelColumn() : columns[0];
  }

  const Eigen::Vector2d middle{2.2, 3.1};

private:
  SimulatedRooms rooms_;
};

} // namespace

TEST(ModelColumns, ARectangleThatIsTurned)
{
  constexpr double yaw = 0.4, length = 0.6, width = 0.3;
  const Eigen::Rotation2Dd turn(yaw);
  Column column;
  const auto found = column.found(0.35, [&](double around, double noise) {
    // three of four sides, the shorter ones and one longer
    Eigen::Vector2d place(-0.5 * length + noise, (4.0 * around - 0.5) * width);
    if (around > 0.25)
      place = {0.5 * length + noise, (4.0 * (around - 0.25) - 0.5) * width};
    if (around > 0.5)
      place = {(2.0 * (around - 0.5) - 0.5) * length, 0.5 * width + noise};
    return Eigen::Vector2d(turn * place);
  });
  EXPECT_FALSE(found.is_round);
  EXPECT_EQ(found.room, 1u);
  EXPECT_LT((found.center - column.middle).norm(), 0.02);
  EXPECT_NEAR(found.size.x(), length, 0.03);
  EXPECT_NEAR(found.size.y(), width, 0.03);
  EXPECT_NEAR(std::remainder(found.yaw - yaw, M_PI), 0.0, 0.03);
  EXPECT_EQ(found.height, 2.6);
}

TEST(ModelColumns, ARoundOneWithSomethingBesideIt)
{
  constexpr double radius = 0.2;
  Column column;
  const auto found = column.found(0.22, [&](double around, double noise) {
    if (around > 0.85) // an object that leans on it
      return Eigen::Vector2d(radius + 0.06, 2.0 * (around - 0.925));
    const double angle = 1.5 * M_PI * around / 0.85; // the rest was not seen
    return Eigen::Vector2d((radius + noise) *
                           Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  });
  EXPECT_TRUE(found.is_round);
  EXPECT_LT((found.center - column.middle).norm(), 0.01);
  EXPECT_NEAR(found.size.x(), 2.0 * radius, 0.02);
  EXPECT_EQ(found.size.x(), found.size.y());
}

TEST(ModelColumns, WithoutPointsItIsAsItsOutline)
{
  SimulatedRooms rooms;
  rooms.add({Eigen::Vector2d(0, 0), Eigen::Vector2d(6, 5)}, {{}, {}, {}, {}});
  rooms.rooms[0].footprint.push_back(holeAround({2.0, 2.0}, 0.2));
  const auto columns = modelColumns(rooms.rooms, rooms.pointsOfRooms());
  ASSERT_EQ(columns.size(), 1u);
  EXPECT_FALSE(columns[0].is_round);
  EXPECT_LT((columns[0].center - Eigen::Vector2d(2.0, 2.0)).norm(), 0.05);
}

TEST(ModelColumns, ARoomAndALargeHoleAreNone)
{
  auto room = holeAround({2.0, 2.0}, 0.3);
  EXPECT_TRUE(isColumn(room));
  std::reverse(room.begin(), room.end()); // outlines turn to the left
  EXPECT_FALSE(isColumn(room));
  EXPECT_FALSE(isColumn(holeAround({2.0, 2.0}, 0.6)));
  EXPECT_FALSE(isColumn({}));
}
