/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/object_scene.h"

#include <pcl/exceptions.h>
#include <pcl/segmentation/shadow_unions.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <limits>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr float voxel_size = 0.03f;
constexpr std::uint32_t left_out_from = 100;

/** An upright rectangle along x, seen from -y. */
void
addFront(LabelledPoints& scene,
         float x0,
         float x1,
         float y,
         float z0,
         float z1,
         std::uint32_t object)
{
  std::mt19937 rng(1);
  scene.addRectangle({x0, y, z0},
                     {x1 - x0, 0, 0},
                     {0, 0, z1 - z0},
                     -Eigen::Vector3f::UnitY(),
                     object,
                     0.012f,
                     0.002f,
                     rng);
}

/** Two pieces (1, 2) of a front of 1.2 m x 0.6 m, with a gap from x = 0.5 to 0.7. */
LabelledPoints
pieces()
{
  LabelledPoints scene;
  addFront(scene, 0, 0.5f, 0, 0, 0.6f, 1);
  addFront(scene, 0.7f, 1.2f, 0, 0, 0.6f, 2);
  return scene;
}

/** The pieces, with a chair's back (3) before the gap. */
LabelledPoints
shadowedFront()
{
  auto scene = pieces();
  addFront(scene, 0.4f, 0.75f, -0.5f, 0, 0.6f, 3);
  return scene;
}

std::vector<std::uint32_t>
joined(const LabelledPoints& scene, const ShadowUnionOptions& options = {})
{
  auto voxels = surfaceVoxels(scene.points, {}, voxel_size);
  averageNormals(scene.normals, voxels);
  voxels.curvatures.assign(voxels.size(), 0);
  std::vector<std::uint8_t> left_out(voxels.size(), 0);
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    if (scene.objects[i] >= left_out_from)
      left_out[voxels.cells.cell_of_point[i]] = 1;
  auto segments = scene.objects;
  const auto count = joinAcrossShadows(voxels, left_out, options, segments);
  EXPECT_EQ(segmentCount(segments) + count, segmentCount(scene.objects));
  return segments;
}

bool
isJoined(const LabelledPoints& scene, const ShadowUnionOptions& options = {})
{
  return segmentCount(joined(scene, options)) < segmentCount(scene.objects);
}

TEST(ShadowUnions, JoinAFrontThatAShadowCuts)
{
  const auto scene = shadowedFront();
  const auto segments = joined(scene);
  for (std::size_t i = 0; i < segments.size(); ++i)
    EXPECT_EQ(segments[i] == segments.back(), scene.objects[i] == 3) << i;
  EXPECT_EQ(segmentCount(segments), 2u);
}

TEST(ShadowUnions, JoinMoreThanTwoPieces)
{
  auto scene = shadowedFront();
  addFront(scene, 1.4f, 1.9f, 0, 0, 0.6f, 4);
  addFront(scene, 1.3f, 1.5f, -0.4f, 0, 0.5f, 5);
  EXPECT_EQ(segmentCount(joined(scene)), 3u);
}

TEST(ShadowUnions, StandAtAnyAngleAndFollowUp)
{
  for (const float angle : {0.3f, 1.0f, 2.2f, 4.0f}) {
    auto scene = shadowedFront();
    const Eigen::Matrix3f turn =
        Eigen::AngleAxisf(angle, Eigen::Vector3f(0.6f, 0.48f, 0.64f))
            .toRotationMatrix();
    scene.turn(turn);
    ShadowUnionOptions options;
    options.up = turn.col(2);
    EXPECT_TRUE(isJoined(scene, options)) << angle;
    options.up = turn.col(1);
    EXPECT_FALSE(isJoined(scene, options)) << "a level surface";
    const auto leaning = [&](float by) {
      options.up = Eigen::AngleAxisf(by, turn.col(0)) * turn.col(2);
      return isJoined(scene, options);
    };
    EXPECT_TRUE(leaning(0.05f));  // 3 degrees
    EXPECT_FALSE(leaning(0.15f)); // 9 degrees
  }
}

TEST(ShadowUnions, NeedSomethingBeforeTheGap)
{
  EXPECT_FALSE(isJoined(pieces()));
  auto scene = pieces();
  addFront(scene, 0.4f, 0.75f, -1.1f, 0, 0.6f, 3);
  EXPECT_FALSE(isJoined(scene)) << "too far off";
  scene = pieces();
  addFront(scene, 0.95f, 1.2f, -0.5f, 0, 0.6f, 3);
  EXPECT_FALSE(isJoined(scene)) << "beside it";
  scene = pieces();
  addFront(scene, 0.3f, 0.48f, -0.5f, 0, 0.6f, 3);
  EXPECT_TRUE(isJoined(scene)) << "seen past it";
  scene = pieces();
  addFront(scene, 0.3f, 0.48f, 0.5f, 0, 0.6f, 3);
  EXPECT_FALSE(isJoined(scene)) << "behind";
  scene = pieces();
  addFront(scene, 0.4f, 0.75f, -0.5f, 0, 0.1f, 3);
  EXPECT_FALSE(isJoined(scene)) << "too little";
  scene = pieces();
  std::mt19937 rng(4);
  scene.addRectangle({0.3f, -0.9f, 0.4f},
                     {0.6f, 0, 0},
                     {0, 0.7f, 0},
                     Eigen::Vector3f::UnitZ(),
                     3,
                     0.012f,
                     0.002f,
                     rng);
  EXPECT_FALSE(isJoined(scene)) << "a level board, which hides a line";
}

TEST(ShadowUnions, AreNotWhereOneSeesThroughTheGap)
{
  auto scene = shadowedFront();
  addFront(scene, 0.5f, 0.7f, 0.4f, 0, 0.6f, left_out_from);
  EXPECT_FALSE(isJoined(scene)) << "the wall";
  scene = shadowedFront();
  addFront(scene, 0.5f, 0.7f, 1.1f, 0, 0.6f, left_out_from);
  EXPECT_TRUE(isJoined(scene)) << "too far behind";
  scene = shadowedFront();
  addFront(scene, 0.55f, 0.65f, 0, 0, 0.6f, 4);
  EXPECT_FALSE(isJoined(scene)) << "another thing between them";
}

/** The side of a body that begins at the front. */
void
addSide(LabelledPoints& scene, float x, float y0, float y1, std::uint32_t object)
{
  std::mt19937 rng(2);
  scene.addRectangle({x, y0, 0},
                     {0, y1 - y0, 0},
                     {0, 0, 0.6f},
                     Eigen::Vector3f::UnitX(),
                     object,
                     0.012f,
                     0.002f,
                     rng);
}

TEST(ShadowUnions, AreNotBetweenBodiesWhoseSidesAreSeen)
{
  for (const float x : {0.5f, 0.7f}) {
    auto scene = shadowedFront();
    addSide(scene, x, 0, 0.5f, x < 0.6f ? 1 : 2);
    EXPECT_FALSE(isJoined(scene)) << x;
  }
}

TEST(ShadowUnions, AreNotCastByThePiecesThemselves)
{
  for (const std::uint32_t piece : {1u, 2u}) { // the back of an open bookcase
    auto scene = pieces();
    const float x = piece == 1 ? 0.35f : 0.7f;
    addSide(scene, x, -0.3f, 0, piece);
    addSide(scene, x + 0.15f, -0.3f, 0, piece);
    addFront(scene, x, x + 0.15f, -0.3f, 0, 0.6f, piece);
    EXPECT_FALSE(isJoined(scene)) << piece;
  }
}

TEST(ShadowUnions, NeedTheSameHeight)
{
  const auto cut = [](float low, float high) {
    LabelledPoints scene;
    addFront(scene, 0, 0.5f, 0, 0, 0.6f, 1);
    addFront(scene, 0.7f, 1.2f, 0, low, high, 2);
    addFront(scene, 0.4f, 0.75f, -0.5f, 0, 0.6f, 3);
    return isJoined(scene);
  };
  EXPECT_TRUE(cut(0, 0.7f));
  EXPECT_FALSE(cut(0, 0.8f)) << "higher";
  EXPECT_TRUE(cut(0, 0.53f));
  EXPECT_FALSE(cut(0, 0.43f)) << "lower";
  EXPECT_TRUE(cut(0.05f, 0.65f));
  EXPECT_FALSE(cut(0.1f, 0.7f)) << "shifted";
}

TEST(ShadowUnions, NeedOnePlane)
{
  for (const float step : {0.02f, 0.1f}) {
    LabelledPoints scene;
    addFront(scene, 0, 0.5f, 0, 0, 0.6f, 1);
    addFront(scene, 0.7f, 1.2f, step, 0, 0.6f, 2);
    addFront(scene, 0.4f, 0.75f, -0.5f, 0, 0.6f, 3);
    EXPECT_EQ(isJoined(scene), step < voxel_size) << step;
  }
}

TEST(ShadowUnions, NeedAGapNarrowerThanThePieces)
{
  const auto cut = [](float width, float gap) {
    LabelledPoints scene;
    addFront(scene, 0, 1, 0, 0, 0.6f, 1);
    addFront(scene, 1 + gap, 1 + gap + width, 0, 0, 0.6f, 2);
    addFront(scene, 0.9f, 1.1f + gap, -0.5f, 0, 0.6f, 3);
    return isJoined(scene);
  };
  EXPECT_TRUE(cut(1, 0.1f));
  EXPECT_FALSE(cut(1, 0.05f)) << "they nearly touch";
  EXPECT_TRUE(cut(1, 0.4f));
  EXPECT_FALSE(cut(1, 0.55f));
  EXPECT_TRUE(cut(0.5f, 0.4f));
  EXPECT_FALSE(cut(0.3f, 0.4f));
}

TEST(ShadowUnions, NeedPiecesThatAreWideHighAndFull)
{
  const auto cut = [](float width, float height, float hole, double min_fill = 0.5) {
    LabelledPoints scene;
    addFront(scene, 0, 0.5f, 0, 0, height, 1);
    addFront(scene, 0.61f, 0.61f + width, 0, 0, height, 2);
    scene.removeIf([&](const Eigen::Vector3f& p) {
      return p.x() < 0.5f - hole && p.z() < height - hole && p.x() > hole &&
             p.z() > hole;
    });
    addFront(scene, 0.4f, 0.7f, -0.5f, 0, height, 3);
    ShadowUnionOptions options;
    options.min_fill = min_fill;
    return isJoined(scene, options);
  };
  EXPECT_TRUE(cut(0.5f, 0.6f, 1));
  EXPECT_FALSE(cut(0.1f, 0.6f, 1)) << "a jamb";
  EXPECT_FALSE(cut(0.5f, 0.15f, 1)) << "a rail";
  EXPECT_TRUE(cut(0.5f, 0.6f, 0.16f));
  EXPECT_FALSE(cut(0.5f, 0.6f, 0.05f)) << "a frame";
  EXPECT_TRUE(cut(0.5f, 0.6f, 0.05f, 0));
}

TEST(ShadowUnions, LeaveLeftOutAlone)
{
  auto scene = shadowedFront();
  for (auto& object : scene.objects)
    object = object == 2 ? left_out_from : object;
  EXPECT_FALSE(isJoined(scene));
}

TEST(ShadowUnions, AreTheSameInAnyOrder)
{
  const auto scene = shadowedFront();
  const auto expected = joined(scene);
  std::mt19937 rng(3);
  const auto order = shuffledOrder(scene.points.size(), rng);
  std::vector<std::uint32_t> of_order;
  for (const auto i : order)
    of_order.push_back(expected[i]);
  EXPECT_EQ(renamed(joined(scene.reordered(order))), renamed(of_order));
}

TEST(ShadowUnions, RefuseWrongInput)
{
  EXPECT_EQ(segmentCount(joined({})), 0u);
  const auto scene = shadowedFront();
  const auto refuses = [&](double ShadowUnionOptions::*option, double value) {
    ShadowUnionOptions options;
    options.*option = value;
    EXPECT_THROW(joined(scene, options), pcl::BadArgumentException) << value;
  };
  using Options = ShadowUnionOptions;
  refuses(&Options::voxel_size, 0);
  refuses(&Options::min_gap, 1.9);
  for (const auto option : {&Options::min_width,
                            &Options::min_height,
                            &Options::min_fill,
                            &Options::min_overlap,
                            &Options::max_gap,
                            &Options::max_gap_share,
                            &Options::max_filled,
                            &Options::max_seen,
                            &Options::min_hiding,
                            &Options::reach}) {
    refuses(option, -1);
    refuses(option, std::numeric_limits<double>::quiet_NaN());
  }
  ShadowUnionOptions options;
  refuses(&Options::min_fill, 1.1);
  options.up = {0, 0, 2};
  EXPECT_THROW(joined(scene, options), pcl::BadArgumentException);
  auto voxels = surfaceVoxels(scene.points, {}, voxel_size);
  averageNormals(scene.normals, voxels);
  voxels.curvatures.assign(voxels.size(), 0);
  const std::vector<std::uint8_t> flags(voxels.size(), 0);
  auto segments = scene.objects;
  EXPECT_EQ(joinAcrossShadows(voxels, flags, {}, segments), 1u);
  segments.pop_back();
  EXPECT_THROW(joinAcrossShadows(voxels, flags, {}, segments),
               pcl::BadArgumentException);
  segments.push_back(0);
  EXPECT_THROW(joinAcrossShadows(voxels, {}, {}, segments), pcl::BadArgumentException);
  auto wrong = voxels;
  wrong.curvatures.clear();
  EXPECT_THROW(joinAcrossShadows(wrong, flags, {}, segments),
               pcl::BadArgumentException);
  wrong = voxels;
  wrong.normals.clear();
  EXPECT_THROW(joinAcrossShadows(wrong, flags, {}, segments),
               pcl::BadArgumentException);
}

} // namespace
