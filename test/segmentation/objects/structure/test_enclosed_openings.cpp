/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/objects/structure/enclosed_scene.h"

#include <gtest/gtest.h>

using namespace pcl::indoor;
using namespace pcl::indoor::test;
using Scene = EnclosedScene;

namespace {

enum Bars { left_bar = 1, right_bar = 2, upper_bar = 4, lower_bar = 8 };
constexpr int all_bars = left_bar | right_bar | upper_bar | lower_bar;
constexpr int jambs_and_head = left_bar | right_bar | upper_bar;
constexpr float bar_width = 0.06f;

/** Bars around an opening of the wall along x. */
void
addFrame(Scene& scene, const Box& opening, int bars)
{
  const Eigen::Vector3f low = opening.min(), high = opening.max();
  const float width = high.x() - low.x(), height = high.z() - low.z();
  const float depth = high.y() - low.y();
  const auto add = [&](const Eigen::Vector3f& corner, float along_x, float along_z) {
    scene.addFaces(boxAt(corner, {along_x, depth, along_z}), tube | front | back);
  };
  if (bars & left_bar)
    add({low.x() - bar_width, low.y(), low.z()}, bar_width, height);
  if (bars & right_bar)
    add({high.x(), low.y(), low.z()}, bar_width, height);
  if (bars & upper_bar)
    add({low.x() - bar_width, low.y(), high.z()}, width + 2 * bar_width, bar_width);
  if (bars & lower_bar)
    add({low.x() - bar_width, low.y(), low.z() - bar_width},
        width + 2 * bar_width,
        bar_width);
}

/** The share of the wall's points within the opening that went to the frame. */
double
shareTaken(const Scene& scene, const Box& opening)
{
  const auto segments = scene.yielded();
  double within = 0, taken = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    auto place = scene.labelled.points[i];
    place.y() = opening.center().y();
    if (scene.labelled.objects[i] != 3 || !opening.contains(place))
      continue;
    ++within;
    taken += segments[i] == furniture;
  }
  EXPECT_GT(within, 500);
  return taken / within;
}

Box
window(float depth, float distance = 0)
{
  return boxAt({0.5f, distance, 0.7f}, {0.8f, depth, 0.8f});
}

const Box door = boxAt({0.6f, 0, 0}, {0.7f, 0.1f, 1.6f});

} // namespace

TEST(EnclosedOpenings, AFrameGetsThePaneInThePlaneOfTheWall)
{
  for (const float distance : {0.0f, -0.05f, -0.1f}) {
    Scene scene;
    addFrame(scene, window(0.1f, distance), all_bars);
    EXPECT_EQ(shareTaken(scene, window(0.1f)), 1) << distance;
  }
  Scene flush;
  addFrame(flush, window(0.025f), all_bars);
  EXPECT_EQ(shareTaken(flush, window(0.025f)), 1);
}

/** The sheets that are seen of a frame whose edges are too low for points of their own.
 */
TEST(EnclosedOpenings, AFlatFrameGetsWhatIsWithinIt)
{
  const auto opening = window(0.025f);
  for (const bool has_pane : {false, true}) {
    Scene scene;
    const Eigen::Vector3f low = opening.min(), size = opening.sizes();
    const auto sheet = [&](float x, float z, float width, float height) {
      scene.addFaces(boxAt({low.x() + x, 0.04f, low.z() + z}, {width, 0, height}),
                     front);
    };
    sheet(-bar_width, -bar_width, bar_width, size.z() + 2 * bar_width);
    sheet(size.x(), -bar_width, bar_width, size.z() + 2 * bar_width);
    sheet(0, -bar_width, size.x(), bar_width);
    sheet(0, size.z(), size.x(), bar_width);
    if (has_pane)
      sheet(0, 0, size.x(), size.z());
    EXPECT_EQ(shareTaken(scene, opening), 1) << has_pane;
  }
}

TEST(EnclosedOpenings, AFrameWithoutABarDoesNot)
{
  for (const int missing : {left_bar, right_bar, upper_bar, lower_bar}) {
    Scene scene;
    addFrame(scene, window(0.1f), all_bars & ~missing);
    EXPECT_LT(shareTaken(scene, window(0.1f)), 0.4)
        << "only a rim, bar_width " << missing;
  }
}

TEST(EnclosedOpenings, ADoorFrameStandsOnTheFloor)
{
  Scene scene;
  addFrame(scene, door, jambs_and_head);
  EXPECT_EQ(shareTaken(scene, door), 1);
  Scene above;
  const Box raised = boxAt({0.6f, 0, 0.3f}, {0.7f, 0.1f, 1.3f});
  addFrame(above, raised, jambs_and_head);
  EXPECT_LT(shareTaken(above, raised), 0.4) << "nothing closes it below";
}

TEST(EnclosedOpenings, FramesAreThinAndAtTheWall)
{
  Scene deep;
  addFrame(deep, window(0.4f), all_bars);
  EXPECT_LT(shareTaken(deep, window(0.4f)), 0.4) << "a box without a back";
  Scene away;
  addFrame(away, window(0.1f, 0.1f), all_bars);
  EXPECT_EQ(shareTaken(away, window(0.1f)), 0) << "three voxels from the wall";
}

TEST(EnclosedOpenings, MostOfAWallIsNoOpening)
{
  const Box most = boxAt({0.2f, 0, 0.2f}, {1.6f, 0.1f, 1.6f});
  Scene scene;
  addFrame(scene, most, all_bars);
  EXPECT_LT(shareTaken(scene, most), 0.3) << "64 % of the wall";
}
