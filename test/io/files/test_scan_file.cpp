/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/io/scan_file.h>

#include "files/cloud_writer.h"
#include "support/folder_test.h"

#include <pcl/conversions.h>

#include <gtest/gtest.h>

#include <string>

using namespace pcl;
using namespace pcl::indoor;

namespace {

class ScanFile : public indoor::test::FolderTest {
protected:
  /** A file of so many points, far from the origin. */
  std::string
  file(const std::string& name, int count) const
  {
    PointCloud<PointXYZ> cloud;
    for (int i = 0; i < count; ++i)
      cloud.emplace_back(5000.0f + static_cast<float>(i), 1.0f, 2.0f);
    PCLPointCloud2 bytes;
    toPCLPointCloud2(cloud, bytes);
    tool::saveCloud(path(name), bytes);
    return path(name);
  }
};

} // namespace

TEST_F(ScanFile, GivesPointsNearTheOriginAndWhatToAdd)
{
  const auto scan = loadScan(file("a.pcd", 5));
  EXPECT_EQ(scan.name(), path("a.pcd"));
  EXPECT_EQ(scan.pointCount(), 5u);
  EXPECT_FALSE(scan.isReadInParts());
  ASSERT_EQ(scan.points()->size(), 5u);
  EXPECT_EQ(scan.offset().x(), 5002.0); // the median
  EXPECT_EQ((*scan.points())[4].x + scan.offset().x(), 5004.0);
  EXPECT_EQ(scan.cloud().fields.size(), 3u);
}

TEST_F(ScanFile, StaysInItsFileIfItIsLarge)
{
  ScanOptions options;
  options.points_at_once = 4;
  const auto scan = loadScan(file("a.ply", 5), options);
  EXPECT_TRUE(scan.isReadInParts());
  EXPECT_EQ(scan.pointCount(), 5u);
  EXPECT_EQ(scan.points(), nullptr);
  options.points_at_once = 5;
  EXPECT_FALSE(loadScan(file("a.ply", 5), options).isReadInParts());
  options.points_at_once = 0;
  EXPECT_FALSE(loadScan(file("a.ply", 5), options).isReadInParts());
}

TEST_F(ScanFile, OfSeveralFilesIsOneOfStations)
{
  const auto scan = loadScan({file("a.pcd", 5), file("b.pcd", 3)});
  EXPECT_EQ(scan.pointCount(), 8u);
  ASSERT_EQ(scan.stations().size(), 2u);
  EXPECT_EQ(scan.stations()[1].name, "b.pcd");
}

TEST_F(ScanFile, TakesTheColumnsOfATable)
{
  write("a.xyz", "1 2 3 9\n4 5 6 9\n7 8 9 9\n");
  ScanOptions options;
  options.columns = "_,x,y,z";
  const auto scan = loadScan(path("a.xyz"), options);
  EXPECT_EQ((*scan.points())[0].x, 2.0f);
  EXPECT_EQ((*scan.points())[0].z, 9.0f);
}

TEST_F(ScanFile, ThatIsNoneIsRefusedByName)
{
  for (const auto& name : {path("none.pcd"), write("b.pcd", "no cloud")})
    try {
      loadScan(name);
      FAIL() << name;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find(name), 0u) << error.what();
    }
}
