/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/wall_sides.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

using namespace pcl::indoor;
using RegionLabels = std::vector<std::int32_t>;

namespace {

constexpr double pixel = 0.1; // metres

/** The points of a wall that passes through the middle of a map of 4 m x 4 m, seen from
 * its two faces. */
struct Wall {
  std::vector<Eigen::Vector2f> points;
  std::vector<std::uint8_t> is_wall;
  RegionLabels truth;
  PixelMap<std::int32_t> labels, free_labels;
  Eigen::Vector2d along, normal; ///< room 1 is where the normal comes from

  Wall(double yaw, double thickness, double noise, unsigned seed = 1)
  : along(-std::sin(yaw), std::cos(yaw))
  , normal(std::cos(yaw), std::sin(yaw))
  {
    std::mt19937 rng(seed);
    const auto random = [&] { return 0.001 * static_cast<double>(rng() % 2001) - 1; };
    for (int i = 0; i < 4000; ++i) {
      const double side = i % 2 ? 1 : -1;
      const Eigen::Vector2d point =
          middle() + 1.7 * random() * along +
          (side * 0.5 * thickness + noise * random()) * normal;
      points.push_back(point.cast<float>());
      is_wall.push_back(1);
      truth.push_back(side < 0 ? 1 : 2);
    }
    labels = free_labels = {40, 40, RegionLabels(1600, 0)};
    for (int x = 0; x < 40; ++x)
      for (int y = 0; y < 40; ++y)
        labels.at(x, y) = free_labels.at(x, y) =
            normal.dot(pixel * Eigen::Vector2d(x + 0.5, y + 0.5) - middle()) < 0 ? 1
                                                                                 : 2;
    for (const auto& point : points)
      free_labels.values[pixelOf(point)] = 0;
    for (int x = 0; x < 40; ++x) // between the faces of a hollow wall there is no room
      for (int y = 0; y < 40; ++y)
        if (std::abs(normal.dot(pixel * Eigen::Vector2d(x + 0.5, y + 0.5) - middle())) <
            0.5 * thickness)
          free_labels.at(x, y) = 0;
  }

  static Eigen::Vector2d
  middle()
  {
    return {2.03, 2.04};
  }

  std::size_t
  pixelOf(const Eigen::Vector2f& point) const
  {
    return labels.index(static_cast<int>(point.x() / pixel),
                        static_cast<int>(point.y() / pixel));
  }

  /** What the map says of the points. */
  RegionLabels
  mapLabels() const
  {
    RegionLabels result;
    for (const auto& point : points)
      result.push_back(labels.values[pixelOf(point)]);
    return result;
  }

  RegionLabels
  assigned(const WallSideOptions& options = {}) const
  {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::make_pair(pixelOf(points[a]), !is_wall[a]) <
             std::make_pair(pixelOf(points[b]), !is_wall[b]);
    });
    PixelPoints sorted;
    sorted.end_row = labels.nx;
    for (std::size_t at = 0, k = 0; at < labels.size(); ++at) {
      sorted.first.push_back(static_cast<std::uint32_t>(k));
      const auto place = [&] {
        sorted.places.push_back(points[order[k++]] / static_cast<float>(pixel));
      };
      const auto isHere = [&] {
        return k < order.size() && pixelOf(points[order[k]]) == at;
      };
      while (isHere() && is_wall[order[k]])
        place();
      sorted.walls_end.push_back(static_cast<std::uint32_t>(k));
      while (isHere())
        place();
    }
    sorted.first.push_back(static_cast<std::uint32_t>(order.size()));
    const RegionLabels before = mapLabels();
    RegionLabels in_order, result(before.size());
    for (const std::size_t i : order)
      in_order.push_back(before[i]);
    assignWallSides(sorted, pixel, labels, free_labels, options, 0, in_order);
    for (std::size_t k = 0; k < order.size(); ++k)
      result[order[k]] = in_order[k];
    return result;
  }

  double
  rightShare(const RegionLabels& result) const
  {
    std::size_t right = 0;
    for (std::size_t i = 0; i < result.size(); ++i)
      right += result[i] == truth[i];
    return static_cast<double>(right) / static_cast<double>(result.size());
  }
};

} // namespace

TEST(WallSides, BothFacesOfAThinWallGetTheirRooms)
{
  for (const double degrees : {0.0, 17.0, 45.0, 90.0, -63.0})
    for (const double thickness : {0.08, 0.12, 0.2}) {
      const Wall wall(degrees * M_PI / 180, thickness, 0.015);
      EXPECT_EQ(wall.rightShare(wall.assigned()), 1.0)
          << degrees << " degrees, " << thickness << " m";
    }
  // the map alone cannot do it
  const Wall wall(0.3, 0.08, 0.015);
  EXPECT_LT(wall.rightShare(wall.mapLabels()), 0.92);
}

TEST(WallSides, AFaceWithFewPointsGetsItsRoomToo)
{
  Wall wall(0.3, 0.08, 0.015);
  for (std::size_t i = wall.points.size(); i > 0; --i) // keep a tenth of one face
    if (wall.truth[i - 1] == 2 && i % 20 != 0) {
      wall.points.erase(wall.points.begin() + i - 1);
      wall.truth.erase(wall.truth.begin() + i - 1);
      wall.is_wall.erase(wall.is_wall.begin() + i - 1);
    }
  EXPECT_LT(wall.points.size(), 2300u);
  EXPECT_GT(wall.points.size(), 2100u);
  EXPECT_GT(wall.rightShare(wall.assigned()), 0.99); // windows may hold one face only
}

TEST(WallSides, FacesThatNoiseNearlyJoins)
{
  const Wall wall(0.3, 0.08, 0.045); // noise reaches 5 mm into the other half
  EXPECT_GT(wall.rightShare(wall.assigned()), 0.9); // of uniform noise, 94 % do not
}

TEST(WallSides, ThickWallsKeepTheirFaces)
{
  // Of a wall thicker than the window, each window holds one face: it belongs to the
  // room before it, all of it.
  for (const double degrees : {0.0, 30.0})
    for (const double thickness : {0.3, 0.4, 0.5, 0.7}) {
      const Wall wall(degrees * M_PI / 180, thickness, 0.015);
      EXPECT_GT(wall.rightShare(wall.assigned()), 0.99)
          << degrees << " degrees, " << thickness << " m";
    }
}

TEST(WallSides, AWallSeenFromOneSideBelongsToThatRoom)
{
  Wall wall(0.3, 0.0, 0.015);
  for (auto* map : {&wall.labels, &wall.free_labels})
    for (auto& label : map->values)
      label = label == 2 ? 0 : label; // nothing behind it
  const auto result = wall.assigned();
  EXPECT_EQ(result, RegionLabels(result.size(), 1));
}

TEST(WallSides, PointsBesideTheWallFollowIt)
{
  // What hangs on the wall is not fitted to, but is on one of its sides.
  Wall wall(0.0, 0.12, 0.005);
  for (double y = 1.0; y < 3.0; y += 0.05)
    for (const int side : {-1, 1}) {
      wall.points.emplace_back(static_cast<float>(Wall::middle().x() + side * 0.068),
                               static_cast<float>(y));
      wall.is_wall.push_back(0);
      wall.truth.push_back(side < 0 ? 1 : 2);
    }
  EXPECT_EQ(wall.rightShare(wall.assigned()), 1.0);
}

TEST(WallSides, RoundObjectsAreLeftAlone)
{
  Wall wall(0.0, 0.1, 0.0);
  wall.points.clear();
  wall.is_wall.clear();
  for (int i = 0; i < 400; ++i) { // a column on the border between two rooms
    const double angle = 2 * M_PI * i / 400;
    wall.points.emplace_back(static_cast<float>(2.0 + 0.2 * std::cos(angle)),
                             static_cast<float>(2.0 + 0.2 * std::sin(angle)));
    wall.is_wall.push_back(1);
  }
  EXPECT_EQ(wall.assigned(), wall.mapLabels());
}

TEST(WallSides, FewPointsAreLeftAlone)
{
  Wall wall(0.0, 0.08, 0.015);
  WallSideOptions options;
  options.min_points = 5000;
  EXPECT_EQ(wall.assigned(options), wall.mapLabels());
  wall.is_wall.assign(wall.is_wall.size(), 0); // nothing to fit to
  EXPECT_EQ(wall.assigned(), wall.mapLabels());
}

TEST(WallSides, FarFromBordersNothingChanges)
{
  Wall wall(0.0, 0.08, 0.015);
  wall.labels.values.assign(1600, 5);
  wall.free_labels = wall.labels;
  const auto result = wall.assigned();
  EXPECT_EQ(result, RegionLabels(result.size(), 5));
}

TEST(WallSides, EmptyInput)
{
  RegionLabels none;
  assignWallSides({}, pixel, {}, {}, {}, 0, none);
  EXPECT_TRUE(none.empty());
}
