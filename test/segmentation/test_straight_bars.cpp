/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/object_scene.h"

#include <pcl/exceptions.h>
#include <pcl/segmentation/straight_bars.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr float spacing = 0.015f, noise = 0.003f;
constexpr std::uint32_t rail = 100;

/** Posts (objects 1, 2 ...) of 0.08 m, each 0.4 m along x, 0.9 m high, and a rail of 2
 * m over or through them. */
LabelledPoints
balustrade(float rail_depth = 0.08f, float rail_height = 0.08f, float rail_z = 0.9f)
{
  LabelledPoints scene;
  std::mt19937 rng(4);
  for (int i = 0; i < 5; ++i)
    scene.addBox({0.16f + 0.4f * static_cast<float>(i), 0, 0},
                 {0.08f, 0.08f, 0.9f},
                 static_cast<std::uint32_t>(i + 1),
                 spacing,
                 noise,
                 rng);
  scene.addBox({0, 0, rail_z}, {2, rail_depth, rail_height}, rail, spacing, noise, rng);
  scene.addRectangle({0, 0, rail_z},
                     {2, 0, 0},
                     {0, rail_depth, 0},
                     {0, 0, -1},
                     rail,
                     spacing,
                     noise,
                     rng);
  return scene;
}

/** A beam of 8.5 m (object 100) through two columns (1, 2), 0.1 m wider than it. */
LabelledPoints
beamThroughColumns()
{
  LabelledPoints scene;
  std::mt19937 rng(4);
  scene.addBox({0, 0.05f, 2.6f}, {8.5f, 0.4f, 0.4f}, rail, spacing, noise, rng);
  scene.removeIf([](const Eigen::Vector3f& p) {
    return (p.x() > 2.5f && p.x() < 3) || (p.x() > 5.5f && p.x() < 6);
  });
  const Eigen::Vector3f size(0.5f, 0.5f, 3.3f);
  scene.addBox({2.5f, 0, 0}, size, 1, spacing, noise, rng);
  scene.addBox({5.5f, 0, 0}, size, 2, spacing, noise, rng);
  return scene;
}

std::size_t
pointCount(std::uint32_t object, const LabelledPoints& scene)
{
  return static_cast<std::size_t>(
      std::count(scene.objects.begin(), scene.objects.end(), object));
}

std::size_t
largestPieceOf(std::uint32_t object,
               const LabelledPoints& scene,
               const std::vector<std::uint32_t>& labels)
{
  std::map<std::uint32_t, std::size_t> pieces;
  std::size_t largest = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (scene.objects[i] == object)
      largest = std::max(largest, ++pieces[labels[i]]);
  return largest;
}

/** Every post with its piece of the rail, but for the last two, which share theirs. */
std::vector<std::uint32_t>
inPieces(const LabelledPoints& scene)
{
  std::vector<std::uint32_t> segments;
  for (const auto& point : scene.points)
    segments.push_back(static_cast<std::uint32_t>(
        std::min(3.0f, std::max(0.0f, std::floor(point.x() / 0.4f)))));
  return segments;
}

std::vector<std::uint32_t>
parted(const LabelledPoints& scene,
       std::vector<std::uint32_t> segments,
       const StraightBarOptions& options = {},
       std::size_t expected_bars = 1)
{
  const auto voxels = surfaceVoxels(scene.points, {}, options.voxel_size);
  EXPECT_EQ(partAtBars(scene.points,
                       voxels,
                       std::vector<std::uint8_t>(scene.points.size(), 0),
                       options,
                       segments),
            expected_bars);
  return segments;
}

/** Share of the points that are in another segment than most of their object, or in the
 * segment of more than half of another. */
double
wrongShare(const LabelledPoints& scene, const std::vector<std::uint32_t>& labels)
{
  std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> of_object, of_label;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    ++of_object[scene.objects[i]][labels[i]];
    ++of_label[labels[i]][scene.objects[i]];
  }
  std::size_t wrong = 0;
  for (const auto* counts : {&of_object, &of_label})
    for (const auto& entry : *counts) {
      std::size_t all = 0, most = 0;
      for (const auto& [other, size] : entry.second) {
        all += size;
        most = std::max(most, size);
      }
      wrong += all - most;
    }
  return static_cast<double>(wrong) / static_cast<double>(labels.size());
}

TEST(StraightBars, AreTakenFromThePostsTheyLieOn)
{
  const auto scene = balustrade();
  EXPECT_GT(wrongShare(scene, inPieces(scene)), 0.5);
  const auto labels = parted(scene, inPieces(scene));
  EXPECT_EQ(segmentCount(labels), 6u) << "the last two posts touch no longer";
  EXPECT_LT(wrongShare(scene, labels), 0.12) << "a voxel of each post goes along";
}

TEST(StraightBars, LeaveWhatTheyRunThroughInOne)
{
  const auto scene = balustrade(0.08f, 0.08f, 0.4f);
  const auto labels = parted(scene, inPieces(scene));
  EXPECT_EQ(segmentCount(labels), 6u) << "above and below the rail is one post";
  EXPECT_LT(wrongShare(scene, labels), 0.5) << "the rail has a piece of each post";
}

TEST(StraightBars, FollowTheAxes)
{
  auto scene = balustrade();
  const auto segments = inPieces(scene);
  StraightBarOptions options;
  options.axes =
      Eigen::AngleAxisf(0.6f, Eigen::Vector3f(0.2f, -1, 3).normalized()).matrix();
  options.up = options.axes.col(2);
  scene.turn(options.axes);
  EXPECT_LT(wrongShare(scene, parted(scene, segments, options)), 0.12);
  options.up = options.axes.col(0); // the rail is upright
  parted(scene, segments, options, 0);
}

TEST(StraightBars, RunThroughColumns)
{
  const auto scene = beamThroughColumns();
  std::vector<std::uint32_t> segments;
  for (const auto& point : scene.points)
    segments.push_back(point.x() < 3.1f ? 1 : point.x() < 6.1f ? 2 : 3);
  const auto labels = parted(scene, segments);
  EXPECT_EQ(segmentCount(labels), 3u);
  EXPECT_EQ(largestPieceOf(rail, scene, labels), pointCount(rail, scene));
  StraightBarOptions options;
  options.max_break = 0.5;
  parted(scene, segments, options, 0);
}

TEST(StraightBars, AreBeamsIfThick)
{
  const auto scene = beamThroughColumns();
  const std::vector<std::uint32_t> one(scene.points.size(), 0);
  const auto labels = parted(scene, one);
  EXPECT_EQ(segmentCount(labels), 3u) << "the columns are apart, too";
  EXPECT_EQ(largestPieceOf(rail, scene, labels), pointCount(rail, scene));
  StraightBarOptions options;
  options.min_beam = 0.6;
  parted(scene, one, options, 0);
  EXPECT_EQ(parted(scene, scene.objects, {}, 0), scene.objects)
      << "it is a segment already";
}

TEST(StraightBars, StayPartOfOneThing)
{
  const auto scene = balustrade();
  const std::vector<std::uint32_t> one(scene.points.size(), 0);
  EXPECT_EQ(parted(scene, one, {}, 0), one);
  auto mostly_one = inPieces(scene);
  for (std::size_t i = 0; i < mostly_one.size(); ++i)
    if (scene.points[i].x() > 0.15f)
      mostly_one[i] = 1;
  EXPECT_EQ(parted(scene, mostly_one, {}, 0), mostly_one);
}

TEST(StraightBars, AreNeitherBoardsNorShort)
{
  const auto board = balustrade(0.12f, 0.02f);
  StraightBarOptions options;
  parted(board, inPieces(board), options, 0);
  options.max_flatness = 10;
  parted(board, inPieces(board), options);
  const auto scene = balustrade();
  options = {};
  options.min_length = 2.2;
  parted(scene, inPieces(scene), options, 0);
  options = {};
  options.min_elongation = 30;
  parted(scene, inPieces(scene), options, 0);
  options = {};
  options.min_stretch = 2.2;
  parted(scene, inPieces(scene), options, 0);
}

TEST(StraightBars, AreOneEachAboveAnother)
{
  auto scene = balustrade();
  std::mt19937 rng(8);
  scene.addBox({0, 0, 0.4f}, {2, 0.08f, 0.08f}, rail + 1, spacing, noise, rng);
  const auto labels = parted(scene, inPieces(scene), {}, 2);
  EXPECT_EQ(segmentCount(labels), 7u);
  EXPECT_EQ(largestPieceOf(rail, scene, labels), pointCount(rail, scene));
  EXPECT_EQ(largestPieceOf(rail + 1, scene, labels), pointCount(rail + 1, scene));
}

TEST(StraightBars, AreNotJoinedAcrossAir)
{
  LabelledPoints lamps;
  std::mt19937 rng(8);
  for (std::uint32_t i = 0; i < 3; ++i)
    lamps.addBox({1.33f * static_cast<float>(i), 0, 2},
                 {1.2f, 0.1f, 0.08f},
                 i,
                 spacing,
                 noise,
                 rng);
  parted(lamps, lamps.objects, {}, 0);
  auto beam = beamThroughColumns();
  beam.removeIf([](const Eigen::Vector3f& p) { // the columns are lower than it
    return p.z() > 2.3f && p.z() < 2.55f;
  });
  beam.removeIf([](const Eigen::Vector3f& p) {
    return p.z() > 2.3f &&
           ((p.x() > 2.48f && p.x() < 3.02f) || (p.x() > 5.48f && p.x() < 6.02f));
  });
  std::vector<std::uint32_t> segments;
  for (const auto& point : beam.points)
    segments.push_back(point.x() < 3.1f ? 1 : point.x() < 6.1f ? 2 : 3);
  parted(beam, segments, {}, 0);
}

TEST(StraightBars, EndWhereThereIsAGap)
{
  LabelledPoints rails;
  std::mt19937 rng(8);
  for (const std::uint32_t side : {0u, 1u}) {
    const float x = 1.4f * static_cast<float>(side);
    rails.addBox({x, 0, 0.9f}, {1.3f, 0.08f, 0.08f}, side, spacing, noise, rng);
    rails.addBox({x + 0.2f, 0, 0}, {0.08f, 0.08f, 0.9f}, side, spacing, noise, rng);
  }
  parted(rails, rails.objects, {}, 0);
}

TEST(StraightBars, AreNotThingsInLine)
{
  LabelledPoints heaters;
  std::mt19937 rng(8);
  for (const std::uint32_t object : {1u, 2u})
    heaters.addBox({1.03f * static_cast<float>(object), 0, 0.1f},
                   {1, 0.1f, 0.1f},
                   object,
                   spacing,
                   noise,
                   rng);
  parted(heaters, heaters.objects, {}, 0);
  auto post = heaters;
  post.addBox({1.1f, 0, -0.4f}, {0.1f, 0.1f, 0.5f}, 1, spacing, noise, rng);
  parted(post, post.objects, {}, 1);
}

TEST(StraightBars, OfOtherWidthAreNotInLine)
{
  auto scene = beamThroughColumns();
  std::mt19937 rng(8);
  scene.removeIf([](const Eigen::Vector3f& p) { return p.x() > 6.02f; });
  scene.addBox({6, 0.36f, 2.7f}, {2.6f, 0.24f, 0.24f}, rail + 1, spacing, noise, rng);
  parted(scene, scene.objects, {}, 0);
}

TEST(StraightBars, MayCross)
{
  LabelledPoints scene;
  std::mt19937 rng(8);
  scene.addBox({-2, -0.04f, 1}, {4, 0.08f, 0.08f}, rail, spacing, noise, rng);
  scene.addBox({-0.04f, -2, 1}, {0.08f, 4, 0.08f}, rail + 1, spacing, noise, rng);
  std::vector<std::uint32_t> segments; // two arms, and the other two
  for (const auto& point : scene.points)
    segments.push_back(point.x() > 0.5f ? 1 : point.y() > 0.5f ? 2 : 0);
  const auto labels = parted(scene, segments, {}, 2);
  for (const auto bar : {rail, rail + 1})
    EXPECT_GT(largestPieceOf(bar, scene, labels), 0.95 * pointCount(bar, scene));
}

TEST(StraightBars, PartOnlyWhatTheyHeldTogether)
{
  auto scene = balustrade();
  std::mt19937 rng(8);
  scene.addBox({0.05f, 1.2f, 0}, {0.3f, 0.3f, 0.3f}, 1, spacing, noise, rng);
  const auto labels = parted(scene, inPieces(scene));
  EXPECT_EQ(segmentCount(labels), 6u) << "the box was with a post without touching it";
}

TEST(StraightBars, AreClearOfOtherThings)
{
  auto scene = balustrade();
  std::mt19937 rng(8);
  scene.addRectangle( // a table top on it
      {0, -0.4f, 1.02f},
      {2, 0, 0},
      {0, 0.9f, 0},
      {0, 0, 1},
      rail,
      spacing,
      noise,
      rng);
  parted(scene, inPieces(scene), {}, 0);
  StraightBarOptions options;
  options.min_clear = 0;
  EXPECT_GT(segmentCount(parted(scene, inPieces(scene), options)), 4u);
}

TEST(StraightBars, LeaveOutWhatIsFlagged)
{
  const auto scene = balustrade();
  auto labels = inPieces(scene);
  const auto voxels = surfaceVoxels(scene.points, {}, 0.03);
  std::vector<std::uint8_t> left_out;
  for (const auto& point : scene.points)
    left_out.push_back(point.z() > 0.85f);
  EXPECT_EQ(partAtBars(scene.points, voxels, left_out, {}, labels), 0u);
  EXPECT_EQ(labels, inPieces(scene));
}

TEST(StraightBars, DoNotDependOnTheOrderOfPoints)
{
  const auto scene = balustrade();
  const auto labels = parted(scene, inPieces(scene));
  std::mt19937 rng(2);
  const auto order = shuffledOrder(scene.points.size(), rng);
  std::vector<std::uint32_t> expected;
  for (const auto i : order)
    expected.push_back(labels[i]);
  const auto shuffled = scene.reordered(order);
  EXPECT_EQ(renamed(parted(shuffled, inPieces(shuffled))), renamed(expected));
}

TEST(StraightBars, RefuseWhatDoesNotFit)
{
  const auto scene = balustrade();
  const auto voxels = surfaceVoxels(scene.points, {}, 0.03);
  const std::vector<std::uint8_t> left_out(scene.points.size(), 0);
  auto segments = inPieces(scene);
  segments.pop_back();
  EXPECT_THROW(partAtBars(scene.points, voxels, left_out, {}, segments),
               pcl::BadArgumentException);
  segments = inPieces(scene);
  const auto refused = [&](auto change) {
    StraightBarOptions options;
    change(options);
    EXPECT_THROW(partAtBars(scene.points, voxels, left_out, options, segments),
                 pcl::BadArgumentException);
  };
  refused([](auto& o) { o.voxel_size = 0; });
  refused([](auto& o) { o.axes.col(0) *= 2; });
  refused([](auto& o) { o.up = Eigen::Vector3f::Zero(); });
  refused([](auto& o) { o.min_elongation = 0.5; });
  refused([](auto& o) { o.max_flatness = 0; });
  refused([](auto& o) { o.min_clear = 1.1; });
  refused([](auto& o) { o.min_length = std::nan(""); });
  refused([](auto& o) { o.min_stretch = -1; });
  refused([](auto& o) { o.max_break = -1; });
  refused([](auto& o) { o.max_share = -1; });
  refused([](auto& o) { o.min_beam = -1; });
  segments.clear();
  EXPECT_EQ(partAtBars({}, surfaceVoxels({}, {}, 0.03), {}, {}, segments), 0u);
}

} // namespace
