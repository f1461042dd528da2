/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "normals/free_viewpoints.h" // of the library's sources
#include "support/labelled_points.h"

#include <pcl/exceptions.h>
#include <pcl/features/normal_orientation.h>

#include <gtest/gtest.h>

using namespace pcl::indoor;

namespace {

/** A closed room of 4 x 3 x 2.5 m with a box on the floor; normals point inwards. */
test::LabelledPoints
room(std::mt19937& rng)
{
  test::LabelledPoints scene;
  const Eigen::Vector3f x(4, 0, 0), y(0, 3, 0), z(0, 0, 2.5f), o(0, 0, 0);
  const float spacing = 0.04f, noise = 0.004f;
  scene.addRectangle(o, x, y, {0, 0, 1}, 1, spacing, noise, rng);
  scene.removeIf([](const auto& p) {
    return p.x() > 1 && p.x() < 1.8f && p.y() > 1 && p.y() < 1.6f;
  });
  scene.addRectangle(z, x, y, {0, 0, -1}, 2, spacing, noise, rng);
  scene.addRectangle(o, x, z, {0, 1, 0}, 3, spacing, noise, rng);
  scene.addRectangle(y, x, z, {0, -1, 0}, 4, spacing, noise, rng);
  scene.addRectangle(o, y, z, {1, 0, 0}, 5, spacing, noise, rng);
  scene.addRectangle(x, y, z, {-1, 0, 0}, 6, spacing, noise, rng);
  scene.addBox({1, 1, 0}, {0.8f, 0.6f, 0.7f}, 7, spacing, noise, rng);
  return scene;
}

/** Points near each other, by brute force on cells. */
Adjacency
neighborsByCells(const std::vector<Eigen::Vector3f>& points, double distance)
{
  const auto cells = groupByCell(points, distance);
  const auto around = cellAdjacency(cells.keys);
  Adjacency adjacency;
  adjacency.offsets.push_back(0);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto c = cells.cell_of_point[i];
    const auto add = [&](std::uint32_t cell) {
      for (const auto point : cells.pointsOf(cell))
        if (point != i)
          adjacency.targets.push_back(point);
    };
    add(c);
    for (const auto other : around.of(c))
      add(other);
    adjacency.offsets.push_back(static_cast<std::uint32_t>(adjacency.targets.size()));
  }
  return adjacency;
}

double
rightShare(const test::LabelledPoints& scene,
           const std::vector<Eigen::Vector3f>& normals)
{
  std::size_t right = 0;
  for (std::size_t i = 0; i < normals.size(); ++i)
    right += normals[i].dot(scene.normals[i]) > 0;
  return static_cast<double>(right) / static_cast<double>(normals.size());
}

} // namespace

TEST(NormalOrientation, TowardsAViewpoint)
{
  std::vector<Eigen::Vector3f> normals{{0, 0, 1}, {0, 0, -1}, {0, 0, 0}};
  orientTowards({0, 0, -2}, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, normals);
  EXPECT_EQ(normals[0].z(), -1);
  EXPECT_EQ(normals[1].z(), -1);
}

TEST(NormalOrientation, TowardsTheFreeSpaceOfARoom)
{
  std::mt19937 rng(4);
  const auto scene = room(rng);
  auto normals = scene.normals;
  for (auto& normal : normals)
    if (rng() % 2)
      normal *= -1;
  EXPECT_NEAR(rightShare(scene, normals), 0.5, 0.05);
  FreeSpaceOptions options;
  options.cell_size = 0.1;
  orientTowardsFreeSpace(
      scene.points, neighborsByCells(scene.points, 0.06), options, normals);
  EXPECT_GT(rightShare(scene, normals), 0.99);
}

TEST(NormalOrientation, IsTheSameForAnyNumberOfThreads)
{
  std::mt19937 rng(5);
  const auto scene = room(rng);
  const auto neighbors = neighborsByCells(scene.points, 0.06);
  FreeSpaceOptions options;
  options.cell_size = 0.1;
  auto one = scene.normals, two = scene.normals;
  options.threads = 1;
  orientTowardsFreeSpace(scene.points, neighbors, options, one);
  options.threads = 2;
  orientTowardsFreeSpace(scene.points, neighbors, options, two);
  EXPECT_EQ(one, two);
}

TEST(NormalOrientation, ViewpointsAreFreeAndApart)
{
  std::mt19937 rng(6);
  const auto scene = room(rng);
  FreeSpaceOptions options;
  options.cell_size = 0.1;
  const auto viewpoints =
      viewpointsIn(FreeSpaceGrid(scene.points, options.cell_size), options);
  ASSERT_GE(viewpoints.size(), 3u);
  for (std::size_t i = 0; i < viewpoints.size(); ++i) {
    for (const auto& point : scene.points)
      EXPECT_GT((point - viewpoints[i]).norm(), 0.2f);
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT((viewpoints[j] - viewpoints[i]).norm(), 0.2f);
  }
}

TEST(NormalOrientation, OutliersDoNotMatter)
{
  std::mt19937 rng(7);
  auto scene = room(rng);
  const FreeSpaceOptions options;
  const auto viewpoints_of = [&] {
    return viewpointsIn(FreeSpaceGrid(scene.points, options.cell_size), options);
  };
  const auto expected = viewpoints_of();
  scene.points.emplace_back(900.0f, 0.0f, 0.0f);
  const auto viewpoints = viewpoints_of();
  ASSERT_FALSE(viewpoints.empty());
  EXPECT_LT((viewpoints[0] - expected[0]).norm(), 0.7f);
}

TEST(NormalOrientation, SmallAndBadInput)
{
  std::vector<Eigen::Vector3f> normals;
  Adjacency none;
  none.offsets = {0};
  orientTowardsFreeSpace({}, none, {}, normals);
  EXPECT_TRUE(normals.empty());
  EXPECT_EQ(viewpointsIn(FreeSpaceGrid({{1, 2, 3}}, 0.06), {}).size(), 1u);
  FreeSpaceOptions options;
  options.cell_size = 0;
  EXPECT_THROW(orientTowardsFreeSpace({}, none, options, normals),
               pcl::BadArgumentException);
  options = {};
  options.viewpoints = 0;
  EXPECT_THROW(orientTowardsFreeSpace({}, none, options, normals),
               pcl::BadArgumentException);
  EXPECT_THROW(orientTowardsFreeSpace({{0, 0, 0}}, none, {}, normals),
               pcl::BadArgumentException);
}
