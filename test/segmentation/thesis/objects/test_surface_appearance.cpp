/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

/* Supervoxels and graph with colour and FPFH, Eq. (2.18) and (2.19): two parts of one
 * plane that nothing else tells apart. */

#include "objects/object_steps.h"
#include "thesis/objects/edge_partition.h"
#include "thesis/objects/point_surface.h"

#include <pcl/exceptions.h>
#include <pcl/segmentation/noise_resilient_lccp.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace pcl::indoor;

namespace {

const Eigen::Vector3f red(200, 0, 0), blue(0, 0, 200);
constexpr float border = 0.42f; // between the two parts, along x

bool
isFirst(const Eigen::Vector3f& point)
{
  return point.x() < border;
}

/** A plate of 84 x 36 cm, a point per cm, all in one plane with one normal. */
ObjectSegmentationInput
plate()
{
  ObjectSegmentationInput input;
  for (int x = 0; x < 84; ++x)
    for (int y = 0; y < 36; ++y) {
      input.points.emplace_back(0.01f * (static_cast<float>(x) + 0.5f),
                                0.01f * (static_cast<float>(y) + 0.5f),
                                0.0f);
      input.normals.emplace_back(0, 0, 1);
    }
  return input;
}

/** Its parts have two colours. */
ObjectSegmentationInput
twoColors()
{
  auto input = plate();
  for (const auto& point : input.points)
    input.colors.push_back(isFirst(point) ? red : blue);
  return input;
}

/** The normals of its second part lean to one side and the other, from point to point:
 * their mean in a voxel is that of the first part. */
ObjectSegmentationInput
twoShapes()
{
  auto input = plate();
  for (std::size_t i = 0; i < input.points.size(); ++i)
    if (!isFirst(input.points[i])) {
      const float lean = (i / 36 + i % 36) % 2 == 0 ? 0.6f : -0.6f;
      input.normals[i] = {lean, 0, 0.8f};
    }
  return input;
}

thesis::ObjectOptions
optionsWith(float color_weight, float fpfh_weight)
{
  auto options = thesisOptions();
  options.on_points->ransac_share = 0;
  options.on_points->color_weight = color_weight;
  options.on_points->fpfh_weight = fpfh_weight;
  options.edges.graph_scale = 0.3f;
  return options;
}

/** The labels of the points of each part that are not at the border. */
struct LabelsOfParts {
  std::set<std::uint32_t> first, second;

  bool
  areApart() const
  {
    return std::none_of(first.begin(), first.end(), [this](std::uint32_t label) {
      return second.count(label) > 0;
    });
  }
};

LabelsOfParts
labelsOfParts(const std::vector<Eigen::Vector3f>& points,
              const std::vector<std::uint32_t>& labels,
              float border_width = 0.03f)
{
  LabelsOfParts parts;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::abs(points[i].x() - border) > border_width)
      (isFirst(points[i]) ? parts.first : parts.second).insert(labels[i]);
  return parts;
}

/** Does the weight tell the parts apart, in supervoxels and in segments, and only the
 * weight? */
void
expectOnlyTheWeightParts(const ObjectSegmentationInput& input,
                         const thesis::ObjectOptions& without,
                         const thesis::ObjectOptions& with,
                         float border_width = 0.03f)
{
  EXPECT_EQ(segmentObjects(input, without).segment_count, 1u);
  const auto two = segmentObjects(input, with);
  EXPECT_TRUE(
      labelsOfParts(input.points, stepsOf(two).supervoxels.label_of_voxel, border_width)
          .areApart());
  const auto parts = labelsOfParts(input.points, two.segment_of_point, border_width);
  EXPECT_TRUE(parts.areApart());
  EXPECT_EQ(parts.first.size(), 1u);
  EXPECT_EQ(parts.second.size(), 1u);
}

} // namespace

TEST(SurfaceAppearance, ColorsAreCIELab)
{
  // of the standard sRGB under D65, as colour tables have them
  const std::vector<std::pair<Eigen::Vector3f, Eigen::Vector3f>> known{
      {{255, 255, 255}, {100, 0, 0}},
      {{0, 0, 0}, {0, 0, 0}},
      {{255, 0, 0}, {53.24f, 80.09f, 67.20f}},
      {{0, 255, 0}, {87.73f, -86.18f, 83.18f}},
      {{0, 0, 255}, {32.30f, 79.19f, -107.86f}},
      {{128, 128, 128}, {53.59f, 0, 0}},
      {{5, 5, 5}, {1.37f, 0, 0}}}; // the straight part of both curves
  for (const auto& [rgb, lab] : known)
    EXPECT_LT((labOfRgb(rgb) - lab).norm(), 0.05f) << rgb.transpose();
}

TEST(SurfaceAppearance, DistanceIsTheWeightedSumOfItsParts)
{
  SurfaceAppearance one, other;
  one.colors.resize(3, 2);
  one.colors << 0, 10, 0, 20, 0, 30;
  other.colors = one.colors;
  one.shapes = Eigen::MatrixXf::Zero(33, 2);
  one.shapes(0, 0) = 1;
  one.shapes(4, 1) = 0.75f;
  one.shapes(0, 1) = 0.25f;
  other.shapes = one.shapes;
  SurfaceDistance distance;
  EXPECT_EQ(distance.ofAppearance(one, 0, other, 1), 0) << "no weights";
  distance.color_weight = 2;
  EXPECT_NEAR(distance.ofAppearance(one, 0, other, 1), 2 * std::sqrt(0.14), 1e-6);
  distance.shape_weight = 4;
  EXPECT_NEAR(distance.ofAppearance(one, 0, other, 1), 2 * std::sqrt(0.14) + 3, 1e-6);
  EXPECT_EQ(distance.ofAppearance(one, 1, other, 1), 0);
  other.colors.resize(3, 0);
  EXPECT_NEAR(distance.ofAppearance(one, 0, other, 1), 3, 1e-6);
}

TEST(SurfaceAppearance, EdgesWeighColorsAndShapes)
{
  Supervoxels supervoxels;
  supervoxels.centroids = {{0, 0, 0}, {0.12f, 0, 0}};
  supervoxels.normals = {{0, 0, 1}, {0, 0, 1}};
  supervoxels.appearance.colors.resize(3, 2);
  supervoxels.appearance.colors << 0, 100, 0, 0, 0, 0; // black and white
  SurfaceDistance distance;
  distance.color_weight = 0.3f;
  for (const bool convex : {true, false}) {
    const auto edges = weighEdges(supervoxels, {{0, 1, 1}}, {convex}, distance, 0.25f);
    EXPECT_NEAR(edges[0].weight, convex ? 0.25 * 0.5 * 0.5 : 0.5, 1e-6); // w_s + w_c
  }
}

TEST(SurfaceAppearance, OnlyTheColorTellsTwoPartsApart)
{
  expectOnlyTheWeightParts(twoColors(), optionsWith(0, 0), optionsWith(1, 0));
  const auto blind = segmentObjects(twoColors(), optionsWith(0, 0));
  EXPECT_FALSE(labelsOfParts(plate().points, stepsOf(blind).supervoxels.label_of_voxel)
                   .areApart());
  const auto result = segmentObjects(twoColors(), optionsWith(1, 0));
  const auto& looks = stepsOf(result).supervoxels.appearance.colors;
  ASSERT_EQ(looks.cols(),
            static_cast<Eigen::Index>(stepsOf(result).supervoxels.size()));
  for (Eigen::Index s = 0; s < looks.cols(); ++s) {
    const float x =
        stepsOf(result).supervoxels.centroids[static_cast<std::size_t>(s)].x();
    if (std::abs(x - border) > 0.06f) { // PCL has whole numbers
      EXPECT_LT((looks.col(s) - labOfRgb(x < border ? red : blue)).norm(), 1.8f);
    }
  }
}

TEST(SurfaceAppearance, OnlyTheShapeTellsTwoPartsApart)
{
  // within twice the radius of FPFH of the border are shapes of both
  expectOnlyTheWeightParts(twoShapes(), optionsWith(0, 0), optionsWith(0, 3), 0.12f);
  // what parts them is the weight, not the other way of growing
  EXPECT_EQ(segmentObjects(twoShapes(), optionsWith(0, 1e-6f)).segment_count, 1u);
}

TEST(SurfaceAppearance, ColorAndShapeTogether)
{
  auto colors = optionsWith(1, 1e-6f), none = optionsWith(1e-6f, 1e-6f);
  expectOnlyTheWeightParts(twoColors(), none, colors);
  auto input = twoShapes();
  input.capture = Capture::TableView;
  for (auto& point : input.points)
    point.z() += 1;
  input.viewpoint = {Eigen::Vector3f::Zero()};
  const auto result = segmentObjects(input, optionsWith(0, 3));
  EXPECT_TRUE(labelsOfParts(input.points, result.segment_of_point).areApart());
  auto lccp = optionsWith(0, 3); // convex everywhere: no weight counts
  lccp.edges.partition = thesis::EdgePartition::Lccp;
  EXPECT_EQ(segmentObjects(twoShapes(), lccp).segment_count, 1u);
}

TEST(SurfaceAppearance, TheSameForAnyNumberOfThreads)
{
  auto options = optionsWith(0, 3);
  options.shared.threads = 1;
  const auto one = segmentObjects(twoShapes(), options);
  options.shared.threads = 7;
  const auto seven = segmentObjects(twoShapes(), options);
  EXPECT_EQ(stepsOf(seven).supervoxels.label_of_voxel,
            stepsOf(one).supervoxels.label_of_voxel);
  EXPECT_EQ(seven.segment_of_point, one.segment_of_point);
}

TEST(SurfaceAppearance, BadWeightsAndColorsAreRefused)
{
  for (const float bad : {-1.0f, std::nanf(""), HUGE_VALF}) {
    EXPECT_NE(findProblem(optionsWith(bad, 0)), "");
    EXPECT_NE(findProblem(optionsWith(0, bad)), "");
  }
  EXPECT_EQ(findProblem(optionsWith(1, 1)), "");
  EXPECT_THROW(segmentObjects(plate(), optionsWith(1, 0)), pcl::BadArgumentException);
  auto input = twoColors();
  input.colors.pop_back();
  EXPECT_THROW(segmentObjects(input, optionsWith(1, 0)), pcl::BadArgumentException);
}

TEST(NoiseResilientLCCP, TakesColorsOfPointsOrGivenOnes)
{
  const auto input = twoColors();
  const auto colored = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>>();
  const auto plain = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  const auto colors = pcl::make_shared<pcl::PointCloud<pcl::RGB>>();
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    const auto& place = input.points[i];
    const Eigen::Matrix<std::uint8_t, 3, 1> c = input.colors[i].cast<std::uint8_t>();
    colored->push_back({place.x(), place.y(), place.z(), c[0], c[1], c[2]});
    plain->push_back({place.x(), place.y(), place.z()});
    colors->push_back({c[0], c[1], c[2]});
  }
  std::vector<std::uint32_t> own, given;
  pcl::NoiseResilientLCCP<pcl::PointXYZRGB> with_colors;
  with_colors.setThesisOptions(optionsWith(1, 0));
  with_colors.setInputCloud(colored);
  with_colors.segment(own);
  EXPECT_TRUE(labelsOfParts(input.points, own).areApart());
  pcl::NoiseResilientLCCP<pcl::PointXYZ> without;
  without.setThesisOptions(optionsWith(1, 0));
  without.setInputCloud(plain);
  without.segment(given);
  EXPECT_TRUE(given.empty()) << "no colours";
  without.setInputColors(colors);
  EXPECT_EQ(without.getInputColors(), colors);
  without.segment(given);
  EXPECT_EQ(given, own);
  colors->push_back({1, 2, 3});
  without.segment(given);
  EXPECT_TRUE(given.empty()) << "one more than points";
}
