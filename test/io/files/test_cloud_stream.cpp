/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_file.h"
#include "files/cloud_stream.h"
#include "formats/pcd/pcd_writer.h"
#include "support/added_field.h"
#include "support/folder_test.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace pcl::indoor::tool;

namespace {

class CloudStreamTest : public pcl::indoor::test::FolderTest {
protected:
  /** The stream gives what loadCloud() gives. */
  void
  expectLikeLoaded(const std::string& path)
  {
    const auto file = loadCloud(path, {}, 1);
    const auto stream = CloudStream::open(path);
    ASSERT_TRUE(stream) << path;
    EXPECT_EQ(stream->layout().width, file.cloud.width);
    EXPECT_EQ(stream->layout().height, file.cloud.height);
    EXPECT_EQ(stream->layout().point_step, file.cloud.point_step);
    ASSERT_EQ(stream->layout().fields.size(), file.cloud.fields.size());
    for (std::size_t i = 0; i < file.cloud.fields.size(); ++i) {
      EXPECT_EQ(stream->layout().fields[i].name, file.cloud.fields[i].name);
      EXPECT_EQ(stream->layout().fields[i].offset, file.cloud.fields[i].offset);
      EXPECT_EQ(stream->layout().fields[i].datatype, file.cloud.fields[i].datatype);
    }
    EXPECT_EQ(stream->pose().origin, file.pose.origin);
    EXPECT_EQ(stream->pose().offset, file.pose.offset);
    EXPECT_TRUE(stream->pose().orientation.isApprox(file.pose.orientation, 0.0f));
    std::vector<std::uint8_t> data;
    std::uint64_t next = 0;
    stream->forEachPart([&](std::uint64_t first, pcl::PCLPointCloud2& part) {
      EXPECT_EQ(first, next);
      next += part.width;
      data.insert(data.end(), part.data.begin(), part.data.end());
    });
    EXPECT_EQ(data, file.cloud.data);
    const auto two = stream->read(1, 2);
    EXPECT_EQ(two.width, 2u);
    EXPECT_EQ(std::memcmp(two.data.data(),
                          file.cloud.data.data() + file.cloud.point_step,
                          2 * file.cloud.point_step),
              0);
  }
};

/** A cloud of count points with a field of whole numbers, and doubles if wanted. */
pcl::PCLPointCloud2
cloudOf(std::uint32_t count, bool doubles)
{
  pcl::PCLPointCloud2 cloud;
  for (const char* name : {"x", "y", "z"})
    pcl::indoor::test::addField(cloud,
                                name,
                                doubles ? pcl::PCLPointField::FLOAT64
                                        : pcl::PCLPointField::FLOAT32);
  pcl::indoor::test::addField(cloud, "label", pcl::PCLPointField::UINT16);
  cloud.width = count;
  cloud.height = 1;
  cloud.data.resize(static_cast<std::size_t>(count) * cloud.point_step);
  for (std::uint32_t i = 0; i < count; ++i) {
    auto* point = &cloud.data[static_cast<std::size_t>(i) * cloud.point_step];
    for (int axis = 0; axis < 3; ++axis) {
      const double value = 5000.0 * axis + 0.25 * (i % 1000);
      const auto real = static_cast<float>(value);
      if (doubles)
        std::memcpy(point + 8 * axis, &value, 8);
      else
        std::memcpy(point + 4 * axis, &real, 4);
    }
    const auto label = static_cast<std::uint16_t>(i);
    std::memcpy(point + cloud.point_step - 2, &label, 2);
  }
  return cloud;
}

} // namespace

TEST_F(CloudStreamTest, ReadsBinaryPcdInParts)
{
  for (const bool doubles : {false, true}) {
    auto cloud = cloudOf(600000, doubles); // three parts
    cloud.width = 1000;
    cloud.height = 600;
    CloudPose pose;
    pose.origin = {1, 2, 3, 0};
    pose.offset = {100, 0, 0};
    OutputFile file(path("cloud.pcd"));
    writePcdHeader(file, cloud, pose);
    auto half = cloud; // written in parts, too
    half.height = 300;
    half.data.resize(cloud.data.size() / 2);
    writePcdPart(file, half);
    half.data.assign(cloud.data.begin() + cloud.data.size() / 2, cloud.data.end());
    writePcdPart(file, half);
    file.commit();
    expectLikeLoaded(path("cloud.pcd"));
  }
}

TEST_F(CloudStreamTest, AViewpointThatIsNoneIsTheOrigin)
{
  expectLikeLoaded(write(
      "cloud.pcd",
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT "
      "1\nVIEWPOINT -inf 2 3 1 0 0 0\nPOINTS 3\nDATA binary\n" +
          std::string(36, '\0')));
}

TEST_F(CloudStreamTest, ReadsBinaryPlyInParts)
{
  CloudPose pose;
  pose.origin = {1, 2, 3, 0};
  saveCloud(path("cloud.ply"), cloudOf(300000, true), pose);
  expectLikeLoaded(path("cloud.ply"));
}

TEST_F(CloudStreamTest, LeavesOtherEncodingsAndDamagedFilesToTheLoader)
{
  const std::string header = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n"
                             "COUNT 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ";
  EXPECT_FALSE(CloudStream::open(write("ascii.pcd", header + "ascii\n1 2 3\n4 5 6\n")));
  const std::string points(24, '\0');
  EXPECT_TRUE(CloudStream::open(write("binary.pcd", header + "binary\n" + points)));
  EXPECT_FALSE(
      CloudStream::open(write("cut.pcd", header + "binary\n" + points.substr(1))));
  EXPECT_FALSE(CloudStream::open(write("none.pcd", "nothing")));
  EXPECT_FALSE(CloudStream::open(write("empty.pcd", "")));
  EXPECT_FALSE(CloudStream::open(path("missing.pcd")));
  auto other = header;
  other.replace(other.find("x y z"), 5, "a y z");
  EXPECT_FALSE(CloudStream::open(write("no_x.pcd", other + "binary\n" + points)));
  EXPECT_FALSE(CloudStream::open(
      write("ascii.ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
            "y\nproperty float z\nend_header\n1 2 3\n")));
  const auto with = [&](const std::string& line, const std::string& other_line) {
    auto text = header + "binary\n" + points;
    return write("changed.pcd", text.replace(text.find(line), line.size(), other_line));
  };
  EXPECT_TRUE(CloudStream::open(with("COUNT 1 1 1\n", "")));
  EXPECT_FALSE(CloudStream::open(with("COUNT 1 1 1", "COUNT -1 1 1")));
  EXPECT_FALSE(CloudStream::open(with("COUNT 1 1 1", "COUNT 1 1")));
  EXPECT_FALSE(CloudStream::open(with("TYPE F F F", "TYPE F F A")));
  EXPECT_FALSE(CloudStream::open(with("HEIGHT 1", "HEIGHT 2")));
  saveCloud(path("packed.pcd"), cloudOf(5000, false)); // compressed
  EXPECT_FALSE(CloudStream::open(path("packed.pcd")));
}

TEST_F(CloudStreamTest, AFileThatShrinksIsSaid)
{
  const std::string header = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n"
                             "COUNT 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA binary\n";
  const auto file = write("cloud.pcd", header + std::string(24, '\0'));
  const auto stream = CloudStream::open(file);
  ASSERT_TRUE(stream);
  write("cloud.pcd", header);
  EXPECT_THROW(stream->read(0, 2), ToolError);
}
