/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

// Stations are given in the frame and the unit of the cloud.
#include "support/room_labels.h"

#include <pcl/console/print.h>

#include <gtest/gtest.h>

using namespace pcl::indoor::test;
using pcl::indoor::ScanStations;

namespace {

using Points = std::vector<Eigen::Vector3f>;
using RoomSegmentationXYZ = pcl::RoomSegmentation<pcl::PointXYZ>;

class Stations : public testing::Test {
protected:
  void
  SetUp() override
  {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }

  void
  TearDown() override
  {
    pcl::console::setVerbosityLevel(pcl::console::L_INFO);
  }

  /** Two rooms with a wall between them that nothing leads through. */
  const Points points_ =
      rooms({{{0, 0, 0}, {4, 3, 2.5f}, 1}, {{4.1f, 0, 0}, {7.1f, 3, 2.5f}, 2}}, {})
          .points;
  const Eigen::Vector3d in_first_{1.0, 1.5, 1.5}, in_second_{5.6, 1.5, 1.5};
};

std::size_t
roomsFound(RoomSegmentationXYZ& segmentation)
{
  Labels labels;
  segmentation.segment(labels);
  return segmentation.getRooms().size();
}

} // namespace

TEST_F(Stations, TheyTellRoomsThatWereEntered)
{
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloudOf(points_));
  EXPECT_EQ(roomsFound(segmentation), 2u);
  segmentation.setStations({{in_first_}, {}});
  EXPECT_EQ(roomsFound(segmentation), 1u);
  EXPECT_EQ(segmentation.getReport().warnings.size(), 1u);
  segmentation.setStations({{in_first_, in_second_}, {}});
  EXPECT_EQ(roomsFound(segmentation), 2u);
  EXPECT_EQ(segmentation.getStations().positions.size(), 2u);
  segmentation.setStations({});
  EXPECT_EQ(roomsFound(segmentation), 2u);
}

TEST_F(Stations, TheyAreInTheUnitAndFrameOfTheCloud)
{
  Points lying;
  for (const auto& p : points_)
    lying.emplace_back(1000.0f * p.x(), 1000.0f * p.z(), -1000.0f * p.y()); // y is up
  const Eigen::Vector3d station(1000.0, 1500.0, -1500.0);
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloudOf(lying));
  segmentation.setMetresPerUnit(0.001);
  segmentation.setUpAxis(Eigen::Vector3f::UnitY());
  EXPECT_EQ(roomsFound(segmentation), 2u);
  segmentation.setStations({{station}, {}});
  EXPECT_EQ(roomsFound(segmentation), 1u);
}

TEST_F(Stations, IndicesAndCopiesKeepTheirStations)
{
  Points twice = points_;
  twice.insert(twice.end(), points_.begin(), points_.end());
  ScanStations stations{{in_first_, in_second_}, {}};
  for (const auto& p : twice) // the second is said to be seen from the first
    stations.of_point.push_back(p.x() < 4.05f ? 2 : 1);
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloudOf(twice));
  segmentation.setStations({{in_first_}, std::vector<std::uint32_t>(twice.size(), 1)});
  EXPECT_EQ(roomsFound(segmentation), 1u);
  const auto half = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < points_.size(); ++i)
    half->push_back(static_cast<pcl::index_t>(points_.size() + i));
  segmentation.setIndices(half);
  EXPECT_EQ(roomsFound(segmentation), 1u);
  segmentation.setStations(stations); // both hold a station, whatever points say
  EXPECT_EQ(roomsFound(segmentation), 2u);
}

TEST_F(Stations, AsManyAsPointsOrNone)
{
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloudOf(points_));
  segmentation.setStations({{in_first_}, {1, 1}});
  Labels labels{1};
  segmentation.segment(labels);
  EXPECT_TRUE(labels.empty());
}
