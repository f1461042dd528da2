/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "box_room.h"

#include <pcl/simulation/hand_camera.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace {

using namespace pcl::indoor;

// A cabinet stands on the floor before the far wall, a window is in the left one.
Building
roomWithCabinet()
{
  return test::boxRoom(
      R"("windows": [{"at": [2, 3.1], "width": 1.2, "sill": 0.9, "height": 1.2}],
     "furniture": [{"class": "cabinet", "at": [3.8, 1.5], "size": [0.8, 0.4, 1.2],
     "rotation": 90}])");
}

/** One that is quick: few stops, large voxels. */
HandCameraOptions
quick()
{
  HandCameraOptions options;
  options.spacing = 2;
  options.voxel_size = 0.04;
  return options;
}

HandCameraOptions
perfectHandCamera(HandCameraOptions options = quick())
{
  options.noise = options.drift = 0;
  options.camera.step = 1e-7;
  options.camera.distortion = options.camera.edge_noise = 0;
  options.camera.mixed = options.camera.dark = 0;
  return options;
}

double
distanceTo(const Triangle& t, const Eigen::Vector3f& at)
{
  const Eigen::Vector3f normal = (t.b - t.a).cross(t.c - t.a).normalized();
  const Eigen::Vector3f foot = at - normal.dot(at - t.a) * normal;
  double nearest = std::numeric_limits<double>::infinity();
  bool is_inside = true;
  const Eigen::Vector3f* corners[] = {&t.a, &t.b, &t.c};
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3f &from = *corners[k], &to = *corners[(k + 1) % 3];
    const Eigen::Vector3f way = to - from;
    is_inside = is_inside && normal.dot(way.cross(foot - from)) >= 0;
    const float share = std::clamp(way.dot(at - from) / way.squaredNorm(), 0.0f, 1.0f);
    nearest = std::min<double>(nearest, (from + share * way - at).norm());
  }
  return is_inside ? (foot - at).norm() : nearest;
}

/** Distance to the nearest surface with the labels of a point, and to any surface. */
std::pair<double, double>
distances(const Building& building, const PointXYZScene& p)
{
  double own = 1e9, any = 1e9;
  const Eigen::Vector3f at(p.x, p.y, p.z);
  for (std::size_t t = 0; t < building.triangles.size(); ++t) {
    const double distance = distanceTo(building.triangles[t], at);
    any = std::min(any, distance);
    const auto& l = building.surfaces[t].labels;
    if (l.room == p.room && l.object == p.object && l.part == p.part &&
        l.category == p.category)
      own = std::min(own, distance);
  }
  return {own, any};
}

std::string
bytes(const SimulatedScan& scan)
{
  return {reinterpret_cast<const char*>(scan.points.data()),
          scan.points.size() * sizeof(PointXYZScene)};
}

TEST(HandCamera, APerfectCameraFindsSurfacesWhereTheyAreWithTheirLabels)
{
  const auto building = roomWithCabinet();
  auto options = perfectHandCamera(HandCameraOptions());
  options.most_points = 5000;
  const auto scan = captureRoom(building, 1, options);
  ASSERT_EQ(scan.points.size(), 5000u);
  ASSERT_EQ(scan.poses.size(), 5000u);
  EXPECT_GT(scan.ray_count, 1000000u);
  int far = 0, wrong = 0;
  for (const auto& point : scan.points) {
    const auto [own, any] = distances(building, point);
    far += any > 0.01;   // half a voxel: less than the cut at edges
    wrong += own > 0.04; // beyond two voxels from a border
  }
  EXPECT_LT(far, 150);
  EXPECT_LT(wrong, 25);
}

TEST(HandCamera, SeesObjectsAndFloorsButHardlyCeilingsAndNothingBehindObjects)
{
  const auto building = roomWithCabinet();
  std::map<std::string, int> counts;
  int behind = 0;
  const auto scan = captureRoom(building, 1, HandCameraOptions());
  for (const auto& point : scan.points) {
    ++counts[building.categories[point.category]];
    behind += point.category == building.category("wall") && point.x > 3.95 &&
              std::abs(point.y - 1.5) < 0.35 && point.z < 1.1;
    EXPECT_NE(point.category, 0u);
    EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
  }
  const double all = static_cast<double>(scan.points.size());
  EXPECT_GT(counts["floor"], 0.1 * all);
  EXPECT_GT(counts["wall"], 0.3 * all);
  EXPECT_GT(counts["cabinet"], 0.03 * all);
  EXPECT_LT(counts["ceiling"], 0.5 * counts["floor"]);
  EXPECT_EQ(behind, 0);
}

/** Root mean square of the distance of the floor's points from the floor, metres. */
double
roughness(const HandCameraOptions& options)
{
  const auto building = roomWithCabinet();
  const auto floor = building.category("floor");
  double squares = 0, count = 0;
  for (const auto& point : captureRoom(building, 1, options).points)
    if (point.category == floor) {
      squares += point.z * point.z;
      ++count;
    }
  return std::sqrt(squares / count);
}

TEST(HandCamera, NoiseAndDriftMakeSurfacesRough)
{
  const double smooth = roughness(perfectHandCamera());
  EXPECT_LT(smooth, 0.003);
  auto options = perfectHandCamera();
  options.noise = 0.01;
  EXPECT_GT(roughness(options), smooth + 0.002);
  options = perfectHandCamera();
  options.drift = 0.02;
  EXPECT_GT(roughness(options), smooth + 0.004);
}

TEST(HandCamera, DarkPartsAreMissing)
{
  auto options = perfectHandCamera();
  options.camera.dark = 1;
  for (const auto& point : captureRoom(roomWithCabinet(), 1, options).points)
    ASSERT_EQ(point.part, 0u);
}

TEST(HandCamera, IsTheSameForAnyNumberOfThreadsAndAnotherForAnotherSeed)
{
  const auto building = roomWithCabinet();
  auto options = quick();
  options.threads = 1;
  const auto one = bytes(captureRoom(building, 1, options));
  options.threads = 2;
  EXPECT_EQ(bytes(captureRoom(building, 1, options)), one);
  options.seed = 2;
  EXPECT_NE(bytes(captureRoom(building, 1, options)), one);
}

TEST(HandCamera, RefusesWhatIsOutOfRange)
{
  const auto building = roomWithCabinet();
  EXPECT_THROW(captureRoom(building, 0, {}), pcl::BadArgumentException);
  EXPECT_THROW(captureRoom(building, 2, {}), pcl::BadArgumentException);
  const auto refuses = [&](auto change) {
    HandCameraOptions options;
    change(options);
    EXPECT_THROW(captureRoom(building, 1, options), pcl::BadArgumentException);
  };
  refuses([](auto& o) { o.spacing = 0; });
  refuses([](auto& o) { o.height = 0.25; });
  refuses([](auto& o) { o.noise = -1; });
  refuses([](auto& o) { o.drift = NAN; });
  refuses([](auto& o) { o.voxel_size = 0.004; });
  refuses([](auto& o) { o.voxel_size = 0.3; });
  refuses([](auto& o) { o.most_points = 0; });
  refuses([](auto& o) { o.threads = -1; });
  refuses([](auto& o) { o.camera.mixed = 1.1; });
  refuses([](auto& o) { o.camera.dark = -0.1; });
  refuses([](auto& o) { o.camera.edge_noise = -1; });
  refuses([](auto& o) { o.camera.distortion = -1; });
  refuses([](auto& o) { o.camera.patch = 0; });
}

} // namespace
