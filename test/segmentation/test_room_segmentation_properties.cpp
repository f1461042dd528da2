/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// What changes of the cloud do to rooms, over random buildings.
#include "support/cloud_changes.h"
#include "support/room_labels.h"

#include <pcl/segmentation/segmentation_metrics.h>

#include <gtest/gtest.h>

using namespace pcl::indoor;
using namespace pcl::indoor::test;
using Points = std::vector<Eigen::Vector3f>;

namespace {

constexpr unsigned room_trials = 4;

/** A row of two to four rooms of random sizes, doors between them, a box in each. */
Points
randomBuilding(unsigned seed)
{
  std::mt19937 rng(seed);
  std::vector<RoomBox> boxes;
  std::vector<Opening> doors;
  const float height = drawn(2.3f, 3.5f, rng);
  float x = 0;
  for (std::uint32_t room = 1, count = 2 + rng() % 3; room <= count; ++room) {
    const float width = drawn(2.5f, 4.5f, rng);
    const float depth = drawn(2.8f, 4.0f, rng), begin = drawn(0.5f, 1.5f, rng);
    if (room > 1)
      doors.push_back(doorway(x - 0.25f, x + 0.05f, begin, begin + 0.9f, 2.0f));
    boxes.push_back({{x, 0, 0}, {x + width, depth, height}, room});
    x += width + 0.2f;
  }
  auto scene = rooms(boxes, doors, 0.05f, 0.005f, seed);
  for (const auto& box : boxes)
    scene.addBox({drawn(box.low.x(), box.high.x() - 1.2f, rng), 0.3f, 0},
                 {drawn(0.4f, 1.2f, rng), 0.6f, drawn(0.4f, 1.8f, rng)},
                 box.room,
                 0.05f,
                 0.005f,
                 rng);
  return scene.points;
}

Labels
roomLabelsOf(const Points& points)
{
  const auto labels = segmented(cloudOf(points));
  EXPECT_EQ(labels.size(), points.size());
  return labels;
}

} // namespace

TEST(RoomProperties, AnyNumberOfThreadsGivesTheSameLabels)
{
  for (unsigned seed = 0; seed < room_trials; ++seed) {
    pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
    segmentation.setInputCloud(cloudOf(randomBuilding(seed)));
    Labels one, many;
    segmentation.setNumberOfThreads(1);
    segmentation.segment(one);
    EXPECT_GE(roomCount(one), 2u) << seed;
    for (const int threads : {2, 7}) {
      segmentation.setNumberOfThreads(threads);
      segmentation.segment(many);
      EXPECT_EQ(many, one) << seed << ", " << threads << " threads";
    }
  }
}

TEST(RoomProperties, AnotherOrderOfPointsGivesTheSameLabelsUpToNames)
{
  for (unsigned seed = 0; seed < room_trials; ++seed) {
    const auto points = randomBuilding(seed);
    std::mt19937 rng(seed);
    const auto order = shuffledOrder(points.size(), rng);
    const auto labels = roomLabelsOf(inOrder(points, order));
    EXPECT_EQ(renamed(backFrom(labels, order, points.size())),
              renamed(roomLabelsOf(points)))
        << seed;
  }
}

TEST(RoomProperties, CopiesOfPointsChangeNoLabel)
{
  for (unsigned seed = 0; seed < room_trials; ++seed) {
    const auto points = randomBuilding(seed);
    const auto order = withCopies(points.size());
    const auto labels = roomLabelsOf(inOrder(points, order));
    EXPECT_EQ(labels, inOrder(roomLabelsOf(points), order)) << seed;
  }
}

TEST(RoomProperties, BadPointsGetNoLabelAndChangeNoOther)
{
  for (unsigned seed = 0; seed < room_trials; ++seed)
    expectBadPointsToChangeNoLabel(randomBuilding(seed), seed, roomLabelsOf);
}

TEST(RoomProperties, IndicesGiveTheLabelsOfTheirPointsAlone)
{
  for (unsigned seed = 0; seed < room_trials; ++seed) {
    const auto points = randomBuilding(seed);
    std::mt19937 rng(seed);
    const auto subset = randomSubset(points.size(), rng);
    pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
    segmentation.setInputCloud(cloudOf(points));
    segmentation.setIndices(
        pcl::make_shared<pcl::Indices>(subset.begin(), subset.end()));
    Labels labels;
    segmentation.segment(labels);
    EXPECT_EQ(labels,
              backFrom(roomLabelsOf(inOrder(points, subset)), subset, points.size()))
        << seed;
  }
}

TEST(RoomProperties, LargeCoordinatesLoseNoMoreThanTheirFloats)
{
  for (unsigned seed = 0; seed < room_trials; ++seed) {
    const auto points = onRaster(randomBuilding(seed));
    EXPECT_EQ(roomLabelsOf(shifted(points, {16384, -8192, 512})), roomLabelsOf(points))
        << seed;
    const UtmPoints utm(points); // rounded to half metres in y
    EXPECT_EQ(roomLabelsOf(utm.far), roomLabelsOf(utm.near)) << seed;
  }
}

TEST(RoomProperties, TurnedAboutTheVerticalTheRoomsAreTheSame)
{
  for (unsigned seed = 0; seed < room_trials; ++seed) {
    const auto points = randomBuilding(seed);
    const auto labels = roomLabelsOf(points);
    for (const double degrees : {13.0, 90.0, 211.0}) {
      const auto other = roomLabelsOf(turned(points, degrees * M_PI / 180));
      EXPECT_EQ(roomCount(other), roomCount(labels)) << seed << ", " << degrees;
      // Along walls the map's pixels decide: they turn with the building only so far.
      EXPECT_GT(adjustedRandIndex(countOverlaps(labels, other)), 0.97)
          << seed << ", " << degrees;
    }
  }
}
