/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/objects/structure/enclosed_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace pcl::indoor;
using namespace pcl::indoor::test;
using Scene = EnclosedScene;

namespace {

constexpr std::uint32_t floor_plane = 1;

/** Whether a point of a wall lies at a box, not nearer to its edges than a voxel; but
 * where the box ends at another plane, there is no such rim. */
bool
isBehind(const Box& box, const Eigen::Vector3f& place, std::uint32_t plane)
{
  if (plane == floor_plane)
    return false;
  constexpr int axis_of[] = {2, 0, 1};
  const auto rim = static_cast<float>(enclosed_voxel_size);
  for (int axis = 0; axis < 3; ++axis) {
    const bool at_plane = box.min()[axis] == 0;
    if (axis == axis_of[plane - 1] && !at_plane)
      return false;
    if (place[axis] < box.min()[axis] + (at_plane ? -2 * noise : rim) ||
        place[axis] > box.max()[axis] - rim)
      return false;
  }
  return true;
}

/** That those points of walls that lie at the box, and no others, went to the object;
 * but for a rim that is a voxel wide. */
void
expectWithin(const Scene& scene,
             const std::vector<Eigen::Vector3f>& places, // in the frame of the box
             const Box& box,
             const Labels& segments,
             std::uint32_t object = furniture)
{
  std::size_t inside = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto before = scene.labelled.objects[i];
    const bool is_inside = scene.isOfPlane(i) && isBehind(box, places[i], before);
    if (is_inside) {
      ASSERT_EQ(segments[i], object) << places[i].transpose();
    }
    else if (scene.isOfPlane(i) &&
             !widened(box, enclosed_voxel_size).contains(places[i])) {
      ASSERT_EQ(segments[i], before) << places[i].transpose();
    }
    inside += is_inside;
  }
  EXPECT_GT(inside, 500u);
}

void
expectWithin(const Scene& scene, const Box& box)
{
  expectWithin(scene, scene.labelled.points, box, scene.yielded());
}

/** How far the points that planes have yielded are from the object that has them, at
 * most, along any axis. */
float
farthestTaken(const Scene& scene, const Labels& segments)
{
  float farthest = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto& place = scene.labelled.points[i];
    if (segments[i] == scene.labelled.objects[i])
      continue;
    float nearest = std::numeric_limits<float>::infinity();
    for (std::size_t j = 0; j < segments.size(); ++j)
      if (scene.labelled.objects[j] == segments[i])
        nearest =
            std::min(nearest, (place - scene.labelled.points[j]).cwiseAbs().maxCoeff());
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

const Box cabinet = boxAt({0.6f, 0, 0.5f}, {0.8f, 0.4f, 0.7f}); // hangs at the wall

} // namespace

TEST(EnclosedStructure, AClosedBoxGetsTheWallBehindIt)
{
  Scene scene;
  scene.addFaces(cabinet, tube | front);
  expectWithin(scene, cabinet);
}

TEST(EnclosedStructure, AnOpenShelfDoesNot)
{
  Scene scene;
  scene.addFaces(cabinet, tube);
  scene.addFaces(boxAt({0.6f, 0, 0.85f}, {0.8f, 0.4f, 0.02f}), top | bottom | front);
  EXPECT_LE(farthestTaken(scene, scene.yielded()), 2 * enclosed_voxel_size);
}

TEST(EnclosedStructure, NorDoesABoxWithoutASide)
{
  for (const int missing : {left, right, top, bottom}) {
    Scene scene;
    scene.addFaces(cabinet, (tube | front) & ~missing);
    EXPECT_LE(farthestTaken(scene, scene.yielded()), 2 * enclosed_voxel_size)
        << missing;
  }
}

TEST(EnclosedStructure, WhatIsSeenUnderTablesAndBedsRemains)
{
  const auto add_legs = [](Scene& scene, const Box& body) {
    for (const float x : {body.min().x(), body.max().x() - 0.05f})
      for (const float y : {body.min().y(), body.max().y() - 0.05f})
        scene.addFaces(boxAt({x, y, 0}, {0.05f, 0.05f, body.min().z()}),
                       left | right | front | back);
  };
  constexpr double reach =
      0.05 + 2 * enclosed_voxel_size; // as wide as a leg, with its rim
  Scene table;
  const Box plate = boxAt({0.5f, 0, 0.7f}, {1.2f, 0.7f, 0.03f});
  table.addFaces(plate, tube | front | back);
  add_legs(table, plate);
  EXPECT_LE(farthestTaken(table, table.yielded()), reach);
  Scene bed; // whose bottom cannot be seen
  const Box mattress = boxAt({0.5f, 0, 0.25f}, {0.9f, 1.6f, 0.3f});
  bed.addFaces(mattress, left | right | front | top);
  add_legs(bed, mattress);
  EXPECT_LE(farthestTaken(bed, bed.yielded()), reach);
}

TEST(EnclosedStructure, TheFloorUnderAClosedBoxRemains)
{
  Scene scene;
  const Box chest = boxAt({0.7f, 0.8f, 0}, {0.8f, 0.5f, 0.4f});
  scene.addFaces(chest, left | right | front | back | top);
  EXPECT_EQ(scene.yielded(), scene.labelled.objects);
}

TEST(EnclosedStructure, OtherPlanesCloseABox)
{
  Scene scene; // in the corner, so that only three faces can be seen
  const Box wardrobe = boxAt({0, 0, 0}, {0.9f, 0.6f, 1.6f});
  scene.addFaces(wardrobe, right | front | top);
  expectWithin(scene, wardrobe);
  Scene beside_the_corner;
  const Box away = boxAt({0.3f, 0, 0}, {0.9f, 0.6f, 1.6f});
  beside_the_corner.addFaces(away, right | front | top);
  EXPECT_LE(farthestTaken(beside_the_corner, beside_the_corner.yielded()),
            2 * enclosed_voxel_size);
}

TEST(EnclosedStructure, ABoxMustTouchThePlane)
{
  for (const float gap : {0.04f, 0.08f, 0.3f}) { // voxels of 0.03 m
    Scene scene;
    Box box = cabinet;
    box.translate(Eigen::Vector3f(0, gap, 0));
    scene.addFaces(box, tube | front | (gap > 0.1f ? back : 0));
    std::size_t count = 0;
    scene.yielded(&count);
    EXPECT_EQ(count > 0, gap < 0.06f) << gap;
  }
}

TEST(EnclosedStructure, APictureGetsTheWallBehindIt)
{
  const Box picture = boxAt({0.6f, 0, 0.5f}, {0.8f, 0.045f, 0.7f}); // 1.5 voxels
  for (const int faces : {int(front), tube | front}) {
    Scene scene;
    scene.addFaces(picture, faces);
    expectWithin(scene, picture);
  }
}

TEST(EnclosedStructure, WhatStandsWithinAWallGetsItsFaceBack)
{
  Scene scene;
  const Box niche = boxAt({0.6f, -0.4f, 0.5f}, {0.8f, 0.4f, 0.7f});
  scene.addFaces(niche, tube | back);
  expectWithin(scene, scene.labelled.points, cabinet, scene.yielded());
  Scene hole;
  hole.addFaces(niche, tube);
  EXPECT_LE(farthestTaken(hole, hole.yielded()), 2 * enclosed_voxel_size);
}

TEST(EnclosedStructure, WhatLiesBehindAPlaneDoesNotCloseABox)
{
  Scene scene;
  scene.addFaces(boxAt({0.6f, 0.3f, 0.5f}, {0.8f, 0.1f, 0.7f}), front);
  scene.addFaces(boxAt({0.6f, -0.4f, 0.5f}, {0.8f, 0.3f, 0.7f}), tube);
  std::size_t count = 0;
  scene.yielded(&count);
  EXPECT_EQ(count, 0u);
}

TEST(EnclosedStructure, OfTwoTheSmallerGetsIt)
{
  const Box inner = boxAt({0.8f, 0, 0.7f}, {0.4f, 0.3f, 0.3f});
  for (const std::uint32_t small : {furniture, furniture + 1}) {
    Scene scene;
    const auto large = 2 * furniture + 1 - small;
    scene.addFaces(cabinet, tube | front, large);
    scene.addFaces(inner, tube | front, small);
    auto segments = scene.yielded();
    std::size_t of_small = 0;
    for (std::size_t i = 0; i < segments.size(); ++i)
      if (segments[i] == small && scene.isOfPlane(i)) {
        ++of_small;
        EXPECT_TRUE(
            widened(inner, enclosed_voxel_size).contains(scene.labelled.points[i]));
        segments[i] = large;
      }
    EXPECT_GT(of_small, 400u);
    expectWithin(scene, scene.labelled.points, cabinet, segments, large);
  }
}

TEST(EnclosedStructure, PlaceAndAnglesDoNotMatter)
{
  Scene scene;
  const Box wardrobe = boxAt({0, 0, 0}, {0.9f, 0.6f, 1.6f});
  scene.addFaces(wardrobe, right | front | top);
  const auto places = scene.labelled.points;
  scene.turn(aboutZ(30));
  scene.move({3, -5, 1});
  expectWithin(scene, places, wardrobe, scene.yielded());
  for (const float degrees : {30.0f, 60.0f}) { // to the wall that counts for the axes
    Scene askew(aboutZ(degrees));
    askew.addFaces(cabinet, tube | front);
    expectWithin(askew, cabinet);
  }
}

TEST(EnclosedStructure, TheOrderOfThePointsDoesNotMatter)
{
  Scene scene;
  scene.addFaces(boxAt({0, 0, 0}, {0.9f, 0.6f, 1.6f}), right | front | top);
  const auto expected = scene.yielded();
  std::mt19937 rng(5);
  const auto order = shuffledOrder(expected.size(), rng);
  auto shuffled = scene;
  for (std::size_t i = 0; i < order.size(); ++i) {
    shuffled.labelled.points[i] = scene.labelled.points[order[i]];
    shuffled.labelled.objects[i] = scene.labelled.objects[order[i]];
  }
  const auto segments = shuffled.yielded();
  for (std::size_t i = 0; i < order.size(); ++i)
    ASSERT_EQ(segments[i], expected[order[i]]);
}

TEST(EnclosedStructure, APointAstrayDoesNotFillTheMemory)
{
  Scene scene;
  scene.addFaces(cabinet, tube | front);
  scene.labelled.points.emplace_back(5e4f, 0.5f, 5e4f);
  scene.labelled.normals.push_back(Eigen::Vector3f::UnitY());
  scene.labelled.objects.push_back(furniture);
  std::size_t count = 1;
  EXPECT_NO_THROW(scene.yielded(&count));
  EXPECT_EQ(count, 0u);
}

TEST(EnclosedStructure, NothingWithoutPlanesOrPoints)
{
  Labels none;
  EXPECT_EQ(yieldEnclosed(ObjectScene(), none), 0u);
  Scene scene;
  scene.addFaces(cabinet, tube | front);
  scene.planes.clear();
  std::size_t count = 1;
  EXPECT_EQ(scene.yielded(&count), scene.labelled.objects);
  EXPECT_EQ(count, 0u);
}
