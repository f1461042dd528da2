/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/building_frame.h>

#include <gtest/gtest.h>

#include <random>

namespace pcl::indoor {
namespace {

Eigen::Vector3d
randomPlace(std::mt19937& rng)
{
  const auto draw = [&rng] {
    return static_cast<double>(rng() % 20000) * 0.01 - 100.0;
  };
  return {draw(), draw(), draw()};
}

/** Of a scan in feet that leans, far from the origin of its file. */
BuildingFrame
someFrame(std::mt19937& rng)
{
  BuildingFrame frame;
  frame.offset = Eigen::Vector3d(691234.0, 5334567.0, 500.0);
  frame.metres_per_unit = 0.3048;
  frame.pose.linear() = turnUpright(randomPlace(rng).cast<float>()).transpose();
  frame.pose.translation() = randomPlace(rng);
  return frame;
}

TEST(BuildingFrame, WaysFromTheBuildingToTheFileAgree)
{
  std::mt19937 rng(5);
  for (int trial = 0; trial < 50; ++trial) {
    const auto frame = someFrame(rng);
    const auto place = randomPlace(rng);
    const auto in_scan = frame.buildingToScan(place);
    const Eigen::Vector3d in_file = frame.buildingToFile() * place;
    EXPECT_LT((frame.scanToBuilding(in_scan) - place).norm(), 1e-9);
    EXPECT_LT((frame.scanToUpright(in_scan) - place - frame.origin()).norm(), 1e-9);
    EXPECT_LT((in_scan + frame.offset - in_file).norm(), 1e-6);
    EXPECT_LT((frame.uprightToFile() * frame.scanToUpright(in_scan) - in_file).norm(),
              1e-6);
    EXPECT_LT((frame.scanToUpright(in_file) - place - frame.originInFile()).norm(),
              1e-6);
  }
}

TEST(BuildingFrame, TheScanIsUprightIfNeitherTurnNorUnitDiffer)
{
  BuildingFrame frame;
  frame.pose.translation() = Eigen::Vector3d(1, 2, 3);
  frame.offset = Eigen::Vector3d(4, 5, 6);
  EXPECT_TRUE(frame.isScanUpright());
  EXPECT_EQ(frame.scanToUpright({1, 2, 3}), Eigen::Vector3d(1, 2, 3));
  frame.metres_per_unit = 0.01;
  EXPECT_FALSE(frame.isScanUpright());
  frame.metres_per_unit = 1.0;
  frame.pose.linear() = turnUpright(Eigen::Vector3f::UnitY()).transpose();
  EXPECT_FALSE(frame.isScanUpright());
}

TEST(BuildingFrame, MovedPointsGoBackToTheScan)
{
  const std::vector<Eigen::Vector3f> scan = {
      {5000, 10, -20}, {5010, 13, -25}, {5004, 11, -30}};
  auto points = scan;
  const auto frame = moveIntoBuildingFrame(points, Eigen::Vector3f::UnitY(), 0.01);
  EXPECT_EQ(frame.metres_per_unit, 0.01);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT(points[i].cwiseAbs().maxCoeff(), 2.0f); // near the origin
    EXPECT_LT((frame.buildingToScan(points[i].cast<double>()) - scan[i].cast<double>())
                  .norm(),
              1e-3); // floats of hundredths of metres, in hundredths
  }
}

} // namespace
} // namespace pcl::indoor
