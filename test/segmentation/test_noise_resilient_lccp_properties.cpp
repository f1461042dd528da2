/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// What changes of the cloud do to objects, over random scenes.
#include "segmentation/objects/segmented_scene.h"
#include "support/cloud_changes.h"
#include "support/synthetic_scenes.h" // for turned

#include <gtest/gtest.h>

using namespace pcl::indoor;
using namespace pcl::indoor::test;
using Points = std::vector<Eigen::Vector3f>;

namespace {

constexpr unsigned object_trials = 3;

/** A floor with two or three boxes on it, and a wall behind them. */
Points
randomScene(unsigned seed)
{
  std::mt19937 rng(seed);
  LabelledPoints scene;
  const float depth = drawn(1.6f, 2.4f, rng);
  const std::size_t boxes = 2 + rng() % 2;
  const float width = 1.3f * static_cast<float>(boxes);
  scene.addRectangle(
      {0, 0, 0}, {width, 0, 0}, {0, depth, 0}, {0, 0, 1}, 1, 0.02f, 0.003f, rng);
  scene.addRectangle(
      {0, depth, 0}, {width, 0, 0}, {0, 0, 1.5f}, {0, -1, 0}, 2, 0.02f, 0.003f, rng);
  for (std::size_t b = 0; b < boxes; ++b)
    scene.addBox({1.3f * static_cast<float>(b) + drawn(0.1f, 0.3f, rng), 0.4f, 0},
                 {drawn(0.3f, 0.8f, rng), drawn(0.4f, 0.9f, rng), drawn(0.3f, 1, rng)},
                 static_cast<std::uint32_t>(3 + b),
                 0.02f,
                 0.003f,
                 rng);
  return scene.points;
}

/** The viewpoint moves with the points. */
Labels
labelsOf(const Points& points, const Eigen::Vector3d& viewpoint = {2, -1, 3})
{
  Segmentation segmentation;
  segmentation.setInputCloud(cloudOf(points));
  segmentation.setViewPoint(viewpoint.x(), viewpoint.y(), viewpoint.z());
  Labels labels;
  segmentation.segment(labels);
  EXPECT_EQ(labels.size(), points.size());
  return labels;
}

} // namespace

TEST(ObjectProperties, AnyNumberOfThreadsGivesTheSameLabels)
{
  for (unsigned seed = 0; seed < object_trials; ++seed) {
    Segmentation segmentation;
    segmentation.setInputCloud(cloudOf(randomScene(seed)));
    Labels one, many;
    segmentation.setNumberOfThreads(1);
    segmentation.segment(one);
    EXPECT_GE(segmentCount(one), 3u) << seed;
    for (const unsigned threads : {2u, 7u}) {
      segmentation.setNumberOfThreads(threads);
      segmentation.segment(many);
      EXPECT_EQ(many, one) << seed << ", " << threads << " threads";
    }
  }
}

TEST(ObjectProperties, AnotherOrderOfPointsGivesNearlyTheSameLabelsUpToNames)
{
  for (unsigned seed = 0; seed < object_trials; ++seed) {
    const auto points = randomScene(seed);
    std::mt19937 rng(seed);
    const auto order = shuffledOrder(points.size(), rng);
    const auto labels =
        backFrom(labelsOf(inOrder(points, order)), order, points.size());
    // Sums of a voxel's points are rounded in their order.
    EXPECT_GT(agreement(labelsOf(points), labels), 0.99) << seed;
  }
}

TEST(ObjectProperties, CopiesOfPointsHaveTheLabelOfTheirPlace)
{
  for (unsigned seed = 0; seed < object_trials; ++seed) {
    const auto points = randomScene(seed);
    const auto order = withCopies(points.size());
    const auto labels = labelsOf(inOrder(points, order));
    for (std::size_t k = points.size(); k < order.size(); ++k)
      ASSERT_EQ(labels[k], labels[order[k]]) << seed;
    // They weigh in the means of their voxels.
    EXPECT_GT(agreement(inOrder(labelsOf(points), order), labels), 0.97) << seed;
  }
}

TEST(ObjectProperties, BadPointsGetNoLabelAndChangeNoOther)
{
  for (unsigned seed = 0; seed < object_trials; ++seed)
    expectBadPointsToChangeNoLabel(
        randomScene(seed), seed, [](const Points& points) { return labelsOf(points); });
}

TEST(ObjectProperties, IndicesGiveTheLabelsOfTheirPointsAlone)
{
  for (unsigned seed = 0; seed < object_trials; ++seed) {
    const auto points = randomScene(seed);
    std::mt19937 rng(seed);
    const auto subset = randomSubset(points.size(), rng);
    Segmentation segmentation;
    segmentation.setInputCloud(cloudOf(points));
    segmentation.setIndices(
        pcl::make_shared<pcl::Indices>(subset.begin(), subset.end()));
    segmentation.setViewPoint(2, -1, 3);
    Labels labels;
    segmentation.segment(labels);
    EXPECT_EQ(labels,
              backFrom(labelsOf(inOrder(points, subset)), subset, points.size()))
        << seed;
  }
}

TEST(ObjectProperties, LargeCoordinatesLoseNoMoreThanTheirFloats)
{
  for (unsigned seed = 0; seed < object_trials; ++seed) {
    const auto points = onRaster(randomScene(seed));
    const Eigen::Vector3f by(16384, -8192, 512);
    EXPECT_EQ(labelsOf(shifted(points, by), Eigen::Vector3d(16386, -8193, 515)),
              labelsOf(points))
        << seed;
  }
}

TEST(ObjectProperties, UtmCoordinatesAsFloatsAreTheirPointsNearTheOrigin)
{
  for (unsigned seed = 0; seed < object_trials; ++seed) {
    const UtmPoints utm(randomScene(seed));
    const Eigen::Vector3d viewpoint(2, -1, 3);
    const auto labels = labelsOf(utm.near, viewpoint);
    EXPECT_GE(*std::max_element(labels.begin(), labels.end()), 3u) << seed;
    EXPECT_EQ(labelsOf(utm.far, viewpoint + utm.offset.cast<double>()), labels) << seed;
  }
}

TEST(ObjectProperties, TurnedAboutTheVerticalTheObjectsAreNearlyTheSame)
{
  for (unsigned seed = 0; seed < object_trials; ++seed) {
    const auto points = randomScene(seed);
    const auto labels = labelsOf(points);
    for (const double degrees : {90.0, 31.0, 211.0}) {
      const double yaw = degrees * M_PI / 180;
      const Eigen::Vector3d viewpoint =
          Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(2, -1, 3);
      // Other voxels, of which each point's is a mean: creases move by a voxel.
      EXPECT_GT(agreement(labels, labelsOf(turned(points, yaw), viewpoint)), 0.9)
          << seed << ", " << degrees;
    }
  }
}
