/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/object_steps.h"

#include <pcl/exceptions.h>
#include <pcl/segmentation/room_objects.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace pcl::indoor {
namespace {

constexpr float step = 0.05f;
constexpr std::uint32_t none = 0xFFFFFFFFu;

/** A room of rectangles, each an object with one normal, and its segmentation. */
class Scene {
public:
  /** Points on a rectangle, with both ends, corner + a * i + b * j. */
  void
  add(std::uint32_t object,
      const Eigen::Vector3f& corner,
      const Eigen::Vector3f& a,
      const Eigen::Vector3f& b,
      const Eigen::Vector3f& normal)
  {
    for (float u = 0.0f; u <= a.norm() + 1e-4f; u += step)
      for (float v = 0.0f; v <= b.norm() + 1e-4f; v += step) {
        points_.push_back(corner + u * a.normalized() + v * b.normalized());
        objects.push_back(object);
        normals_.push_back(normal);
      }
  }

  /** Voxels smaller than the distance of the points: one point each. */
  ObjectSegmentation
  segmentation() const
  {
    DetailedSegmentation result;
    result.scene.voxels = surfaceVoxels(points_, {}, 0.4 * step);
    averageNormals(normals_, result.scene.voxels);
    return published(std::move(result));
  }

  std::vector<std::uint32_t> objects;

private:
  std::vector<Eigen::Vector3f> points_, normals_;
};

/** Floor 0 and ceiling 1 of 4 m x 3 m at 0 and 2.5 m, walls 2 (x = 0) and 3 (x = 4). */
Scene
room()
{
  const Eigen::Vector3f x(4, 0, 0), y(0, 3, 0), z(0, 0, 2.5f);
  Scene scene;
  scene.add(0, {0, 0, 0}, x, y, {0, 0, 1});
  scene.add(1, {0, 0, 2.5f}, x, y, {0, 0, -1});
  scene.add(2, {0, 0, 0.1f}, y, {0, 0, 2.2f}, {1, 0, 0});
  scene.add(3, {4, 0, 0.1f}, y, {0, 0, 2.2f}, {-1, 0, 0});
  return scene;
}

TEST(ObjectSurfaces, DistancesFromTheFloor)
{
  auto scene = room();
  scene.add(4, {0.7f, 1, 1}, {0.5f, 0, 0}, {0, 1, 0}, {0, 0, 1});       // a board
  scene.add(5, {1.9f, 1, 1.9f}, {0.3f, 0, 0}, {0, 0, 0.3f}, {0, 1, 0}); // a lamp
  const auto surfaces = objectSurfaces(scene.segmentation(), scene.objects, 6);
  ASSERT_EQ(surfaces.size(), 6u);
  EXPECT_NEAR(surfaces[4].floor_distance, 1.0f, 0.01f);
  EXPECT_NEAR(surfaces[5].floor_distance, 1.9f, 0.01f);
  EXPECT_NEAR(surfaces[0].floor_distance, 0.0f, 1e-6f);
}

TEST(ObjectSurfaces, AStepIsTheFloorOfWhatStandsOnIt)
{
  auto scene = room();
  scene.add(4, {4.5f, 0, 0.5f}, {2, 0, 0}, {0, 3, 0}, {0, 0, 1}); // a podium
  scene.add(5, {5.2f, 1, 1.2f}, {0.5f, 0, 0}, {0, 1, 0}, {0, 0, 1});
  const auto surfaces = objectSurfaces(scene.segmentation(), scene.objects, 6);
  EXPECT_NEAR(surfaces[5].floor_distance, 0.7f, 0.01f);
}

TEST(ObjectSurfaces, EachObjectHasItsPointsAndNormals)
{
  auto scene = room();
  scene.add(4, {1, 1, 1}, {0.5f, 0, 0}, {0, 0.5f, 0}, {0, 0, 1});
  const auto surfaces = objectSurfaces(scene.segmentation(), scene.objects, 5);
  for (std::uint32_t object = 0; object < 5; ++object)
    EXPECT_EQ(static_cast<std::ptrdiff_t>(surfaces[object].points.size()),
              std::count(scene.objects.begin(), scene.objects.end(), object));
  for (const auto& [position, normal] : surfaces[4].points) {
    EXPECT_NEAR(position.z(), 1.0f, 1e-5f);
    EXPECT_NEAR(normal.z(), 1.0f, 1e-5f);
  }
}

TEST(ObjectSurfaces, AVoxelIsOfTheObjectOfMostOfItsPoints)
{
  for (const auto& order : {std::vector<std::uint32_t>{4, 4, 4, 5, 5, 6, 6},
                            std::vector<std::uint32_t>{6, 4, 5, 4, 6, 5, 4}}) {
    auto scene = room();
    for (const auto object : order)
      scene.add(object, {1, 1, 1}, {0.01f, 0, 0}, {0, 0.01f, 0}, {0, 0, 1});
    const auto surfaces = objectSurfaces(scene.segmentation(), scene.objects, 7);
    EXPECT_EQ(surfaces[4].points.size(), 1u);
    EXPECT_TRUE(surfaces[5].points.empty());
    EXPECT_TRUE(surfaces[6].points.empty());
  }
}

TEST(ObjectSurfaces, PointsOfNoObjectAreFloorAllTheSame)
{
  auto scene = room();
  scene.add(4, {0.7f, 1, 1}, {0.5f, 0, 0}, {0, 1, 0}, {0, 0, 1});
  for (auto& object : scene.objects)
    object = object == 4 ? 0 : none;
  const auto surfaces = objectSurfaces(scene.segmentation(), scene.objects, 2);
  EXPECT_NEAR(surfaces[0].floor_distance, 1.0f, 0.01f);
  EXPECT_TRUE(surfaces[1].points.empty());
}

TEST(ObjectSurfaces, TheFloorIsTheLowestVoxelAroundAColumn)
{
  std::mt19937 rng(6);
  const auto random = [&rng](unsigned range) {
    return static_cast<float>(rng() % range) / 1000;
  };
  for (int trial = 0; trial < 10; ++trial) {
    Scene scene;
    for (std::uint32_t object = 0; object < 300; ++object)
      scene.add(object,
                {random(3000), random(4000), random(2500)},
                {0.01f, 0, 0},
                {0, 0.01f, 0},
                {0, 0, 1});
    const auto room = scene.segmentation();
    const auto surfaces = objectSurfaces(room, scene.objects, 300);
    const auto& places = stepsOf(room).scene.voxels.centroids;
    Eigen::Vector3f corner = places.front();
    for (const auto& place : places)
      corner = corner.cwiseMin(place);
    const auto columnOf = [&](const Eigen::Vector3f& place) {
      return Eigen::Vector2i(((place - corner).head<2>() / 0.1f).cast<int>());
    };
    for (const auto& surface : surfaces) {
      if (surface.points.size() != 1)
        continue; // two share a voxel
      const auto& place = surface.points.front().position;
      float floor = place.z();
      for (const auto& other : places)
        if ((columnOf(other) - columnOf(place)).cwiseAbs().maxCoeff() <= 3)
          floor = std::min(floor, other.z());
      EXPECT_EQ(surface.floor_distance, place.z() - floor);
    }
  }
}

TEST(ObjectSurfaces, GroundBetweenFarPlacesCostsNothing)
{
  auto scene = room();
  scene.add(4, {0.7f, 1, 1}, {0.5f, 0, 0}, {0, 1, 0}, {0, 0, 1});
  // as many columns between as would be 400 GB
  scene.add(5, {3e4f, 3e4f, 7}, {0.5f, 0, 0}, {0, 1, 0}, {0, 0, 1});
  const auto surfaces = objectSurfaces(scene.segmentation(), scene.objects, 6);
  EXPECT_NEAR(surfaces[4].floor_distance, 1.0f, 0.01f);
  EXPECT_NEAR(surfaces[5].floor_distance, 0.0f, 1e-6f);
}

TEST(ObjectSurfaces, NothingAndWrongSizes)
{
  EXPECT_TRUE(objectSurfaces(ObjectSegmentation(), {}, 0).empty());
  const auto scene = room();
  EXPECT_THROW(objectSurfaces(scene.segmentation(), {0, 1}, 2), BadArgumentException);
}

} // namespace
} // namespace pcl::indoor
