/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/object_scene.h"

#include <pcl/segmentation/convex_unions.h>

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <set>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr double voxel_size = 0.04;

/** Join the objects of a scene; the label of each point afterwards. */
std::vector<std::uint32_t>
joined(const LabelledPoints& scene,
       double max_growth = 1.05,
       const Eigen::Matrix3f& axes = Eigen::Matrix3f::Identity(),
       std::uint32_t left_out_object = 0)
{
  const auto voxels = surfaceVoxels(scene.points, {}, voxel_size);
  std::vector<std::uint32_t> segments(voxels.size());
  std::vector<std::uint8_t> left_out(voxels.size(), 0);
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    segments[voxels.cells.cell_of_point[i]] = scene.objects[i];
    left_out[voxels.cells.cell_of_point[i]] = scene.objects[i] == left_out_object;
  }
  ConvexUnionOptions options;
  options.max_growth = max_growth;
  options.voxel_size = voxel_size;
  options.axes = axes;
  joinConvexUnions(voxels, left_out, options, segments);
  std::vector<std::uint32_t> labels;
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    labels.push_back(segments[voxels.cells.cell_of_point[i]]);
  return labels;
}

std::size_t
segmentCount(const std::vector<std::uint32_t>& labels)
{
  return std::set<std::uint32_t>(labels.begin(), labels.end()).size();
}

/** Compartments one above the other, each a back, two sides and a shelf. */
LabelledPoints
bookcase()
{
  LabelledPoints scene;
  std::mt19937 rng(3);
  for (std::uint32_t i = 0; i < 5; ++i) {
    const Eigen::Vector3f low(0, 0, 0.4f * static_cast<float>(i));
    const Eigen::Vector3f x(0.9f, 0, 0), y(0, 0.3f, 0), z(0, 0, 0.39f);
    scene.addRectangle(low, x, y, {0, 0, 1}, i + 1, 0.02f, 0, rng);
    scene.addRectangle(low + y, x, z, {0, -1, 0}, i + 1, 0.02f, 0, rng);
    scene.addRectangle(low, y, z, {1, 0, 0}, i + 1, 0.02f, 0, rng);
    scene.addRectangle(low + x, y, z, {-1, 0, 0}, i + 1, 0.02f, 0, rng);
  }
  return scene;
}

/** A table's top (1) with a box on it (2). */
LabelledPoints
boxOnTable()
{
  LabelledPoints scene;
  std::mt19937 rng(4);
  scene.addRectangle(
      {0, 0, 0}, {1.5f, 0, 0}, {0, 0.8f, 0}, {0, 0, 1}, 1, 0.02f, 0, rng);
  scene.addBox({0.6f, 0.3f, 0.05f}, {0.2f, 0.2f, 0.3f}, 2, 0.02f, 0, rng);
  return scene;
}

LabelledPoints
turned(LabelledPoints scene, const Eigen::Matrix3f& rotation)
{
  for (auto& point : scene.points)
    point = rotation * point;
  return scene;
}

} // namespace

TEST(ConvexUnions, CompartmentsBecomeOneBookcase)
{
  EXPECT_EQ(segmentCount(bookcase().objects), 5u);
  EXPECT_EQ(segmentCount(joined(bookcase())), 1u);
}

TEST(ConvexUnions, ABoxStaysApartFromTheTableUnderIt)
{
  EXPECT_EQ(joined(boxOnTable()), boxOnTable().objects);
  EXPECT_EQ(segmentCount(joined(boxOnTable(), 10)), 1u); // they do touch
}

TEST(ConvexUnions, FollowTheAxes)
{
  const Eigen::Matrix3f rotation(
      Eigen::AngleAxisf(0.5f, Eigen::Vector3f(0.2f, 0.3f, 1).normalized()));
  EXPECT_EQ(segmentCount(joined(turned(bookcase(), rotation), 1.05, rotation)), 1u);
  const auto labels = joined(turned(boxOnTable(), rotation), 1.05, rotation);
  EXPECT_EQ(segmentCount(labels), 2u);
}

TEST(ConvexUnions, OnlyTouchingSegmentsAreJoined)
{
  auto scene = bookcase();
  scene.removeIf([](const auto& p) { return p.z() > 0.7f && p.z() < 0.85f; });
  EXPECT_EQ(segmentCount(joined(scene, 10)), 2u);
}

TEST(ConvexUnions, LeaveOutWhatIsFlagged)
{
  const auto scene = bookcase();
  const auto labels = joined(scene, 1.05, Eigen::Matrix3f::Identity(), 3);
  EXPECT_EQ(segmentCount(labels), 3u);
  for (std::size_t i = 0; i < labels.size(); ++i)
    EXPECT_EQ(labels[i] == 3, scene.objects[i] == 3);
}

TEST(ConvexUnions, NoGrowthJoinsNothing)
{
  EXPECT_EQ(joined(bookcase(), 0), joined(bookcase(), 0.01));
  EXPECT_EQ(segmentCount(joined(bookcase(), 0)), 5u);
}

TEST(ConvexUnions, RejectWrongInput)
{
  const auto voxels = surfaceVoxels(bookcase().points, {}, voxel_size);
  std::vector<std::uint32_t> segments(voxels.size(), 0);
  const std::vector<std::uint8_t> flags(voxels.size(), 0);
  ConvexUnionOptions options;
  EXPECT_THROW(joinConvexUnions(voxels, {}, options, segments),
               pcl::BadArgumentException);
  options.max_growth = -1;
  EXPECT_THROW(joinConvexUnions(voxels, flags, options, segments),
               pcl::BadArgumentException);
  options = ConvexUnionOptions();
  options.voxel_size = 0;
  EXPECT_THROW(joinConvexUnions(voxels, flags, options, segments),
               pcl::BadArgumentException);
  const auto nothing = surfaceVoxels({}, {}, voxel_size);
  std::vector<std::uint32_t> none;
  EXPECT_NO_THROW(joinConvexUnions(nothing, {}, ConvexUnionOptions(), none));
}
