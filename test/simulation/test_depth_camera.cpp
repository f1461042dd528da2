/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "box_room.h"

#include <pcl/simulation/depth_camera.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

namespace {

using namespace pcl::indoor;
using pcl::indoor::test::boxRoom;

// A cupboard at the far wall of the room.
const std::string cabinet = R"("furniture": [{"class": "cabinet", "at": [3, 1.5],
  "size": [0.6, 0.4, 1.6], "rotation": 90}])";

const CameraPose pose{{1, 1.5, 1.2}, {4, 1.5, 1.2}};

DepthCameraOptions
perfectCamera()
{
  DepthCameraOptions options;
  options.width = 160;
  options.height = 120;
  options.focal_length = 131;
  options.noise = 0;
  options.step = 1e-7;
  options.least_cosine = 0;
  return options;
}

bool
sees(const PointXYZScene& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

TEST(DepthCamera, SeesAWallWhereItIs)
{
  const auto view = viewBuilding(boxRoom(), pose, perfectCamera());
  ASSERT_EQ(view.width, 160u);
  ASSERT_EQ(view.height, 120u);
  EXPECT_FALSE(view.is_dense);
  // 3 m away, x to the right (-y of the room), y down: the wall is 3 m wide and ends
  // 1.2 m below the camera and 1.3 m above it.
  int seen = 0;
  for (int v = 0; v < 120; ++v)
    for (int u = 0; u < 160; ++u) {
      const auto& p = view.at(u, v);
      if (!sees(p))
        continue;
      ++seen;
      EXPECT_NEAR(p.x, (u - 79.5) / 131 * p.z, 1e-4);
      EXPECT_NEAR(p.y, (v - 59.5) / 131 * p.z, 1e-4);
      const Eigen::Vector3d place(
          pose.position.x() + p.z, pose.position.y() - p.x, 1.2 - p.y);
      const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0),
                                    Eigen::Vector3d(4, 3, 2.5));
      EXPECT_NEAR(box.squaredExteriorDistance(place), 0, 1e-6);
      EXPECT_LT((box.max() - place).cwiseMin(place - box.min()).minCoeff(), 1e-3);
      EXPECT_EQ(p.room, 1u);
      EXPECT_EQ(p.object, 0u);
      EXPECT_NE(p.category, 0u);
    }
  EXPECT_GE(seen, 160 * 120 * 99 / 100);
  EXPECT_NEAR(view.at(80, 60).z, 3, 1e-3);
}

TEST(DepthCamera, NoDepthOutOfRangeAtGrazingAnglesAndWhereTheProjectorIsHidden)
{
  auto options = perfectCamera();
  options.max_range = 2.9;
  EXPECT_FALSE(sees(viewBuilding(boxRoom(), pose, options).at(80, 60)));
  options.max_range = 5;
  options.min_range = 3.1;
  EXPECT_FALSE(sees(viewBuilding(boxRoom(), pose, options).at(80, 60)));
  options = perfectCamera();
  options.least_cosine = 0.99; // 8 degrees
  const auto straight = viewBuilding(boxRoom(), pose, options);
  EXPECT_TRUE(sees(straight.at(80, 60)));
  EXPECT_FALSE(sees(straight.at(110, 60))) << "13 degrees from the middle";

  // The front of the cabinet is about 1.8 m away, the wall 3 m: on the left of it a
  // strip of the wall has no light, 131 px * 0.075 m * (1 / 1.8 m - 1 / 3 m) = 2.2 px
  // wide.
  const auto building = boxRoom(cabinet);
  options = perfectCamera();
  const auto shadow = [&](double baseline) {
    options.baseline = baseline;
    const auto view = viewBuilding(building, pose, options);
    std::array<int, 2> dark{0, 0}; // on the left and right of the cabinet
    for (int u = 0; u < 160; ++u)
      dark[u >= 80] += !sees(view.at(u, 60));
    return dark;
  };
  const auto near = shadow(0.075), far = shadow(0.3);
  EXPECT_EQ(near[1], 0);
  EXPECT_EQ(far[1], 0);
  EXPECT_NEAR(near[0], 2.2, 1.5);
  EXPECT_NEAR(far[0], 8.7, 2);
}

TEST(DepthCamera, NoiseIsThatOfTheDisparity)
{
  auto options = perfectCamera();
  options.noise = 0.5;
  const auto building = boxRoom();
  const auto view = viewBuilding(building, pose, options);
  const double scale = options.focal_length * options.baseline;
  double squares = 0, products = 0, count = 0;
  for (int v = 45; v < 75; ++v)
    for (int u = 50; u < 110; ++u) {
      const double error = scale / view.at(u, v).z - scale / 3,
                   beside = scale / view.at(u + 1, v).z - scale / 3;
      squares += error * error;
      products += error * beside;
      ++count;
    }
  EXPECT_NEAR(std::sqrt(squares / count), 0.5, 0.1);
  EXPECT_GT(products / squares, 0.5) << "neighbours err alike";

  options.noise = 0;
  options.step = 0.125;
  const auto stepped = viewBuilding(building, pose, options);
  const double disparity = scale / stepped.at(80, 60).z;
  EXPECT_NEAR(disparity, scale / 3, 0.0626);
  EXPECT_NEAR(std::remainder(disparity, 0.125), 0, 1e-4);
}

TEST(DepthCamera, TheSameSeedGivesTheSameView)
{
  auto options = perfectCamera();
  options.noise = 0.1;
  const auto building = boxRoom(cabinet);
  const auto bytes = [&] {
    const auto view = viewBuilding(building, pose, options);
    return std::string(reinterpret_cast<const char*>(view.points.data()),
                       view.size() * sizeof(PointXYZScene));
  };
  const auto first = bytes();
  EXPECT_EQ(bytes(), first);
  options.seed = 2;
  EXPECT_NE(bytes(), first);
}

TEST(DepthCamera, LooksStraightDown)
{
  const auto view =
      viewBuilding(boxRoom(), {{2, 1.5, 2}, {2, 1.5, 0}}, perfectCamera());
  EXPECT_NEAR(view.at(80, 60).z, 2, 1e-3);
}

TEST(DepthCamera, DrawsViewsOfWhatIsThere)
{
  const auto building = boxRoom(cabinet);
  const auto walk = planTrajectory(building, {});
  std::set<double> places;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const auto drawn = drawCameraPose(building, {}, seed);
    EXPECT_EQ(std::count(walk.begin(), walk.end(), drawn.position), 1);
    EXPECT_NEAR((drawn.target - Eigen::Vector3d(3, 1.5, 0.8)).norm(), 0, 1e-9);
    const double distance = (drawn.target - drawn.position).norm();
    EXPECT_GE(distance, 1);
    EXPECT_LE(distance, 4);
    EXPECT_EQ(viewBuilding(building, drawn, perfectCamera()).at(80, 60).object, 1u);
    EXPECT_EQ(drawCameraPose(building, {}, seed).position, drawn.position);
    places.insert(drawn.position.x());
  }
  EXPECT_GT(places.size(), 1u) << "all from one place of " << walk.size();
  EXPECT_THROW(drawCameraPose(boxRoom(), {}, 1), pcl::BadArgumentException)
      << "no object";
}

TEST(DepthCamera, RefusesWhatItCannotSee)
{
  const auto building = boxRoom();
  EXPECT_THROW(viewBuilding(building, {pose.position, pose.position}, perfectCamera()),
               pcl::BadArgumentException);
  const auto refuses = [&](auto change) {
    auto options = perfectCamera();
    change(options);
    EXPECT_THROW(viewBuilding(building, pose, options), pcl::BadArgumentException);
  };
  refuses([](auto& o) { o.width = 0; });
  refuses([](auto& o) { o.height = -1; });
  refuses([](auto& o) { o.focal_length = 0; });
  refuses([](auto& o) { o.baseline = 0; });
  refuses([](auto& o) { o.noise = -0.1; });
  refuses([](auto& o) { o.step = 0; });
  refuses([](auto& o) { o.min_range = -1; });
  refuses([](auto& o) { o.max_range = 0.4; });
  refuses([](auto& o) { o.least_cosine = 1.1; });
}

} // namespace
