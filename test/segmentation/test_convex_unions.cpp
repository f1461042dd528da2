/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/object_scene.h"

#include <pcl/segmentation/convex_unions.h>

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr double voxel_size = 0.04;

std::vector<std::uint32_t>
segmentsOf(const LabelledPoints& scene, const SurfaceVoxels& voxels)
{
  std::vector<std::uint32_t> segments(voxels.size());
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    segments[voxels.cells.cell_of_point[i]] = scene.objects[i];
  return segments;
}

/** Join the objects of a scene; the label of each point afterwards. */
std::vector<std::uint32_t>
joined(const LabelledPoints& scene,
       double air_per_contact = 5,
       const Eigen::Matrix3f& axes = Eigen::Matrix3f::Identity(),
       std::uint32_t left_out_object = 0,
       double max_size_ratio = 1)
{
  const auto voxels = surfaceVoxels(scene.points, {}, voxel_size);
  auto segments = segmentsOf(scene, voxels);
  std::vector<std::uint8_t> left_out;
  for (const auto segment : segments)
    left_out.push_back(segment == left_out_object);
  ConvexUnionOptions options;
  options.air_per_contact = air_per_contact;
  options.max_air = std::max(options.max_air, air_per_contact);
  options.voxel_size = voxel_size;
  options.axes = axes;
  options.max_size_ratio = max_size_ratio;
  joinConvexUnions(voxels, left_out, options, segments);
  std::vector<std::uint32_t> labels;
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    labels.push_back(segments[voxels.cells.cell_of_point[i]]);
  return labels;
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

/** A cabinet under a desk's top (1), with a keyboard on it (2). */
LabelledPoints
keyboardOnDesk()
{
  LabelledPoints scene;
  std::mt19937 rng(5);
  scene.addBox({0, 0, 0}, {1.6f, 0.8f, 0.7f}, 1, 0.02f, 0, rng);
  scene.addBox({0.5f, 0.2f, 0.71f}, {0.45f, 0.15f, 0.03f}, 2, 0.02f, 0, rng);
  return scene;
}

/** A seat (1) with an arm on either side (2, 3) and a back (4). */
LabelledPoints
armchair()
{
  LabelledPoints scene;
  std::mt19937 rng(6);
  scene.addBox({0.2f, 0, 0}, {0.6f, 0.8f, 0.45f}, 1, 0.02f, 0, rng);
  scene.addBox({0, 0, 0}, {0.18f, 0.8f, 0.65f}, 2, 0.02f, 0, rng);
  scene.addBox({0.82f, 0, 0}, {0.18f, 0.8f, 0.65f}, 3, 0.02f, 0, rng);
  scene.addBox({0, 0.82f, 0}, {1, 0.2f, 0.8f}, 4, 0.02f, 0, rng);
  return scene;
}

/** Blocks that touch with their narrow ends only, in one line. */
LabelledPoints
beam()
{
  LabelledPoints scene;
  std::mt19937 rng(7);
  for (std::uint32_t i = 0; i < 3; ++i)
    scene.addBox(
        {1.02f * static_cast<float>(i), 0, 0}, {1, 0.08f, 0.08f}, i + 1, 0.02f, 0, rng);
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
  EXPECT_EQ(segmentCount(joined(boxOnTable(), 100)), 1u); // they do touch
}

TEST(ConvexUnions, WhatIsLargeAndConvexDoesNotSwallowWhatLiesOnIt)
{
  // The keyboard makes the hull larger by four percent only.
  EXPECT_EQ(segmentCount(joined(keyboardOnDesk())), 2u);
  EXPECT_EQ(segmentCount(joined(keyboardOnDesk(), 100)), 1u);
}

TEST(ConvexUnions, ALargeContactMayHaveMoreAir)
{
  // The arms rise above the seat, the back above both.
  EXPECT_EQ(segmentCount(joined(armchair())), 1u);
  EXPECT_EQ(segmentCount(joined(armchair(), 0.2)), 4u);
}

TEST(ConvexUnions, ARatioOfSizesKeepsWholeThingsApart)
{
  const auto count = [](float depth, double max_size_ratio) { // of two boxes
    LabelledPoints scene;
    std::mt19937 rng(8);
    scene.addBox({0, 0, 0}, {0.8f, 0.6f, 0.4f}, 1, 0.02f, 0, rng);
    scene.addBox({0, 0.62f, 0}, {0.8f, depth, 0.4f}, 2, 0.02f, 0, rng);
    return segmentCount(
        joined(scene, 5, Eigen::Matrix3f::Identity(), 0, max_size_ratio));
  };
  EXPECT_EQ(count(0.6f, 1), 1u);
  EXPECT_EQ(count(0.6f, 0.7), 2u);
  EXPECT_EQ(count(0.1f, 0.7), 1u) << "a fragment";
  EXPECT_EQ(count(0.1f, 0.1), 2u);
}

TEST(ConvexUnions, NarrowEndsAreNoContact)
{
  EXPECT_EQ(segmentCount(joined(beam())), 3u);
  const auto scene = beam();
  const auto voxels = surfaceVoxels(scene.points, {}, voxel_size);
  auto segments = segmentsOf(scene, voxels);
  ConvexUnionOptions options;
  options.voxel_size = voxel_size;
  options.min_contact_length = 0;
  joinConvexUnions(
      voxels, std::vector<std::uint8_t>(voxels.size(), 0), options, segments);
  EXPECT_EQ(segmentCount(segments), 1u);
}

TEST(ConvexUnions, FollowTheAxes)
{
  const Eigen::Matrix3f rotation(
      Eigen::AngleAxisf(0.5f, Eigen::Vector3f(0.2f, 0.3f, 1).normalized()));
  EXPECT_EQ(segmentCount(joined(turned(bookcase(), rotation), 5, rotation)), 1u);
  const auto labels = joined(turned(boxOnTable(), rotation), 5, rotation);
  EXPECT_EQ(segmentCount(labels), 2u);
}

TEST(ConvexUnions, OnlyTouchingSegmentsAreJoined)
{
  auto scene = bookcase();
  scene.removeIf([](const auto& p) { return p.z() > 0.7f && p.z() < 0.85f; });
  EXPECT_EQ(segmentCount(joined(scene, 100)), 2u);
}

TEST(ConvexUnions, LeaveOutWhatIsFlagged)
{
  const auto scene = bookcase();
  const auto labels = joined(scene, 5, Eigen::Matrix3f::Identity(), 3);
  EXPECT_EQ(segmentCount(labels), 3u);
  for (std::size_t i = 0; i < labels.size(); ++i)
    EXPECT_EQ(labels[i] == 3, scene.objects[i] == 3);
}

TEST(ConvexUnions, NoAirJoinsNothing)
{
  EXPECT_EQ(segmentCount(joined(bookcase(), 0)), 5u);
}

TEST(ConvexUnions, OrderAndNamesDoNotMatter)
{
  auto scene = bookcase();
  const auto chair = turned(
      armchair(), Eigen::AngleAxisf(0.4f, Eigen::Vector3f::UnitZ()).toRotationMatrix());
  for (std::size_t i = 0; i < chair.points.size(); ++i) {
    scene.points.push_back(chair.points[i] + Eigen::Vector3f(0.2f, 0.35f, 0));
    scene.normals.push_back(chair.normals[i]);
    scene.objects.push_back(6 + chair.objects[i]);
  }
  const auto expected = joined(scene);
  EXPECT_LT(segmentCount(expected), segmentCount(scene.objects));
  EXPECT_GT(segmentCount(expected), 1u);
  std::mt19937 rng(8);
  const auto order = shuffledOrder(scene.points.size(), rng);
  LabelledPoints other;
  std::vector<std::uint32_t> same;
  for (const auto i : order) {
    other.points.push_back(scene.points[i]);
    other.objects.push_back(20 - scene.objects[i]);
    same.push_back(expected[i]);
  }
  EXPECT_EQ(renamed(joined(other)), renamed(same));
}

TEST(ConvexUnions, RejectWrongInput)
{
  const auto voxels = surfaceVoxels(bookcase().points, {}, voxel_size);
  std::vector<std::uint32_t> segments(voxels.size(), 0);
  const std::vector<std::uint8_t> flags(voxels.size(), 0);
  ConvexUnionOptions options;
  EXPECT_THROW(joinConvexUnions(voxels, {}, options, segments),
               pcl::BadArgumentException);
  options.air_per_contact = -1;
  EXPECT_THROW(joinConvexUnions(voxels, flags, options, segments),
               pcl::BadArgumentException);
  for (const auto limit : {&ConvexUnionOptions::box_air_per_contact,
                           &ConvexUnionOptions::max_air,
                           &ConvexUnionOptions::min_contact_length}) {
    options = ConvexUnionOptions();
    options.*limit = std::nan("");
    EXPECT_THROW(joinConvexUnions(voxels, flags, options, segments),
                 pcl::BadArgumentException);
  }
  options = ConvexUnionOptions();
  options.max_size_ratio = 0;
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

TEST(ConvexUnions, WhatHasGrownMayTakeUpWhatWasTooLarge)
{
  LabelledPoints scene; // a patch in the front of one box
  std::mt19937 rng(9);
  scene.addBox({0, 0, 0}, {0.8f, 0.6f, 0.4f}, 1, 0.02f, 0, rng);
  scene.addBox({0, 0.62f, 0}, {0.8f, 0.3f, 0.4f}, 2, 0.02f, 0, rng);
  const Eigen::AlignedBox3f patch(Eigen::Vector3f(0.2f, -0.01f, 0.1f),
                                  Eigen::Vector3f(0.6f, 0.01f, 0.3f));
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    if (patch.contains(scene.points[i]))
      scene.objects[i] = 3;
  const auto voxels = surfaceVoxels(scene.points, {}, voxel_size);
  const auto segments = segmentsOf(scene, voxels);
  const auto size = [&](std::uint32_t segment) {
    return static_cast<double>(std::count(segments.begin(), segments.end(), segment));
  };
  const double ratio = 1.01 * size(2) / (size(1) + size(3));
  ASSERT_GT(size(2), ratio * size(1));
  ASSERT_LT(size(3), ratio * size(1));
  EXPECT_EQ(segmentCount(joined(scene, 5, Eigen::Matrix3f::Identity(), 0, ratio)), 1u);
}
