/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/labelled_points.h"

#include <pcl/exceptions.h>
#include <pcl/segmentation/thesis.h>

#include <gtest/gtest.h>

#include <limits>

using namespace pcl::indoor;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<float>::max();
constexpr double highest_weight = 1e6;
const std::vector<double> bad_weight{-0.01, 1.001e6, infinity};
const std::vector<double> bad_size{-0.01, infinity}, bad_share{-0.01, 1.01};
constexpr double highest = std::numeric_limits<std::uint32_t>::max();

/** A box on a floor, with colours and a viewpoint. */
ObjectSegmentationInput
smallScene(float spacing)
{
  std::mt19937 rng(3);
  test::LabelledPoints scene;
  scene.addRectangle(
      {0, 0, 0}, {1.2f, 0, 0}, {0, 0.8f, 0}, {0, 0, 1}, 1, spacing, 0.003f, rng);
  scene.addBox({0.3f, 0.2f, 0}, {0.4f, 0.3f, 0.3f}, 2, spacing, 0.003f, rng);
  ObjectSegmentationInput input;
  input.points = scene.points;
  for (const auto object : scene.objects)
    input.colors.emplace_back(object == 1 ? 255.0f : 0.0f, 128.0f, 0.0f);
  input.viewpoint = {Eigen::Vector3f(0.5f, -2, 2)};
  return input;
}

bool
isOnPoints(const ObjectSegmentationOptions& /*options*/)
{
  return false;
}

bool
isOnPoints(const thesis::ObjectOptions& options)
{
  return options.on_points.has_value();
}

/** Refuses the illegal values of a field, and runs with each legal one. */
template <typename Options, typename Field>
void
check(const char* what,
      const Options& others,
      const Field& field,
      const std::vector<double>& legal,
      std::vector<double> illegal)
{
  using Value = std::remove_reference_t<decltype(field(std::declval<Options&>()))>;
  static const auto on_voxels = smallScene(0.02f), on_points = smallScene(0.05f);
  const auto& input = isOnPoints(others) ? on_points : on_voxels;
  if (std::is_floating_point_v<Value>)
    illegal.push_back(nan_value);
  for (const double value : legal) {
    SCOPED_TRACE(testing::Message() << what << ' ' << value);
    auto options = others;
    field(options) = static_cast<Value>(value);
    ASSERT_EQ(findProblem(options), "");
    const auto result = segmentObjects(input, options);
    ASSERT_EQ(result.segment_of_point.size(), input.points.size());
    for (const auto segment : result.segment_of_point)
      ASSERT_TRUE(segment < result.segment_count ||
                  (isOnPoints(options) && segment == ObjectSegmentation::none));
  }
  for (const double value : illegal) {
    SCOPED_TRACE(testing::Message() << what << ' ' << value);
    auto options = others;
    field(options) = static_cast<Value>(value);
    EXPECT_NE(findProblem(options), "");
    EXPECT_THROW(segmentObjects(input, options), pcl::BadArgumentException);
  }
}

#define FIELD(name)                                                                    \
  [](auto& o) -> auto& { return o.name; }

} // namespace

TEST(ObjectSegmentationOptions, EachLegalEndRuns)
{
  const ObjectSegmentationOptions room;
  check("voxel_size", room, FIELD(voxel_size), {0, 0.005, 10, 1e300}, bad_size);
  check("seed_size", room, FIELD(seed_size), {0, 0.01, 10, 1e300}, bad_size);
  check("curvature_threshold",
        room,
        FIELD(curvature_threshold),
        {0, 1.0f / 3},
        {-0.01, 0.34});
  check("ratio_threshold", room, FIELD(ratio_threshold), {0, 1}, bad_share);
  check("spatial_weight", room, FIELD(spatial_weight), {0, highest_weight}, bad_weight);
  check("normal_weight", room, FIELD(normal_weight), {0, highest_weight}, bad_weight);
  check("min_segment_size", room, FIELD(min_segment_size), {0, 1, highest}, {});
  check("fewest_points", room, FIELD(fewest_points), {0, 1, highest}, {});
  check("threads", room, FIELD(threads), {0, 1, 5000}, {});
  for (const auto scale :
       {JoiningScale::Parts, JoiningScale::Objects, JoiningScale::View}) {
    auto options = room;
    options.pieces = {scale, 0.5f};
    check("joining_level",
          options,
          FIELD(pieces.joining_level.value()),
          {0, 1},
          bad_share);
  }
}

TEST(ObjectSegmentationOptions, EachLegalEndOfTheOtherPartitionsRuns)
{
  using thesis::EdgePartition;
  for (const auto partition :
       {EdgePartition::FelzenszwalbHuttenlocher, EdgePartition::Lccp})
    for (const bool on_points : {false, true}) {
      auto options = on_points ? thesisOptions() : thesis::ObjectOptions();
      options.edges.partition = partition;
      check("concavity_weight",
            options,
            FIELD(edges.concavity_weight),
            {0, 1},
            bad_share);
      check("concavity_tolerance_degrees",
            options,
            FIELD(edges.concavity_tolerance_degrees),
            {0, 180},
            {-0.01, 180.01});
      check("graph_scale", options, FIELD(edges.graph_scale), {0, largest}, bad_size);
      check("spatial_weight",
            options,
            FIELD(shared.spatial_weight),
            {0, highest_weight},
            bad_weight);
      check("normal_weight",
            options,
            FIELD(shared.normal_weight),
            {0, highest_weight},
            bad_weight);
      check("min_segment_size",
            options,
            FIELD(shared.min_segment_size),
            {0, highest},
            {});
    }
}

TEST(ObjectSegmentationOptions, EachLegalEndOnPointsRuns)
{
  const auto thesis = thesisOptions();
  check("removal_radius",
        thesis,
        FIELD(on_points->removal_radius),
        {0, 0.01, 10, 1e300},
        bad_size);
  check(
      "ransac_share", thesis, FIELD(on_points->ransac_share), {0, 1e-9, 1}, bad_share);
  check("color_weight",
        thesis,
        FIELD(on_points->color_weight),
        {0, highest_weight},
        bad_weight);
  check("fpfh_weight",
        thesis,
        FIELD(on_points->fpfh_weight),
        {0, highest_weight},
        bad_weight);
}

TEST(ObjectSegmentationOptions, CellsThatAreTooSmallForTheSceneAreRefused)
{
  ObjectSegmentationOptions voxels;
  voxels.voxel_size = 1e-7;
  auto points = thesisOptions();
  points.on_points->removal_radius = 1e-7;
  EXPECT_EQ(findProblem(voxels), "");
  EXPECT_EQ(findProblem(points), "");
  const auto input = smallScene(0.05f);
  EXPECT_THROW(segmentObjects(input, voxels), pcl::BadArgumentException);
  EXPECT_THROW(segmentObjects(input, points), pcl::BadArgumentException);
}
