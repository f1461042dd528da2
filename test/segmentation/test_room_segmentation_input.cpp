/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

// What may be wrong with the cloud: its unit, its up axis, far points, sparse points.
#include "support/room_labels.h"
#include "support/room_with_chairs.h"

#include <pcl/console/print.h>
#include <pcl/indoor/usable_point.h>
#include <pcl/segmentation/building_frame.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace pcl::indoor::test;

namespace {

using Points = std::vector<Eigen::Vector3f>;
using RoomSegmentationXYZ = pcl::RoomSegmentation<pcl::PointXYZ>;

class QuietInput : public testing::Test {
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
};

RoomSegmentationXYZ
segmentation(const Points& points, Labels& labels, double metres_per_unit = 1.0)
{
  RoomSegmentationXYZ result;
  result.setInputCloud(cloudOf(points));
  result.setMetresPerUnit(metres_per_unit);
  result.segment(labels);
  return result;
}

Points
scaled(const Points& points, double factor)
{
  Points result;
  for (const auto& point : points)
    result.push_back((point.cast<double>() * factor).cast<float>());
  return result;
}

std::size_t
differing(const Labels& a, const Labels& b)
{
  std::size_t count = a.size() != b.size();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    count += a[i] != b[i];
  return count;
}

} // namespace

TEST_F(QuietInput, OtherUnitsGiveTheSameRooms)
{
  const auto points = bentCorridorWithThreeRooms().points;
  Labels labels;
  const auto expected = segmentation(points, labels);
  EXPECT_TRUE(expected.getReport().warnings.empty());
  for (const double unit : {0.001, 0.01, 0.0254, 0.3048}) {
    const auto other = scaled(points, 1.0 / unit);
    Labels others;
    const auto result = segmentation(other, others, unit);
    EXPECT_TRUE(result.getReport().warnings.empty()) << unit;
    // rounding may carry a point on the border of two voxels over it
    EXPECT_LE(differing(others, labels), points.size() / 10000) << unit;
    ASSERT_EQ(result.getRooms().size(), expected.getRooms().size()) << unit;
    for (std::size_t i = 0; i < result.getRooms().size(); ++i) {
      const auto& room = result.getRooms()[i];
      const auto& same = expected.getRooms()[i];
      EXPECT_NEAR(room.area, same.area, 0.01);
      EXPECT_NEAR(room.height, same.height, 0.01);
      EXPECT_LT((room.lower * unit - same.lower).norm(), 0.01);
      EXPECT_LT((room.centroid * unit - same.centroid).norm(), 0.01);
      EXPECT_LT((room.footprint[0][0] * unit - same.footprint[0][0]).norm(), 0.15);
    }
    ASSERT_EQ(result.getOpenings().size(), expected.getOpenings().size());
    for (std::size_t i = 0; i < result.getOpenings().size(); ++i) {
      const auto& opening = result.getOpenings()[i];
      const auto& same = expected.getOpenings()[i];
      EXPECT_LT((opening.position * unit - same.position).norm(), 0.15);
      EXPECT_NEAR(opening.width, same.width, 0.05);
    }
  }
}

TEST_F(QuietInput, NoUnitMakesPointsThatAreNotFinite)
{
  for (const double metres_per_unit : {1e300, 1e-300, 1e9}) {
    Points points(5,
                  {3e38f, -3e38f, 1e20f}); // most of them, so that they are the middle
    points.emplace_back(-3e38f, 0, 1e-42f);
    points.emplace_back(1, 2, 3);
    const auto frame = pcl::indoor::moveIntoBuildingFrame(
        points, Eigen::Vector3f::UnitZ(), metres_per_unit);
    EXPECT_TRUE(frame.pose.matrix().allFinite()) << metres_per_unit;
    for (const auto& point : points)
      EXPECT_TRUE(pcl::indoor::isUsable(point)) << metres_per_unit << ": " << point;
  }
}

TEST_F(QuietInput, AUnitThatIsNotSetIsFoundAndSaidOnce)
{
  const auto points = bentCorridorWithThreeRooms().points;
  Labels expected;
  segmentation(points, expected);
  const std::pair<double, const char*> units[] = {{0.001, "millimetres"},
                                                  {0.0254, "inches"}};
  for (const auto& [unit, name] : units) {
    Labels labels;
    RoomSegmentationXYZ result;
    result.setInputCloud(cloudOf(scaled(points, 1.0 / unit)));
    result.segment(labels);
    const auto& report = result.getReport();
    EXPECT_EQ(report.metres_per_unit, unit);
    ASSERT_EQ(report.warnings.size(), 1u) << name;
    EXPECT_NE(report.warnings[0].find(name), std::string::npos) << report.warnings[0];
    EXPECT_LT(differing(labels, expected), points.size() / 1000);
  }
}

TEST_F(QuietInput, AUnitThatIsSetHoldsAndIsWarnedOfOnce)
{
  Labels labels;
  const auto points = scaled(bentCorridorWithThreeRooms().points, 1000.0);
  const auto report = segmentation(points, labels, 1.0).getReport();
  EXPECT_EQ(report.metres_per_unit, 1.0);
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_NE(report.warnings[0].find("-unit mm"), std::string::npos);
}

TEST_F(QuietInput, AScanOnItsSideIsStoodUprightAndSaidOnce)
{
  const auto points = bentCorridorWithThreeRooms().points;
  Labels expected;
  segmentation(points, expected);
  Points lying;
  for (const auto& point : points)
    lying.emplace_back(point.x(), point.z(), -point.y());
  Labels labels;
  const auto report = segmentation(lying, labels).getReport();
  EXPECT_EQ(report.up_axis, Eigen::Vector3f::UnitY());
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_NE(report.warnings[0].find("-up y"), std::string::npos);
  EXPECT_LT(differing(labels, expected), points.size() / 100);
}

TEST_F(QuietInput, AnEmptyBuildingUpsideDownIsTurnedByItsDoorsAndSaidOnce)
{
  const auto points = bentCorridorWithThreeRooms().points;
  Labels expected, labels, as_set;
  const auto upright = segmentation(points, expected);
  const auto hanging = upsideDown(points);
  const auto turned = segmentation(hanging, labels);
  EXPECT_EQ(turned.getReport().up_axis, -Eigen::Vector3f::UnitZ());
  ASSERT_EQ(turned.getReport().warnings.size(), 1u);
  EXPECT_NE(turned.getReport().warnings[0].find("upside down"), std::string::npos);
  EXPECT_NE(turned.getReport().warnings[0].find("3 of 3 passages"), std::string::npos);
  EXPECT_LT(differing(labels, expected), points.size() / 1000);
  ASSERT_EQ(turned.getRooms().size(), upright.getRooms().size());
  for (std::size_t i = 0; i < turned.getRooms().size(); ++i) {
    const Eigen::Vector3d at = upright.getRooms()[i].centroid;
    EXPECT_LT(
        (turned.getRooms()[i].centroid - Eigen::Vector3d(at.x(), -at.y(), -at.z()))
            .norm(),
        0.01);
  }

  RoomSegmentationXYZ set; // is never overruled
  set.setInputCloud(cloudOf(hanging));
  set.setUpAxis(Eigen::Vector3f::UnitZ());
  set.segment(as_set);
  EXPECT_EQ(set.getReport().up_axis, Eigen::Vector3f::UnitZ());
  ASSERT_EQ(set.getReport().warnings.size(), 1u);
  EXPECT_NE(set.getReport().warnings[0].find("may be upside down"), std::string::npos);
}

TEST_F(QuietInput, WhereNothingTellsWhichEndIsUpTheFinderIsAsked)
{
  const auto points = emptyRoom({0.0f, 0.0f, 0.0f});
  for (const int end : {1, 0, -1}) {
    std::size_t asked = 0;
    RoomSegmentationXYZ rooms;
    rooms.setInputCloud(cloudOf(points));
    rooms.setEndFinder([&](const Points& upright) {
      asked += upright.size() == points.size();
      return end;
    });
    Labels labels;
    rooms.segment(labels);
    EXPECT_EQ(asked, 1u);
    EXPECT_EQ(roomCount(labels), 1u) << end;
    const auto& report = rooms.getReport();
    const float up = end < 0 ? -1.0f : 1.0f;
    EXPECT_EQ(report.up_axis, up * Eigen::Vector3f::UnitZ());
    EXPECT_EQ(rooms.getBuildingFrame().pose.linear()(2, 2), up);
    EXPECT_EQ(report.end_is_recognised, end != 0);
    const auto said = report.warnings.empty() ? std::string() : report.warnings[0];
    EXPECT_EQ(report.warnings.size(), end > 0 ? 0u : 1u);
    EXPECT_EQ(said.find("The scan is upside down") == 0, end < 0) << said;
    EXPECT_EQ(said.find("Neither furniture nor passages tell") == 0, end == 0) << said;
  }
}

TEST_F(QuietInput, TheFinderIsNotAskedWherePassagesOrTheUserTell)
{
  Labels labels;
  const auto never = [](const Points&) -> int {
    ADD_FAILURE() << "asked";
    return 0;
  };
  RoomSegmentationXYZ set;
  set.setInputCloud(cloudOf(emptyRoom({0.0f, 0.0f, 0.0f})));
  set.setUpAxis(Eigen::Vector3f::UnitZ());
  set.setEndFinder(never);
  set.segment(labels);
  RoomSegmentationXYZ with_doors;
  with_doors.setEndFinder(never);
  with_doors.setInputCloud(cloudOf(bentCorridorWithThreeRooms().points));
  with_doors.segment(labels);
  RoomSegmentationXYZ stopped;
  stopped.setEndFinder(never);
  stopped.setInputCloud(cloudOf(emptyRoom({0.0f, 0.0f, 0.0f})));
  stopped.setProgressCallback([](double share, const char*) { return share < 0.1; });
  stopped.segment(labels);
}

TEST_F(QuietInput, TurningAScanGoesOnWithItsProgressAndCanBeStopped)
{
  RoomSegmentationXYZ rooms;
  rooms.setInputCloud(cloudOf(upsideDown(bentCorridorWithThreeRooms().points)));
  std::vector<double> shares;
  std::size_t most = 1000;
  rooms.setProgressCallback([&](double share, const char*) {
    shares.push_back(share);
    return shares.size() < most;
  });
  Labels labels;
  rooms.segment(labels);
  EXPECT_EQ(roomCount(labels), 4u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(std::count(shares.begin(), shares.end(), 0.0), 1);
  EXPECT_EQ(std::count(shares.begin(), shares.end(), 1.0), 1);
  most = shares.size() - 1; // the last stage of the second search
  shares.clear();
  rooms.segment(labels);
  EXPECT_EQ(shares.size(), most);
  EXPECT_TRUE(labels.empty());
  EXPECT_TRUE(rooms.getBuilding().maps.empty());
}

TEST_F(QuietInput, CoordinatesThatWereFoundBeforeAreTakenUntilAnotherIsSet)
{
  pcl::indoor::ScanCoordinates found;
  found.up_axis = Eigen::Vector3f::UnitX();
  found.metres_per_unit = 0.5;
  RoomSegmentationXYZ rooms;
  rooms.setInputCloud(cloudOf(twoRooms().points));
  rooms.setCoordinates(found);
  Labels labels;
  rooms.segment(labels);
  EXPECT_EQ(rooms.getReport().up_axis, found.up_axis);
  EXPECT_EQ(rooms.getReport().metres_per_unit, 0.5);
  rooms.setUpAxis(Eigen::Vector3f::UnitZ());
  rooms.segment(labels);
  EXPECT_EQ(rooms.getReport().up_axis, Eigen::Vector3f::UnitZ());
  EXPECT_EQ(rooms.getReport().metres_per_unit, 1.0);
}

TEST_F(QuietInput, FarPointsChangeNothingAndGetNoRoom)
{
  const auto points = twoRooms().points;
  Labels expected;
  segmentation(points, expected);
  constexpr float most = std::numeric_limits<float>::max();
  for (const float far : {5e3f, 1e7f, -1e20f, most, -most})
    for (const int count : {1, 10}) {
      auto with = points;
      for (int i = 0; i < count; ++i) {
        Eigen::Vector3f point(1, 1, 1);
        point[i % 3] = far;
        with.insert(with.begin() + 7 * i, point);
      }
      Labels labels;
      const auto result = segmentation(with, labels);
      EXPECT_TRUE(result.getReport().warnings.empty()) << far;
      ASSERT_EQ(result.getReport().outside.size(), static_cast<std::size_t>(count));
      for (int i = count - 1; i >= 0; --i) {
        EXPECT_EQ(result.getReport().outside[i], 7 * i);
        EXPECT_EQ(labels[7 * i], 0u);
        labels.erase(labels.begin() + 7 * i);
      }
      EXPECT_EQ(labels, expected) << far << ' ' << count;
    }
}

TEST_F(QuietInput, FarPointsDoNotStopTheCore)
{
  auto points = twoRooms().points;
  const auto expected = pcl::indoor::segmentBuilding(points).point_labels;
  for (const float far : {1e7f, 1e20f, std::numeric_limits<float>::max()})
    points.emplace_back(far, -far, far);
  auto labels = pcl::indoor::segmentBuilding(points).point_labels;
  ASSERT_EQ(labels.size(), expected.size() + 3);
  labels.resize(expected.size());
  EXPECT_EQ(labels, expected);
}

TEST_F(QuietInput, TinyNumbersAreOrdinary)
{
  auto points = twoRooms().points;
  points.emplace_back(1e-40f, -1e-42f, 1e-45f);
  Labels labels;
  const auto result = segmentation(points, labels);
  EXPECT_TRUE(result.getReport().outside.empty());
  EXPECT_EQ(roomCount(labels), 2u);
}

TEST_F(QuietInput, PointsWithNothingNearThemAreAllLeftOut)
{
  Labels labels;
  const auto result = segmentation({{1e6f, 0, 0}, {0, 1e6f, 0}, {0, 0, 1e6f}}, labels);
  EXPECT_EQ(labels, (Labels{0, 0, 0}));
}

TEST_F(QuietInput, CoarseCoordinatesAreWarnedOf)
{
  auto points = twoRooms().points;
  for (auto& point : points)
    point.y() += 5.8e6f; // a northing
  Labels labels;
  const auto report = segmentation(points, labels).getReport();
  ASSERT_EQ(report.warnings.size(), 2u);
  EXPECT_NE(report.warnings[1].find("Walls were seen on only"), std::string::npos);
  EXPECT_NE(report.warnings[0].find("steps of 0.5 m"), std::string::npos);
}

TEST_F(QuietInput, SparsePointsHaveTheSameRooms)
{
  Labels labels;
  for (const float spacing : {0.05f, 0.16f, 0.2f, 0.25f}) {
    const auto scene = twoRooms(0.005f, spacing);
    const auto result = segmentation(scene.points, labels);
    EXPECT_EQ(result.getReport().voxel_size, 0.1) << spacing;
    ASSERT_EQ(roomCount(labels), 2u) << spacing;
    EXPECT_NEAR(result.getRooms()[0].area, 12.0, 0.8) << spacing;
    EXPECT_NEAR(result.getRooms()[1].area, 9.0, 1.0) << spacing;
  }
}

TEST_F(QuietInput, VoxelsGrowWherePointsAreTooFarApartToCloseSurfaces)
{
  const auto scene = twoRooms(0.005f, 0.6f);
  Labels labels;
  const double size = segmentation(scene.points, labels).getReport().voxel_size;
  EXPECT_GT(size, 0.1);
  EXPECT_LE(size, 0.4);
}

TEST_F(QuietInput, AVoxelSizeThatIsGivenHolds)
{
  const auto sparse = twoRooms(0.005f, 0.16f);
  Labels labels;
  RoomSegmentationXYZ fixed;
  fixed.setVoxelSize(0.1);
  fixed.setInputCloud(cloudOf(sparse.points));
  fixed.segment(labels);
  EXPECT_EQ(fixed.getReport().voxel_size, 0.1);
  EXPECT_NE(roomCount(labels), 2u); // its surfaces have holes, as asked
}
