/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/exceptions.h>
#include <pcl/model/points_of_rooms.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace pcl::indoor;

TEST(PointsOfRooms, BesideGivesWhatLookingAtEachPointGives)
{
  std::mt19937 rng(3);
  const auto draw = [&rng] { return static_cast<float>(rng() % 10000) * 1e-3f - 5.0f; };
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint32_t> rooms;
  for (int i = 0; i < 3000; ++i) {
    points.emplace_back(draw(), draw(), draw());
    rooms.push_back(rng() % 4);
  }
  points[5].x() = NAN;
  points[6].z() = INFINITY;
  const PointsOfRooms of_rooms(points, rooms, 3);
  for (int trial = 0; trial < 50; ++trial) {
    const FaceStretch stretch{{draw(), draw()}, {draw(), draw()}, 0.1, 0.7, 0.3};
    const auto room = static_cast<std::uint32_t>(1 + trial % 3);
    for (const bool with_none : {false, true}) {
      const Eigen::Vector2d way = stretch.end - stretch.begin;
      std::size_t expected = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite() ||
            (rooms[i] != room && (rooms[i] != 0 || !with_none)))
          continue;
        const Eigen::Vector2d from = points[i].head<2>().cast<double>() - stretch.begin;
        const double along = from.dot(way) / way.norm();
        const double left = (way.x() * from.y() - way.y() * from.x()) / way.norm();
        expected +=
            along >= -0.1 && along <= way.norm() + 0.1 && left >= -0.7 && left <= 0.3;
      }
      std::vector<WallPoint> found;
      of_rooms.beside(stretch, room, with_none, found);
      EXPECT_EQ(found.size(), expected) << "trial " << trial;
    }
  }
}

TEST(PointsOfRooms, StretchesWithoutLengthHaveNone)
{
  const PointsOfRooms points({{0.0f, 0.0f, 0.0f}}, {1}, 1);
  std::vector<WallPoint> found(3);
  points.beside({{0.0, 0.0}, {0.0, 0.0}, 1.0, 1.0, 1.0}, 1, true, found);
  EXPECT_TRUE(found.empty());
}

TEST(PointsOfRooms, RefusesNumbersThatDoNotFit)
{
  EXPECT_THROW(PointsOfRooms({{0.0f, 0.0f, 0.0f}}, {}, 1), pcl::BadArgumentException);
  EXPECT_THROW(PointsOfRooms({{0.0f, 0.0f, 0.0f}}, {2}, 1), pcl::BadArgumentException);
}
