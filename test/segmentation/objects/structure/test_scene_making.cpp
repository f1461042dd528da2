/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/scene_making.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor;

namespace {

/** A table 1 m before a camera at the origin, 1 cm between points. */
ObjectSegmentationInput
viewOfTable()
{
  ObjectSegmentationInput input;
  input.capture = Capture::TableView;
  input.viewpoint = {Eigen::Vector3f::Zero()};
  for (int i = -30; i <= 30; ++i)
    for (int j = -30; j <= 30; ++j)
      input.points.emplace_back(
          0.01f * static_cast<float>(i), 0.01f * static_cast<float>(j), 1);
  return input;
}

} // namespace

TEST(SceneMaking, OnlyTheViewOfATableHasPlacesOfItsOwn)
{
  auto input = viewOfTable();
  input.points.emplace_back(0.5f, -0.25f, 2);
  const auto places = gridPoints(input);
  ASSERT_EQ(places.size(), input.points.size());
  EXPECT_EQ(places.back(), Eigen::Vector3f(0.25f, -0.125f, std::log(2.0f)));
  input.capture = Capture::RoomView;
  EXPECT_TRUE(gridPoints(input).empty());
}

TEST(SceneMaking, PointsBesideACameraAreNoHarm)
{
  auto input = viewOfTable();
  for (const float far : {0.5f, 30.0f})
    for (const float depth : {0.0f, 0.001f, -5.0f})
      input.points.emplace_back(far, -far, depth);
  const auto options = withSizes(ObjectSegmentationOptions());
  RawScene scene;
  ASSERT_NO_THROW(scene = makeRawScene(input, options));
  EXPECT_EQ(scene.voxels.cells.cell_of_point.size(), input.points.size());
  for (const auto& place : gridPoints(input))
    EXPECT_LE(place.head<2>().norm(), 3.75f);
}
