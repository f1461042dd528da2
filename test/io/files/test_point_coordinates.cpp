/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/point_coordinates.h"

#include "support/folder_test.h"

#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor::tool;
using pcl::indoor::test::bytesOf;

namespace {

constexpr double places[3][3] = {{691234.1234, 5334567.0005, 512.25},
                                 {691235.1236, 5334568.0015, 513.25},
                                 {691236.5, NAN, 511}};

class Coordinates : public pcl::indoor::test::FolderTest {
protected:
  /** Doubles, labels and a time in doubles; a sensor beside the first point. */
  std::string
  utmFile() const
  {
    std::ofstream stream(path("utm.pcd"));
    stream
        << "VERSION .7\nFIELDS label x y z gps_time\nSIZE 1 8 8 8 8\nTYPE U F F F F\n"
           "COUNT 1 1 1 1 1\nWIDTH 3\nHEIGHT 1\nVIEWPOINT 691234 5334567 500 1 0 0 0\n"
           "POINTS 3\nDATA ascii\n1 691234.1234 5334567.0005 512.25 1e9\n"
           "2 691235.1236 5334568.0015 513.25 1000000000.123\n"
           "255 691236.5 nan 511 1.5\n";
    return path("utm.pcd");
  }

  /** What a tool does with the option: reads, writes, and says so or not. */
  CloudFile
  passed(const std::string& input, const std::string& output, bool doubles) const
  {
    auto file = loadCloud(input);
    testing::internal::CaptureStderr();
    PointCoordinates{doubles}.apply(file, output);
    said = testing::internal::GetCapturedStderr();
    saveCloud(output, file.cloud, file.pose);
    return loadCloud(output);
  }

  static Eigen::Vector3d
  placeOf(const CloudFile& file, std::size_t i)
  {
    return (*file.points)[i].getVector3fMap().cast<double>() + file.offset;
  }

  mutable std::string said;
};

void
expectPlaces(const CloudFile& file, double tolerance)
{
  ASSERT_EQ(file.points->size(), 3u);
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(
          (*file.points)[i].data[axis] + file.offset[axis], places[i][axis], tolerance);
  EXPECT_FALSE(std::isfinite((*file.points)[2].x));
  EXPECT_EQ(readLabels(file, "label"), (std::vector<std::uint32_t>{1, 2, 255}));
}

} // namespace

TEST_F(Coordinates, FieldsOfOldConvertersHaveOneValueWithoutSayingSo)
{
  auto file = loadCloud(utmFile());
  const auto bytes = file.cloud.data;
  for (auto& field : file.cloud.fields)
    field.count = 0;
  PointCoordinates{true}.apply(file, "");
  EXPECT_EQ(file.cloud.point_step, 33u);
  EXPECT_EQ(file.cloud.fields[4].offset, 25u);
  ASSERT_EQ(file.cloud.data.size(), bytes.size());
  for (std::size_t i = 0; i < 3; ++i) // all but the coordinates
    for (const std::size_t at : {0, 25, 32})
      EXPECT_EQ(file.cloud.data[33 * i + at], bytes[33 * i + at]);
}

TEST_F(Coordinates, DoublesBecomeFloatsThatPclReadsAndAnOffset)
{
  for (const char* name : {"out.pcd", "out.ply"}) {
    SCOPED_TRACE(name);
    const auto file = passed(utmFile(), path(name), false);
    EXPECT_EQ(
        said,
        "Note: " + path(name) +
            ": x, y, z are floats, to which the offset 691235 5334568 0 has to be "
            "added; -double writes doubles\n");
    expectPlaces(file, 1e-6);
    EXPECT_EQ(file.pose.offset, Eigen::Vector3d(691235, 5334568, 0));
    EXPECT_EQ(file.offset, file.pose.offset);
    EXPECT_EQ(file.pose.origin.head<3>(), Eigen::Vector3f(-1, -1, 500));
    EXPECT_EQ(file.cloud.fields.back().name, "gps_time");
    EXPECT_EQ(file.cloud.fields.back().datatype, pcl::PCLPointField::FLOAT64);
    EXPECT_NE(bytesOf(path(name)).find(" offset 691235 5334568 0\n"),
              std::string::npos);
  }
  pcl::PointCloud<pcl::PointXYZ> cloud; // as pcl_viewer reads it
  ASSERT_EQ(pcl::io::loadPCDFile(path("out.pcd"), cloud), 0);
  EXPECT_NEAR(cloud[1].x, 0.1236f, 1e-6);
  EXPECT_NEAR(cloud[1].y, 0.0015f, 1e-6);
  EXPECT_EQ(cloud[1].z, 513.25f);
}

TEST_F(Coordinates, AChainOfToolsLosesNothing)
{
  passed(utmFile(), path("first.pcd"), false);
  passed(path("first.pcd"), path("second.ply"), false);
  EXPECT_EQ(said, "");
  const auto last = passed(path("second.ply"), path("third.pcd"), false);
  EXPECT_EQ(said, "");
  EXPECT_EQ(bytesOf(path("third.pcd")), bytesOf(path("first.pcd")));
  expectPlaces(last, 1e-6);
}

TEST_F(Coordinates, DoublesAreWrittenIfWanted)
{
  const auto same = passed(utmFile(), path("doubles.pcd"), true);
  EXPECT_EQ(said, "");
  EXPECT_EQ(same.cloud.data, loadCloud(utmFile()).cloud.data);
  EXPECT_EQ(same.pose.offset, Eigen::Vector3d::Zero());
  const auto floats = passed(utmFile(), path("floats.pcd"), false);
  const auto again = passed(path("floats.pcd"), path("again.pcd"), true);
  EXPECT_EQ(again.pose.offset, Eigen::Vector3d::Zero());
  EXPECT_EQ(again.cloud.fields[1].datatype, pcl::PCLPointField::FLOAT64);
  EXPECT_EQ(again.pose.origin.head<3>(), Eigen::Vector3f(691234, 5334567, 500));
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(placeOf(again, i), placeOf(floats, i));
}

TEST_F(Coordinates, FloatsStayAsTheyAre)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.emplace_back(691234.5f, 5334567.0f, 1.0f);
  cloud.emplace_back(691235.5f, 5334568.0f, 2.0f);
  pcl::io::savePCDFileBinary(path("in.pcd"), cloud);
  const auto file = passed(path("in.pcd"), path("out.pcd"), false);
  EXPECT_EQ(said, "");
  EXPECT_EQ(file.cloud.data, loadCloud(path("in.pcd")).cloud.data);
  EXPECT_EQ(file.pose.offset, Eigen::Vector3d::Zero());
}

TEST_F(Coordinates, OtherCommentsAreNoOffset)
{
  passed(utmFile(), path("out.pcd"), false);
  const auto good = bytesOf(path("out.pcd"));
  const std::string line = "# offset 691235 5334568 0\n";
  for (const char* other : {"# offset 691235 5334567\n",
                            "# offset 691235 5334568 0 1\n",
                            "# offset 691235 5334567 nan\n",
                            "# offset 691235 5334568 0m\n",
                            "# an offset 1 2 3\n",
                            "#\n"}) {
    auto text = good;
    std::ofstream(path("other.pcd"), std::ios::binary)
        << text.replace(text.find(line), line.size(), other);
    EXPECT_EQ(loadCloud(path("other.pcd")).offset, Eigen::Vector3d::Zero()) << other;
  }
}
