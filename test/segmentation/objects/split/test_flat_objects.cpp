/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/labelled_points.h"

#include "objects/split/flat_objects.h"
#include "segmentation/objects/scene_of_points.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr double voxel_size = 0.03;

using Area = Eigen::AlignedBox2f;

/** A desk's top, 1.5 m x 0.8 m, with a gap where an object of this height (object 2)
 * hides it. */
LabelledPoints
deskWithObject(float height,
               float noise,
               const Area& area = Area(Eigen::Vector2f(0.5f, 0.3f),
                                       Eigen::Vector2f(0.9f, 0.5f)))
{
  LabelledPoints scene;
  std::mt19937 rng(5);
  scene.addRectangle(
      {0, 0, 0}, {1.5f, 0, 0}, {0, 0.8f, 0}, {0, 0, 1}, 1, 0.007f, noise, rng);
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    auto& point = scene.points[i];
    if (area.contains(point.head<2>())) {
      point.z() += height;
      scene.objects[i] = 2;
    }
  }
  return scene;
}

/** All points of one segment in the input. */
std::vector<std::uint32_t>
parted(const LabelledPoints& labelled,
       const Eigen::Vector3f& up = Eigen::Vector3f::UnitZ(),
       bool is_structure = false)
{
  auto scene = sceneOfPoints(labelled.points, voxel_size);
  scene.up = up;
  estimateNormals(scene.points, scene.voxels, 2);
  scene.plane_of_voxel.assign(scene.voxels.size(), is_structure);
  return partFlatObjects(scene, std::vector<std::uint32_t>(scene.voxels.size(), 0));
}

/** Share of the points for which the second segment is not the scene's object 2. */
double
errorShare(const LabelledPoints& scene, const std::vector<std::uint32_t>& labels)
{
  double wrong = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    wrong += (labels[i] == 1) != (scene.objects[i] == 2);
  return wrong / static_cast<double>(labels.size());
}

TEST(FlatObjects, PartsAKeyboardFromANoisyDesk)
{
  const auto scene = deskWithObject(0.02f, 0.005f);
  const auto labels = parted(scene);
  EXPECT_EQ(segmentCount(labels), 2u);
  EXPECT_LT(errorShare(scene, labels), 0.02); // the object has 6.7 % of the points
}

TEST(FlatObjects, LeavesAPlainSurfaceWhole)
{
  EXPECT_EQ(segmentCount(parted(deskWithObject(0, 0.005f))), 1u);
}

TEST(FlatObjects, NeedsARiseAboveTheUnevennessOfTheSurface)
{
  auto wavy = deskWithObject(0.008f, 0.002f);
  for (auto& point : wavy.points)
    point.z() += 0.012f * std::sin(12 * point.x()) * std::cos(11 * point.y());
  EXPECT_EQ(segmentCount(parted(wavy)), 1u);
}

TEST(FlatObjects, LeavesWhatIsHigherThanAnObject)
{
  const auto tower = deskWithObject(0.2f, 0.002f);
  EXPECT_EQ(segmentCount(parted(tower)), 1u);
  EXPECT_EQ(segmentCount(parted(deskWithObject(0.1f, 0.002f))), 2u);
}

TEST(FlatObjects, TakesWhatStandsOnAnObjectAlong)
{
  auto scene = deskWithObject(0.05f, 0.003f);
  std::mt19937 rng(6);
  scene.addRectangle(
      {0.7f, 0.38f, 0.05f}, {0, 0.04f, 0}, {0, 0, 0.3f}, {1, 0, 0}, 2, 0.007f, 0, rng);
  const auto labels = parted(scene);
  EXPECT_EQ(segmentCount(labels), 2u);
  EXPECT_LT(errorShare(scene, labels), 0.02);
}

TEST(FlatObjects, KeepsVoxelsThatAreLeftOut)
{
  EXPECT_EQ(segmentCount(parted(deskWithObject(0.02f, 0.005f), {0, 0, 1}, true)), 1u);
}

TEST(FlatObjects, FollowsTheDirectionUp)
{
  const auto upright = deskWithObject(0.02f, 0.003f);
  auto turned = upright;
  const Eigen::Matrix3f rotation =
      Eigen::AngleAxisf(1.1f, Eigen::Vector3f(2, -1, 1).normalized())
          .toRotationMatrix();
  turned.turn(rotation);
  EXPECT_EQ(segmentCount(parted(turned)), 1u);
  const auto labels = parted(turned, rotation * Eigen::Vector3f::UnitZ());
  EXPECT_EQ(segmentCount(labels), 2u);
  EXPECT_LT(errorShare(turned, labels), 0.02);
}

TEST(FlatObjects, DoesNotDependOnTheOrderOfThePoints)
{
  const auto scene = deskWithObject(0.02f, 0.005f);
  std::mt19937 rng(8);
  const auto order = shuffledOrder(scene.points.size(), rng);
  const auto labels = parted(scene), other = parted(scene.reordered(order));
  for (std::size_t i = 0; i < order.size(); ++i)
    ASSERT_EQ(other[i], labels[order[i]]);
}

TEST(FlatObjects, NothingIsNoHarm)
{
  EXPECT_TRUE(partFlatObjects(sceneOfPoints({}, voxel_size), {}).empty());
}

} // namespace
