/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/io/memory_scan.h>

#include <pcl/conversions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

using namespace pcl;
using namespace pcl::indoor;

namespace {

PCLPointCloud2
fivePoints()
{
  PointCloud<PointXYZI> cloud;
  for (int i = 0; i < 5; ++i) {
    PointXYZI point;
    point.x = 5000.0f + static_cast<float>(i);
    point.y = 1.0f;
    point.z = i == 2 ? std::numeric_limits<float>::quiet_NaN() : 2.0f;
    point.intensity = static_cast<float>(i);
    cloud.push_back(point);
  }
  PCLPointCloud2 bytes;
  toPCLPointCloud2(cloud, bytes);
  return bytes;
}

/** What is said of five points with a change. */
std::string
problemOf(const std::function<void(PCLPointCloud2&)>& change)
{
  auto cloud = fivePoints();
  change(cloud);
  try {
    memoryScan(cloud, "lidar");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST(MemoryScan, HasThePointsAndFieldsOfTheCloud)
{
  const auto scan = memoryScan(fivePoints(), "lidar");
  EXPECT_EQ(scan.name(), "lidar");
  EXPECT_EQ(scan.pointCount(), 5u);
  EXPECT_FALSE(scan.isReadInParts());
  EXPECT_EQ((*scan.points())[4].x + scan.offset().x(), 5004.0);
  EXPECT_TRUE(std::isnan((*scan.points())[2].x));
  EXPECT_EQ(scan.cloud().data, fivePoints().data);
  EXPECT_EQ(scan.cloud().fields.size(), 4u);
}

TEST(MemoryScan, RefusesBytesThatDoNotFitTheFields)
{
  EXPECT_EQ(problemOf([](auto&) {}), "");
  EXPECT_EQ(problemOf([](auto& cloud) { cloud.data.pop_back(); }),
            "lidar: 159 bytes are not those of 5 x 1 points of 32 bytes");
  EXPECT_EQ(problemOf([](auto& cloud) { cloud.width = cloud.height = 1u << 31; }),
            "lidar: 160 bytes are not those of 2147483648 x 2147483648 points of 32 "
            "bytes");
  EXPECT_EQ(problemOf([](auto& cloud) { cloud.point_step = 0; }),
            "lidar: the field x ends beyond the 0 bytes of a point");
  EXPECT_EQ(problemOf([](auto& cloud) { cloud.fields[3].offset = 29; }),
            "lidar: the field intensity ends beyond the 32 bytes of a point");
  EXPECT_EQ(problemOf([](auto& cloud) { cloud.fields[3].count = 0xffffffffu; }),
            "lidar: the field intensity ends beyond the 32 bytes of a point");
  EXPECT_EQ(problemOf([](auto& cloud) { cloud.fields[3].datatype = 77; }),
            "lidar: the field intensity has the unknown type 77");
  EXPECT_NE(problemOf([](auto& cloud) { cloud.is_bigendian = true; }), "");
}

TEST(MemoryScan, RefusesWhatIsNoCloudOfPlaces)
{
  EXPECT_NE(problemOf([](auto& cloud) { cloud.fields[0].name = "u"; }), "");
  EXPECT_NE(problemOf([](auto& cloud) {
              cloud.width = 0;
              cloud.data.clear();
            }),
            "");
}
