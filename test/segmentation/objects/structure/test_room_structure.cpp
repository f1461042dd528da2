/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "objects/structure/room_structure.h"
#include "objects/structure/structure_islands.h"
#include "support/labelled_points.h"

#include <pcl/features/normal_orientation.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr double voxel_size = 0.04;
const Eigen::Vector3f middle(2, 1.2f, 1.2f); // of the room

/** The floor with two boxes (1 to 3), a ceiling and four walls (4 to 8). */
LabelledPoints
closedRoom()
{
  auto scene = floorWithTwoBoxes();
  std::mt19937 rng(5);
  const Eigen::Vector3f x(4, 0, 0), y(0, 2.5f, 0), z(0, 0, 2.4f), o(0, 0, 0);
  scene.addRectangle(z, x, y, {0, 0, -1}, 4, 0.015f, 0.003f, rng);
  scene.addRectangle(o, x, z, {0, 1, 0}, 5, 0.015f, 0.003f, rng);
  scene.addRectangle(y, x, z, {0, -1, 0}, 6, 0.015f, 0.003f, rng);
  scene.addRectangle(o, y, z, {1, 0, 0}, 7, 0.015f, 0.003f, rng);
  scene.addRectangle(x, y, z, {-1, 0, 0}, 8, 0.015f, 0.003f, rng);
  return scene;
}

/** A rectangle of an object. */
struct Patch {
  Eigen::Vector3f corner, along, across, normal;
  std::uint32_t object;
};

LabelledPoints
patches(const std::vector<Patch>& all)
{
  LabelledPoints scene;
  std::mt19937 rng(9);
  for (const auto& [corner, along, across, normal, object] : all)
    scene.addRectangle(corner, along, across, normal, object, 0.015f, 0.003f, rng);
  return scene;
}

SurfaceVoxels
voxelsOf(const LabelledPoints& scene)
{
  auto voxels = surfaceVoxels(scene.points, {}, voxel_size);
  estimateNormals(scene.points, voxels, 1);
  orientTowards(middle, voxels.centroids, voxels.normals);
  return voxels;
}

std::vector<std::uint32_t>
planesOf(const LabelledPoints& scene)
{
  const auto voxels = voxelsOf(scene);
  return pointsOfStructure(
      scene.points, voxels, findRoomStructure(voxels, voxel_size), voxel_size);
}

/** Share of an object's points that are in a plane. */
double
shareInPlanes(const LabelledPoints& scene,
              const std::vector<std::uint32_t>& planes,
              std::uint32_t object)
{
  double in_planes = 0, all = 0;
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (scene.objects[i] == object) {
      ++all;
      in_planes += planes[i] != 0;
    }
  return in_planes / all;
}

} // namespace

TEST(RoomStructure, IsFloorCeilingAndWallsButNotTheBoxes)
{
  const auto scene = closedRoom();
  const auto planes = findRoomStructure(voxelsOf(scene), voxel_size);
  ASSERT_EQ(planes.size(), 6u);
  for (const auto& plane : planes) {
    EXPECT_NEAR(plane.normal.norm(), 1, 1e-9);
    EXPECT_GT(plane.normal.cwiseAbs().maxCoeff(), 0.999);
    EXPECT_GT(plane.normal.dot(middle.cast<double>()), plane.offset); // into the room
  }
  const auto plane_of_point = planesOf(scene);
  for (const std::uint32_t object : {1, 4, 5, 6, 7, 8})
    EXPECT_GT(shareInPlanes(scene, plane_of_point, object), 0.98) << object;
  for (const std::uint32_t object : {2, 3}) // but for their lowest rows of points
    EXPECT_LT(shareInPlanes(scene, plane_of_point, object), 0.05) << object;
}

TEST(RoomStructure, ASmallRoomHasAFloorAndACeiling)
{
  std::mt19937 rng(8);
  LabelledPoints closet;
  const Eigen::Vector3f low(1.5f, 0.6f, 0), x(1, 0, 0), y(0, 1.2f, 0), z(0, 0, 2.4f);
  closet.addRectangle(low, x, y, {0, 0, 1}, 1, 0.015f, 0.003f, rng);
  closet.addRectangle(low + z, x, y, {0, 0, -1}, 2, 0.015f, 0.003f, rng);
  closet.addRectangle(low, x, z, {0, 1, 0}, 3, 0.015f, 0.003f, rng);
  closet.addRectangle(low, y, z, {1, 0, 0}, 4, 0.015f, 0.003f, rng);
  closet.addRectangle(low + x, y, z, {-1, 0, 0}, 5, 0.015f, 0.003f, rng);
  EXPECT_EQ(findRoomStructure(voxelsOf(closet), voxel_size).size(), 5u);
}

TEST(RoomStructure, ACeilingBelowARoofIsOne)
{
  auto scene = closedRoom();
  Eigen::AlignedBox3f box;
  for (const auto& point : scene.points)
    box.extend(point);
  std::mt19937 rng(9);
  for (const float above : {0.13f, 0.5f}) {
    auto roofed = scene;
    const Eigen::Vector3f low(box.min().x(), box.min().y(), box.max().z() + above);
    roofed.addRectangle(low,
                        {box.sizes().x(), 0, 0},
                        {0, box.sizes().y(), 0},
                        {0, 0, -1},
                        9,
                        0.015f,
                        0.003f,
                        rng);
    EXPECT_EQ(findRoomStructure(voxelsOf(roofed), voxel_size).size(),
              above < 0.3f ? 7u : 6u)
        << above;
  }
}

TEST(RoomStructure, DoesNotNeedWallsNorTakeSidesOfBoxesForThem)
{
  // The boxes' sides are as high as the scene, and from the viewpoint nothing is behind
  // the far ones, but they are lower than any room.
  const auto scene = floorWithTwoBoxes();
  const auto planes = findRoomStructure(voxelsOf(scene), voxel_size);
  ASSERT_EQ(planes.size(), 1u);
  EXPECT_GT(planes.front().normal.z(), 0.999);
  EXPECT_NEAR(planes.front().offset, 0, 0.002);
}

TEST(RoomStructure, KeepsABoardInFrontOfAWallApart)
{
  auto scene = closedRoom();
  std::mt19937 rng(6);
  scene.addRectangle({1, 0.025f, 1}, // less than a voxel from the wall
                     {1, 0, 0},
                     {0, 0, 0.7f},
                     {0, 1, 0},
                     9,
                     0.015f,
                     0.003f,
                     rng);
  scene.removeIf([](const Eigen::Vector3f& p) { // the wall behind it is hidden
    return p.y() < 0.012f && p.x() > 1 && p.x() < 2 && p.z() > 1 && p.z() < 1.7f;
  });
  const auto planes = planesOf(scene);
  EXPECT_LT(shareInPlanes(scene, planes, 9), 0.02);
  EXPECT_GT(shareInPlanes(scene, planes, 5), 0.98);
}

TEST(RoomStructure, KeepsPlinthsInFrontOfAPlaneApart)
{
  auto scene = closedRoom();
  std::mt19937 rng(10);
  for (const float x : {0.1f, 3.0f}) // 2.5 voxels above the floor, which shows
    scene.addRectangle(
        {x, 1.5f, 0.1f}, {0.9f, 0, 0}, {0, 0.9f, 0}, {0, 0, 1}, 9, 0.01f, 0.003f, rng);
  const auto voxels = voxelsOf(scene);
  EXPECT_EQ(findRoomStructure(voxels, voxel_size).size(), 6u);
  EXPECT_LT(shareInPlanes(scene, planesOf(scene), 9), 0.02);
}

TEST(RoomStructure, AFreeBoardIsNoneHoweverItStands)
{
  const Eigen::Vector3f centre(0.85f, 0.85f, 0.95f);
  for (const auto& towards : {Eigen::Vector3f(1, 0, 0), // like a wall
                              Eigen::Vector3f(1, 1, 0),
                              Eigen::Vector3f(1, 0, 0.5f),
                              Eigen::Vector3f(0.66f, 0.66f, 0.34f)}) { // like nothing
    const Eigen::Vector3f normal = towards.normalized();
    const Eigen::Vector3f u = normal.cross(Eigen::Vector3f::UnitZ()).normalized();
    const Eigen::Vector3f v = u.cross(normal);
    auto scene = closedRoom();
    scene.removeIf([&](const Eigen::Vector3f& p) { // what the board hides
      const Eigen::Vector3f from = p - centre;
      return from.dot(normal) < 0 && std::abs(from.dot(u)) < 0.6f &&
             std::abs(from.dot(v)) < 0.6f;
    });
    std::mt19937 rng(11);
    scene.addRectangle(
        centre - 0.55f * (u + v), 1.1f * u, 1.1f * v, normal, 9, 0.015f, 0.003f, rng);
    EXPECT_EQ(findRoomStructure(voxelsOf(scene), voxel_size).size(), 6u)
        << towards.transpose();
    EXPECT_LT(shareInPlanes(scene, planesOf(scene), 9), 0.05) << towards.transpose();
  }
}

TEST(RoomStructure, AnObliquePlaneFromSideToSideIsOne)
{
  auto scene = closedRoom();
  const auto isBehind = [](const Eigen::Vector3f& p, float margin) {
    return p.x() / 3.9f + p.y() / 2.45f + p.z() / 2.35f < 1 + margin;
  };
  scene.removeIf([&](const Eigen::Vector3f& p) { return isBehind(p, -0.02f); });
  const Eigen::Vector3f x(3.9f, 0, 0), y(0, 2.45f, 0), z(0, 0, 2.35f);
  std::mt19937 rng(12);
  scene.addRectangle(
      x, y - x, z - x, (y - x).cross(z - x).normalized(), 9, 0.015f, 0.003f, rng);
  scene.removeIf([&](const Eigen::Vector3f& p) { // half of the parallelogram
    return (p.array() < -0.01f).any();
  });
  EXPECT_GT(shareInPlanes(scene, planesOf(scene), 9), 0.9);
}

TEST(RoomStructure, PlanesOfOneSideOnly)
{
  const auto scene = closedRoom();
  auto voxels = voxelsOf(scene);
  for (auto& normal : voxels.normals) // now everything lies behind the planes
    normal *= -1;
  EXPECT_TRUE(findRoomStructure(voxels, voxel_size).empty());
}

TEST(RoomStructure, SeparateVoxelsHoldPointsOfOnePlane)
{
  const auto scene = closedRoom();
  const auto plane_of_point = planesOf(scene);
  std::vector<std::uint32_t> plane_of_voxel;
  const auto voxels =
      separateVoxels(scene.points, plane_of_point, voxel_size, plane_of_voxel);
  ASSERT_EQ(plane_of_voxel.size(), voxels.size());
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const auto v = voxels.cells.cell_of_point[i];
    ASSERT_EQ(plane_of_voxel[v], plane_of_point[i]);
    ASSERT_LT((voxels.centroids[v] - scene.points[i]).norm(), 2 * voxel_size);
  }
  std::size_t links = 0;
  for (std::size_t v = 0; v < voxels.size(); ++v)
    for (auto j = voxels.neighbors.offsets[v]; j < voxels.neighbors.offsets[v + 1];
         ++j, ++links)
      ASSERT_EQ(plane_of_voxel[v], plane_of_voxel[voxels.neighbors.targets[j]]);
  EXPECT_GT(links, 4 * voxels.size());
}

TEST(RoomStructure, PartsOfAPlaneMayBeFarApart)
{
  auto scene = floorWithTwoBoxes();
  const auto count = scene.points.size();
  for (std::size_t i = 0; i < count; ++i) // exactly in one plane
    if (scene.objects[i] == 1) {
      scene.points[i].z() = 0;
      scene.points.emplace_back(scene.points[i] + Eigen::Vector3f(4e4f, 3e4f, 0));
      scene.objects.push_back(1);
    }
  auto voxels = surfaceVoxels(scene.points, {}, voxel_size);
  estimateNormals(scene.points, voxels, 1);
  orientTowards({0, 0, 1e6f}, voxels.centroids, voxels.normals);
  const auto planes = findRoomStructure(voxels, voxel_size);
  ASSERT_EQ(planes.size(), 1u);
  float farthest = 0;
  for (const auto v : planes.front().voxels)
    farthest = std::max(farthest, voxels.centroids[v].x());
  EXPECT_GT(farthest, 4e4f);
}

TEST(RoomStructure, PointsAstrayDoNotForbidSeparateVoxels)
{
  auto scene = closedRoom();
  auto plane_of_point = planesOf(scene);
  scene.points.emplace_back(6e4f, 0.0f, 0.0f); // most of the extent that voxels allow
  plane_of_point.push_back(0);
  std::vector<std::uint32_t> plane_of_voxel;
  const auto voxels =
      separateVoxels(scene.points, plane_of_point, voxel_size, plane_of_voxel);
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const auto v = voxels.cells.cell_of_point[i];
    ASSERT_EQ(plane_of_voxel[v], plane_of_point[i]);
    ASSERT_LT((voxels.centroids[v] - scene.points[i]).norm(), 2 * voxel_size);
  }
}

TEST(RoomStructure, ManyPlanesWithPartsFarApartFitIntoOneGrid)
{
  std::mt19937 rng(13);
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint32_t> plane_of_point;
  for (std::uint32_t plane = 0; plane < 50; ++plane) // together 400 km
    for (int i = 0; i < 20; ++i) {
      points.emplace_back((i % 2) * 8e3f - 4e3f + static_cast<float>(rng() % 100) / 100,
                          static_cast<float>(rng() % 8000) - 4e3f,
                          static_cast<float>(plane));
      plane_of_point.push_back(plane);
    }
  std::vector<std::uint32_t> plane_of_voxel;
  const auto voxels =
      separateVoxels(points, plane_of_point, voxel_size, plane_of_voxel);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto v = voxels.cells.cell_of_point[i];
    ASSERT_EQ(plane_of_voxel[v], plane_of_point[i]);
    ASSERT_LT((voxels.centroids[v] - points[i]).norm(), 2 * voxel_size);
  }
}

TEST(RoomStructure, SmallFlatIslandsGoBackToThePlane)
{
  auto scene = closedRoom();
  std::mt19937 rng(9);
  const auto add = [&](const Eigen::Vector3f& corner, const Eigen::Vector3f& height) {
    scene.addRectangle(corner, {0.1f, 0, 0}, height, {0, 1, 0}, 9, 0.015f, 0.0f, rng);
  };
  add({1, 0.03f, 1}, {0, 0, 0.1f});     // before the wall
  add({3, 0.03f, 1}, {0, 0.2f, 0});     // sticks out of it
  add({3.5f, 0.06f, 1}, {0, 0, 0.02f}); // a speck at 1.5 voxels
  const auto voxels = voxelsOf(scene);
  ObjectScene apart;
  apart.voxel_size = voxel_size;
  apart.planes = findRoomStructure(voxels, voxel_size);
  const auto plane_of_point =
      pointsOfStructure(scene.points, voxels, apart.planes, voxel_size);
  apart.voxels =
      separateVoxels(scene.points, plane_of_point, voxel_size, apart.plane_of_voxel);
  const auto returned = [&](std::size_t patch_size, std::size_t min_size) {
    auto other = apart;
    returnIslands(patch_size, min_size, other);
    return other.plane_of_voxel;
  };
  const auto after = returned(8, 30);
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const auto v = apart.voxels.cells.cell_of_point[i];
    if (scene.objects[i] != 9)
      continue;
    EXPECT_EQ(apart.plane_of_voxel[v], 0u);
    const float x = scene.points[i].x();
    EXPECT_EQ(after[v] != 0, x < 2 || x > 3.3f);
  }
  EXPECT_NE(returned(1, 30), after) << "no specks";
  EXPECT_EQ(returned(2, 2), apart.plane_of_voxel) << "too large";
}

TEST(RoomStructure, AxesFollowThePlanes)
{
  EXPECT_EQ(axesOf({}), Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
  const auto scene = closedRoom();
  const auto axes = axesOf(findRoomStructure(voxelsOf(scene), voxel_size));
  EXPECT_NEAR((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm(), 0, 1e-9);
  for (int a = 0; a < 3; ++a)
    EXPECT_GT(axes.col(a).cwiseAbs().maxCoeff(), 0.999);
}

TEST(RoomStructure, FloorsAndCeilingsAreLessSteepThanWalls)
{
  const Eigen::Vector3f up = Eigen::Vector3f(0.1f, -0.2f, 1).normalized();
  const Eigen::Vector3d along = up.cast<double>().unitOrthogonal();
  for (const auto& [degrees, kind] : {std::make_pair(0, StructureKind::Floor),
                                      {44, StructureKind::Floor},
                                      {46, StructureKind::Wall},
                                      {90, StructureKind::Wall},
                                      {134, StructureKind::Wall},
                                      {136, StructureKind::Ceiling},
                                      {180, StructureKind::Ceiling}}) {
    const double angle = degrees * M_PI / 180;
    const Eigen::Vector3d normal =
        std::cos(angle) * up.cast<double>() + std::sin(angle) * along;
    EXPECT_EQ(kindOf({normal, 1, {}}, up), kind) << degrees << " degrees";
  }
}

TEST(RoomStructure, NothingInNothing)
{
  EXPECT_TRUE(findRoomStructure(surfaceVoxels({}, {}, 1), voxel_size).empty());
  std::vector<std::uint32_t> planes;
  EXPECT_EQ(separateVoxels({}, {}, 1, planes).size(), 0u);
}

TEST(RoomStructure, IsFoundWhereOnlyPartOfARoomWasSeen)
{
  // two thirds of the floor in two parts, half of two walls, neither ceiling nor the
  // rest
  const auto scene = patches({
      {{0, 0, 0}, {1.8f, 0, 0}, {0, 1.2f, 0}, {0, 0, 1}, 1},
      {{2.4f, 0.3f, 0}, {1.6f, 0, 0}, {0, 1.2f, 0}, {0, 0, 1}, 2}, // behind a gap
      {{0, 0, 0}, {2, 0, 0}, {0, 0, 1.7f}, {0, 1, 0}, 3},
      {{0, 0, 0}, {0, 2.4f, 0}, {0, 0, 2.2f}, {1, 0, 0}, 4},
      {{1.9f, 1.7f, 0.75f}, {0.8f, 0, 0}, {0, 0.8f, 0}, {0, 0, 1}, 5}, // a table
      {{2.5f, 0.4f, 0}, {1.2f, 0, 0}, {0, 0, 0.9f}, {0, 1, 0}, 6},     // a low front
  });
  const auto planes = planesOf(scene);
  for (const std::uint32_t object : {1, 2, 3, 4})
    EXPECT_GT(shareInPlanes(scene, planes, object), 0.97) << object;
  for (const std::uint32_t object : {5, 6})
    EXPECT_LT(shareInPlanes(scene, planes, object), 0.1) << object;
}

TEST(RoomStructure, ADoorInARecessIsNoPartOfAWall)
{
  const auto scene = patches({
      {{0, 0, 0}, {4, 0, 0}, {0, 2, 0}, {0, 0, 1}, 1},
      {{0, 0, 0}, {1.2f, 0, 0}, {0, 0, 2.4f}, {0, 1, 0}, 2},
      {{2.2f, 0, 0}, {1.8f, 0, 0}, {0, 0, 2.4f}, {0, 1, 0}, 2},
      {{1.2f, -0.2f, 0}, {1, 0, 0}, {0, 0, 2}, {0, 1, 0}, 3},
  });
  const auto planes = planesOf(scene);
  for (const std::uint32_t object : {1, 2})
    EXPECT_GT(shareInPlanes(scene, planes, object), 0.97) << object;
  EXPECT_LT(shareInPlanes(scene, planes, 3), 0.1);
}

TEST(RoomStructure, AFloorThatDriftsIsFollowedButNotOntoAPlatform)
{
  const float slope = 0.12f; // 7 degrees: 24 cm over the second part
  const auto scene = patches({
      {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, 1},
      {{2, 0, 0}, {2, 0, 2 * slope}, {0, 2, 0}, {0, 0, 1}, 2},
      {{0, 2, 0.2f}, {2, 0, 0}, {0, 0.9f, 0}, {0, 0, 1}, 3},
  });
  const auto planes = planesOf(scene);
  EXPECT_GT(shareInPlanes(scene, planes, 1), 0.97);
  EXPECT_GT(shareInPlanes(scene, planes, 2), 0.97);
  EXPECT_LT(shareInPlanes(scene, planes, 3), 0.1);
}

TEST(RoomStructure, InAViewAWallOfWhichHalfIsSeenIsOneButTheFrontOfACupboardIsNot)
{
  LabelledPoints scene;
  std::mt19937 rng(5);
  const Eigen::Vector3f wall(0, 0, 3), front(2.05f, 0, 2.2f);
  const Eigen::Vector3f up(0, 1.2f, 0); // too little for a room's structure
  scene.addRectangle(wall, {2, 0, 0}, up, {0, 0, -1}, 1, 0.015f, 0.003f, rng);
  scene.addRectangle(front, {1.6f, 0, 0}, up, {0, 0, -1}, 2, 0.015f, 0.003f, rng);
  auto voxels = surfaceVoxels(scene.points, {}, voxel_size);
  estimateNormals(scene.points, voxels, 1);
  orientTowards(Eigen::Vector3f(1.5f, 1, 0), voxels.centroids, voxels.normals);
  EXPECT_TRUE(findRoomStructure(voxels, voxel_size).empty());
  const auto planes = findRoomStructure(
      voxels, voxel_size, Eigen::Vector3f::UnitZ(), Capture::RoomView);
  ASSERT_EQ(planes.size(), 1u);
  EXPECT_NEAR(planes.front().heightOf({1, 1, 3}), 0, 0.01);
  EXPECT_NEAR(planes.front().normal.z(), -1, 0.01);
}
