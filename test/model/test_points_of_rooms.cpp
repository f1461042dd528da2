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

namespace {

pcl::PointCloud<pcl::PointXYZ>
onePoint()
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.push_back({0.0f, 0.0f, 0.0f});
  return cloud;
}

} // namespace

TEST(PointsOfRooms, BesideGivesWhatLookingAtEachPointGives)
{
  std::mt19937 rng(3);
  const auto draw = [&rng] { return static_cast<float>(rng() % 10000) * 1e-3f - 5.0f; };
  const Eigen::Vector3f origin(1.0f, -2.0f, 0.5f);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  std::vector<Eigen::Vector3f> points; // in the frame of the rooms
  std::vector<std::uint32_t> rooms;
  for (int i = 0; i < 3000; ++i) {
    cloud.push_back({draw(), draw(), draw()});
    rooms.push_back(rng() % 4);
  }
  cloud[5].x = NAN;
  cloud[6].z = INFINITY;
  for (const auto& point : cloud)
    points.emplace_back(point.getVector3fMap() - origin);
  const PointsOfRooms of_rooms(cloud, rooms, 3, origin);
  EXPECT_EQ(of_rooms.roomCount(), 3u);
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
  const PointsOfRooms points(onePoint(), {1}, 1);
  std::vector<WallPoint> found(3);
  points.beside({{0.0, 0.0}, {0.0, 0.0}, 1.0, 1.0, 1.0}, 1, true, found);
  EXPECT_TRUE(found.empty());
}

TEST(PointsOfRooms, RefusesNumbersThatDoNotFit)
{
  EXPECT_THROW(PointsOfRooms(onePoint(), {}, 1), pcl::BadArgumentException);
  EXPECT_THROW(PointsOfRooms(onePoint(), {2}, 1), pcl::BadArgumentException);
}
