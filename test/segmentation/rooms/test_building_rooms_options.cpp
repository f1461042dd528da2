/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/thesis.h>

#include "support/synthetic_scenes.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

using namespace pcl::indoor;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

template <typename Options>
void
expectRefused(const Options& options, const char* what, double value)
{
  EXPECT_NE(findProblem(options), "") << what << ' ' << value;
  EXPECT_THROW(segmentBuilding({{1, 1, 1}}, options), pcl::BadArgumentException)
      << what << ' ' << value;
}

/** Two rooms of coarse points are segmented somehow. */
template <typename Options>
void
expectRuns(const Options& options, const char* what, double value)
{
  static const auto scene = test::twoRooms(0.005f, 0.08f);
  BuildingRooms building;
  EXPECT_NO_THROW(building = segmentBuilding(scene.points, options))
      << what << ' ' << value;
  EXPECT_EQ(building.point_labels.size(), scene.points.size()) << what << ' ' << value;
}

/** A field takes its legal values, with which rooms are found, and refuses NaN and the
 * others. */
template <typename Options, typename Field>
void
check(const char* what,
      const Field& field,
      const std::vector<double>& legal,
      std::vector<double> illegal)
{
  using Value = std::remove_reference_t<decltype(field(std::declval<Options&>()))>;
  if (std::is_floating_point_v<Value>)
    illegal.push_back(nan_value);
  for (const double value : legal) {
    Options options;
    field(options) = static_cast<Value>(value);
    EXPECT_EQ(findProblem(options), "") << what << ' ' << value;
    expectRuns(options, what, value);
  }
  for (const double value : illegal) {
    Options options;
    field(options) = static_cast<Value>(value);
    expectRefused(options, what, value);
  }
}

const std::vector<double> bad_length = {-0.1, 1001, infinity};
const std::vector<double> bad_positive = {0, -0.1, 1001, infinity};
const std::vector<double> bad_share = {-0.1, 1.1};
const std::vector<double> bad_area = {-0.1};
const std::vector<double> bad_weight = {-0.1, infinity};
const std::vector<double> bad_evidence = {-0.1, 80.1, infinity};

} // namespace

#define CHECK_FIELD_OF(OPTIONS, FIELD, LEGAL, ILLEGAL)                                 \
  check<OPTIONS>(                                                                      \
      #FIELD, [](auto& o) -> auto& { return o.FIELD; }, LEGAL, ILLEGAL)
#define CHECK_FIELD(FIELD, LEGAL, ILLEGAL)                                             \
  CHECK_FIELD_OF(BuildingRoomsOptions, FIELD, LEGAL, ILLEGAL)
#define CHECK_THESIS(FIELD, LEGAL, ILLEGAL)                                            \
  CHECK_FIELD_OF(thesis::RoomOptions, FIELD, LEGAL, ILLEGAL)

TEST(BuildingRoomsOptions, DefaultsAreLegal)
{
  EXPECT_EQ(findProblem(BuildingRoomsOptions()), "");
}

TEST(BuildingRoomsOptions, TheComplaintNamesValueAndRange)
{
  BuildingRoomsOptions options;
  options.map.slab.gap = -0.5;
  EXPECT_EQ(findProblem(options),
            "The gap below the ceiling must lie in 0 ... 1000 m, not -0.5 m.");
  options.voxel_size = nan_value;
  EXPECT_EQ(findProblem(options),
            "The voxel size must lie in 0 ... 1000 m, not nan m.");
  options.voxel_size = 9e-5; // lengths in such voxels would not fit into an int
  EXPECT_EQ(findProblem(options),
            "The voxel size must be 0 or at least 0.0001 m, not 9e-05 m.");
}

TEST(BuildingRoomsOptions, FieldsOfBuildingAndInterior)
{
  using V = std::vector<double>;
  CHECK_FIELD(voxel_size, (V{0, 0.02, 1000}), bad_length);
  CHECK_FIELD(threads, (V{0, 8}), V{-1});
  CHECK_FIELD(interior.voxel_size, (V{1e-4, 1000}), bad_positive);
  CHECK_FIELD(interior.weights.below, (V{0, 80}), bad_evidence);
  CHECK_FIELD(interior.weights.above, (V{0, 80}), bad_evidence);
  CHECK_FIELD(interior.weights.vertical, (V{0, 80}), bad_evidence);
  CHECK_FIELD(interior.weights.horizontal, (V{0, 80}), bad_evidence);
  CHECK_FIELD(interior.weights.exterior, (V{0, 80}), bad_evidence);
  CHECK_FIELD(interior.smoothness, (V{0, 100}), bad_weight);
  CHECK_FIELD(interior.max_directions, (V{0, 5}), V{6});
  CHECK_FIELD(interior.min_direction_support, (V{0, 1}), bad_share);
}

TEST(BuildingRoomsOptions, FieldsOfStoreysAndWalls)
{
  using V = std::vector<double>;
  CHECK_FIELD(storeys.min_clearance, (V{1e-4, 1000}), bad_positive);
  CHECK_FIELD(storeys.max_slab, (V{0, 1000}), bad_length);
  CHECK_FIELD(storeys.min_slab_area, (V{1, infinity}), (V{0, -1}));
  CHECK_FIELD(storeys.bridge, (V{0, 1000}), bad_length);
  CHECK_FIELD(storeys.min_opening_area, (V{0, infinity}), bad_area);
  CHECK_FIELD(walls.window, (V{1e-4, 1000}), bad_positive);
  CHECK_FIELD(walls.max_thickness, (V{0, 1000}), bad_length);
  CHECK_FIELD(walls.reach, (V{0, 1000}), bad_length);
  CHECK_FIELD(walls.min_points, (V{2, 1e9}), (V{0, 1}));
}

TEST(BuildingRoomsOptions, FieldsOfTheMap)
{
  using V = std::vector<double>;
  CHECK_FIELD(map.slab.window, (V{0, 1000}), bad_length);
  CHECK_FIELD(map.slab.step, (V{0, 1000}), bad_length);
  CHECK_FIELD(map.slab.level_share, (V{0, 1}), bad_share);
  CHECK_FIELD(map.slab.min_height, (V{0, 1000}), bad_length);
  CHECK_FIELD(map.slab.gap, (V{0, 1000}), bad_length);
  CHECK_FIELD(map.slab.max_gap, (V{0, 1000}), bad_length);
  CHECK_FIELD(map.slab.min_wall, (V{0, 1000}), bad_length);
  CHECK_FIELD(map.slab.depth, (V{1e-4, 1000}), bad_positive);
  CHECK_FIELD(map.persistence, (V{0, 1}), bad_share);
  CHECK_FIELD(map.merging.open_share, (V{0, 1}), bad_share);
  CHECK_FIELD(map.door_width, (V{0, 1000}), bad_length);
  CHECK_FIELD(map.merging.door_share, (V{0, 1}), bad_share);
  CHECK_FIELD(map.open_plan.min_wall_share, (V{0, 1}), bad_share);
  CHECK_FIELD(map.merging.open_height, (V{0, 1}), bad_share);
  CHECK_FIELD(map.open_plan.habitable_area, (V{0, infinity}), bad_area);
  CHECK_FIELD(map.open_plan.max_elongation, (V{0, infinity}), bad_area);
  CHECK_FIELD(map.open_plan.persistence, (V{0, 1}), bad_share);
  CHECK_FIELD(map.open_plan.max_shared_view, (V{0, 1}), bad_share);
  CHECK_FIELD(map.min_width, (V{0, 1000}), bad_length);
  CHECK_FIELD(map.min_area, (V{0, infinity}), bad_area);
  CHECK_FIELD(map.reach, (V{0, 1000}), bad_length);
}

TEST(BuildingRoomsOptions, FieldsOfThePotentialField)
{
  using V = std::vector<double>;
  CHECK_THESIS(field.distance.visibility_weight, (V{0, 70}), bad_weight);
  CHECK_THESIS(field.distance.euclidean_weight, (V{0, 70}), bad_weight);
  CHECK_THESIS(field.distance.field_weight, (V{0, 70}), bad_weight);
  CHECK_THESIS(field.distance.euclidean_scale, (V{0, 70}), bad_weight);
  CHECK_THESIS(field.peaks.bins, (V{1, 64}), (V{0, -1}));
  CHECK_THESIS(field.peaks.smoothing, (V{0, 1}), V{-1});
  CHECK_THESIS(field.peaks.prominence, (V{0, 1}), bad_area);
  CHECK_THESIS(field.dbscan_distance, (V{0, 25}), bad_weight);
  CHECK_THESIS(field.min_cluster_area, V{2}, (V{0, -1, infinity}));
  CHECK_THESIS(field.sample_area, V{2}, (V{0, -1, infinity}));
  CHECK_THESIS(field.landmark_spacing, (V{0, 1000}), bad_length);
  CHECK_THESIS(field.beta, (V{0, 100}), bad_weight);
}

TEST(BuildingRoomsOptions, TheHeaviestWeightsFitTogether)
{
  BuildingRoomsOptions options;
  options.interior.weights = {80, 80, 80, 80, 0};
  expectRuns(options, "all weights", 80);
  options.interior.weights = {0, 0, 0, 0, 80};
  expectRuns(options, "exterior alone", 80);
}

TEST(BuildingRoomsOptions, MoreWallDirectionsThanAreLookedFor)
{
  auto points = test::twoRooms(0.005f, 0.08f).points;
  for (const double yaw : {0.5, 1.0}) // three frames of walls, six directions
    for (const auto& point : test::turned(test::twoRooms(0.005f, 0.08f).points, yaw))
      points.push_back(point + Eigen::Vector3f(static_cast<float>(20 * yaw), 12, 0));
  BuildingRoomsOptions options;
  options.interior.max_directions = 5;
  options.interior.min_direction_support = 0.0;
  EXPECT_NO_THROW(segmentBuilding(points, options));
}
