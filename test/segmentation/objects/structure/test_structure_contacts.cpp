/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/labelled_points.h"

#include "objects/structure/structure_contacts.h"

#include <pcl/features/normal_orientation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr double contact_voxel_size = 0.04;
constexpr float noise = 0.008f; // so the planes reach 14 mm far
constexpr std::uint32_t wall = 2, cupboard = 3;

/** A floor (1), a wall (2) and a cupboard (3) that stands on one, against the other. */
LabelledPoints
corner()
{
  std::mt19937 rng(3);
  LabelledPoints scene;
  const Eigen::Vector3f o(0, 0, 0), x(2, 0, 0), y(0, 2, 0), z(0, 0, 2);
  scene.addRectangle(o, x, y, {0, 0, 1}, 1, 0.01f, noise, rng);
  scene.addRectangle(o, x, z, {0, 1, 0}, wall, 0.01f, noise, rng);
  scene.removeIf([](const Eigen::Vector3f& p) { // what it hides
    return p.x() > 0.6f && p.x() < 1.4f && p.y() < 0.5f && p.z() < 1.2f;
  });
  const Eigen::Vector3f w(0.8f, 0, 0), d(0, 0.5f, 0), h(0, 0, 1.2f), at(0.6f, 0, 0);
  const auto add = [&](const Eigen::Vector3f& corner,
                       const Eigen::Vector3f& u,
                       const Eigen::Vector3f& v,
                       const Eigen::Vector3f& normal) {
    scene.addRectangle(corner, u, v, normal, cupboard, 0.01f, 0.001f, rng);
  };
  add(at + h, w, d, {0, 0, 1});
  add(at + d, w, h, {0, 1, 0});
  add(at, d, h, {-1, 0, 0});
  add(at + w, d, h, {1, 0, 0});
  return scene;
}

/** The scene with its planes set apart. */
struct Apart : ObjectScene {
  SurfaceVoxels surroundings;

  explicit Apart(const std::vector<Eigen::Vector3f>& scanned)
  {
    points = scanned;
    voxel_size = contact_voxel_size;
    surroundings = surfaceVoxels(points, {}, voxel_size);
    addNormals(surroundings);
    planes = findRoomStructure(surroundings, voxel_size);
    const auto plane_of_point =
        pointsOfStructure(points, surroundings, planes, voxel_size);
    voxels = separateVoxels(points, plane_of_point, voxel_size, plane_of_voxel);
    addNormals(voxels);
  }

  std::size_t
  yield(const VoxelClasses& votes = {})
  {
    return yieldContacts(surroundings, votes, *this);
  }

  /** Share of an object's points that are in a plane. */
  double
  shareInPlanes(const LabelledPoints& scene, std::uint32_t object) const
  {
    double in_planes = 0, all = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (scene.objects[i] == object) {
        ++all;
        in_planes += planeOfPoint(i) != 0;
      }
    return in_planes / all;
  }

private:
  void
  addNormals(SurfaceVoxels& of) const
  {
    estimateNormals(points, of, 1);
    orientTowards({1.5f, 1.5f, 1.5f}, of.centroids, of.normals);
  }
};

bool
touch(const SurfaceVoxels& surroundings, std::uint32_t first, std::uint32_t second)
{
  const auto place = [&](std::uint32_t point) {
    return cellIndex(surroundings.cells.keys[surroundings.cells.cell_of_point[point]]);
  };
  return (place(first) - place(second)).cwiseAbs().maxCoeff() <= 1;
}

/** By trying all voxels for a point. */
std::uint32_t
nearestOfAll(const Apart& scene, std::uint32_t point)
{
  auto nearest = scene.voxels.cells.cell_of_point[point];
  const auto own_plane = scene.plane_of_voxel[nearest];
  if (own_plane == 0)
    return nearest;
  const auto& plane = scene.planes[own_plane - 1];
  const Eigen::Vector3d position = scene.points[point].cast<double>();
  double least = std::abs(plane.normal.dot(position) - plane.offset);
  const auto& cells = scene.voxels.cells;
  for (std::uint32_t v = 0; v < scene.voxels.size(); ++v) {
    const Eigen::Vector3d way = position - scene.voxels.centroids[v].cast<double>();
    const double distance = std::abs(scene.voxels.normals[v].cast<double>().dot(way));
    if (scene.plane_of_voxel[v] == 0 && !scene.voxels.normals[v].isZero() &&
        way.norm() <= 1.5 * contact_voxel_size && distance < least &&
        std::any_of(cells.points.begin() + cells.offsets[v],
                    cells.points.begin() + cells.offsets[v + 1],
                    [&](auto i) { return touch(scene.surroundings, point, i); })) {
      least = distance;
      nearest = v;
    }
  }
  return nearest;
}

} // namespace

TEST(StructureContacts, WhatIsPartOfTheBuildingByItsVotesStays)
{
  const auto scene = corner();
  VoxelClasses votes; // of one voxel, for floor and for another class
  votes.class_count = building_classes + 1;
  votes.voxel_of_point.assign(scene.points.size(), 0);
  votes.probabilities = {0.5f, 0, 0, 0.5f};
  EXPECT_EQ(Apart(scene.points).yield(votes), 0u);
  votes.probabilities = {0.3f, 0, 0, 0.7f};
  const auto yielded = Apart(scene.points).yield(votes);
  EXPECT_GT(yielded, 100u);
  EXPECT_EQ(yielded, Apart(scene.points).yield());
}

TEST(StructureContacts, SidesReachDownToFloorAndWall)
{
  const auto scene = corner();
  Apart apart(scene.points);
  ASSERT_EQ(apart.planes.size(), 2u);
  const double before = apart.shareInPlanes(scene, cupboard);
  EXPECT_GT(before, 0.025);
  EXPECT_GT(apart.yield(), 0u);
  EXPECT_LT(apart.shareInPlanes(scene, cupboard), before / 2);
  // Each side of the cupboard takes a strip of the noise's width along it.
  EXPECT_GT(apart.shareInPlanes(scene, 1), 0.98);
  EXPECT_GT(apart.shareInPlanes(scene, wall), 0.98);
}

TEST(StructureContacts, PointsGoToTheNearestSurface)
{
  auto scene = corner();
  std::size_t number = 0; // sparse, so all pairs can be tried
  scene.removeIf([&](const Eigen::Vector3f&) { return ++number % 4 != 0; });
  Apart apart(scene.points);
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < scene.points.size(); ++i)
    expected.push_back(nearestOfAll(apart, i));
  const auto before = apart.voxels;
  const auto yielded = apart.yield();
  EXPECT_EQ(apart.voxels.cells.cell_of_point, expected);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    changed += expected[i] != before.cells.cell_of_point[i];
  EXPECT_EQ(yielded, changed);
  EXPECT_GT(yielded, 50u);
  EXPECT_EQ(apart.voxels.centroids, before.centroids);
}

TEST(StructureContacts, CellsListTheirPoints)
{
  Apart apart(corner().points);
  apart.yield();
  const auto& cells = apart.voxels.cells;
  ASSERT_EQ(cells.offsets.front(), 0u);
  ASSERT_EQ(cells.offsets.back(), apart.points.size());
  for (std::uint32_t v = 0; v < cells.size(); ++v)
    for (auto i = cells.offsets[v]; i < cells.offsets[v + 1]; ++i) {
      ASSERT_EQ(cells.cell_of_point[cells.points[i]], v);
      ASSERT_TRUE(i == cells.offsets[v] || cells.points[i - 1] < cells.points[i]);
    }
}

TEST(StructureContacts, TheOrderOfThePointsDoesNotMatter)
{
  const auto scene = corner();
  std::mt19937 rng(4);
  const auto order = shuffledOrder(scene.points.size(), rng);
  std::vector<Eigen::Vector3f> shuffled;
  for (const auto i : order)
    shuffled.push_back(scene.points[i]);
  Apart apart(scene.points), other(shuffled);
  EXPECT_EQ(apart.yield(), other.yield());
  std::size_t different = 0; // but for rounding
  for (std::size_t i = 0; i < order.size(); ++i)
    different += other.voxels.cells.cell_of_point[i] !=
                 apart.voxels.cells.cell_of_point[order[i]];
  EXPECT_LE(different, 2u);
}

TEST(StructureContacts, NothingWithoutObjects)
{
  auto scene = corner();
  std::size_t number = 0;
  const auto objects = scene.objects;
  scene.removeIf([&](const Eigen::Vector3f&) { return objects[number++] == cupboard; });
  Apart apart(scene.points);
  // Beyond three deviations there is no noise, hence no voxel but the planes'.
  ASSERT_EQ(std::count(apart.plane_of_voxel.begin(), apart.plane_of_voxel.end(), 0u),
            0);
  EXPECT_EQ(apart.yield(), 0u);
}
