/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_writer.h"

#include "files/cloud_file.h"
#include "support/added_field.h"
#include "support/folder_test.h"

#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <gtest/gtest.h>

#include <cstring>
#include <random>

using namespace pcl::indoor::tool;
using pcl::indoor::test::bytesOf;

namespace {

using pcl::indoor::test::addField;

class CloudWriter : public pcl::indoor::test::FolderTest {};

/** Six points in two rows, with every type of numbers that PLY has and padding. */
pcl::PCLPointCloud2
manyFields()
{
  using Field = pcl::PCLPointField;
  pcl::PCLPointCloud2 cloud;
  for (const char* name : {"x", "y", "z"})
    addField(cloud, name, Field::FLOAT32);
  addField(cloud, "_", Field::UINT8, 4);
  addField(cloud, "rgb", Field::FLOAT32);
  addField(cloud, "normal_x", Field::FLOAT32);
  addField(cloud, "a", Field::INT8);
  addField(cloud, "b", Field::UINT8);
  addField(cloud, "c", Field::INT16);
  addField(cloud, "d", Field::UINT16);
  addField(cloud, "e", Field::INT32);
  addField(cloud, "label", Field::UINT32);
  addField(cloud, "gps_time", Field::FLOAT64);
  cloud.width = 3;
  cloud.height = 2;
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.resize(6 * cloud.point_step);
  for (std::size_t i = 0; i < cloud.data.size(); ++i)
    cloud.data[i] = static_cast<std::uint8_t>(i * 37 % 61); // no number is NaN
  for (std::size_t i = 0; i < 6; ++i) {
    cloud.data[i * cloud.point_step + 19] = 0; // colours have three bytes
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float value = 0.1f * static_cast<float>(i) + static_cast<float>(axis);
      std::memcpy(&cloud.data[i * cloud.point_step + 4 * axis], &value, sizeof(value));
    }
  }
  return cloud;
}

std::vector<std::uint8_t>
valuesOf(const pcl::PCLPointCloud2& cloud, const pcl::PCLPointField& field)
{
  std::vector<std::uint8_t> values;
  const auto size =
      static_cast<std::size_t>(pcl::getFieldSize(field.datatype)) * field.count;
  for (std::size_t i = 0; i < cloud.width * cloud.height; ++i) {
    const auto* first = &cloud.data[i * cloud.point_step + field.offset];
    values.insert(values.end(), first, first + size);
  }
  return values;
}

void
expectSameFields(const pcl::PCLPointCloud2& expected, const pcl::PCLPointCloud2& cloud)
{
  EXPECT_EQ(cloud.width, expected.width);
  EXPECT_EQ(cloud.height, expected.height);
  for (const auto& field : expected.fields) {
    const int index = pcl::getFieldIndex(cloud, field.name);
    if (field.name == "_")
      continue;
    ASSERT_GE(index, 0) << field.name;
    EXPECT_EQ(cloud.fields[index].datatype, field.datatype) << field.name;
    EXPECT_EQ(valuesOf(cloud, cloud.fields[index]), valuesOf(expected, field))
        << field.name;
  }
}

CloudPose
somePose()
{
  CloudPose pose;
  pose.origin = Eigen::Vector4f(0.1f, -2, 3e-5f, 0);
  pose.orientation = Eigen::Quaternionf(0.5f, -0.5f, 0.5f, 0.5f);
  pose.offset = Eigen::Vector3d(691234, 5334567.25, 0);
  return pose;
}

} // namespace

TEST_F(CloudWriter, EveryFieldComesBackFromBothFormats)
{
  const auto cloud = manyFields();
  for (const char* name : {"out.pcd", "out.ply", "OUT.PLY", "without_extension"}) {
    SCOPED_TRACE(name);
    saveCloud(path(name), cloud, somePose());
    const auto file = loadCloud(path(name));
    expectSameFields(cloud, file.cloud);
    EXPECT_EQ(file.pose.origin.head<3>(), somePose().origin.head<3>());
    EXPECT_LT(file.pose.orientation.angularDistance(somePose().orientation), 1e-3f);
    EXPECT_EQ(file.pose.offset, somePose().offset);
    EXPECT_EQ(file.offset, somePose().offset);
  }
  EXPECT_EQ(bytesOf(path("OUT.PLY")).substr(0, 4), "ply\n");
  EXPECT_EQ(bytesOf(path("without_extension")).substr(0, 6), "# .PCD");
}

TEST_F(CloudWriter, PclsReadersUnderstandBothFormats)
{
  const auto cloud = manyFields();
  saveCloud(path("out.pcd"), cloud, somePose());
  saveCloud(path("out.ply"), cloud, somePose());
  pcl::PCLPointCloud2 pcd, ply;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0;
  ASSERT_EQ(pcl::PCDReader().read(path("out.pcd"), pcd, origin, orientation, version),
            0);
  EXPECT_TRUE(orientation.isApprox(somePose().orientation));
  expectSameFields(cloud, pcd);
  ASSERT_EQ(pcl::PLYReader().read(path("out.ply"), ply, origin, orientation, version),
            0);
  pcl::PointCloud<pcl::PointXYZRGBL> expected, found;
  pcl::fromPCLPointCloud2(cloud, expected);
  pcl::fromPCLPointCloud2(ply, found);
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_EQ(found.height, 2u);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].getVector3fMap(), expected[i].getVector3fMap());
    EXPECT_EQ(found[i].getRGBVector3i(), expected[i].getRGBVector3i());
    EXPECT_EQ(found[i].label, expected[i].label);
  }
}

TEST_F(CloudWriter, ManyBlocksAreOneToOtherReaders)
{
  auto cloud = manyFields();
  const auto few = cloud.data;
  cloud.width = 200000; // several blocks of half a MiB per field
  cloud.height = 1;
  cloud.data.resize(cloud.width * cloud.point_step);
  for (std::size_t i = 0; i < cloud.data.size(); ++i)
    cloud.data[i] = static_cast<std::uint8_t>(few[i % few.size()] + i / 1000000);
  for (const int threads : {1, 3}) {
    cloudBeside(path("out.pcd"), cloud, {}, threads).commit();
    const auto bytes = bytesOf(path("out.pcd"));
    EXPECT_NE(bytes.find("\nDATA binary_compressed\n"), std::string::npos);
    pcl::PCLPointCloud2 again;
    ASSERT_EQ(pcl::PCDReader().read(path("out.pcd"), again), 0);
    expectSameFields(cloud, again);
    saveCloud(path("one.pcd"), cloud);
    EXPECT_TRUE(bytes == bytesOf(path("one.pcd")));
  }
}

TEST_F(CloudWriter, BytesThatDoNotShrinkAreWrittenAsTheyAre)
{
  std::mt19937 random(1);
  auto cloud = manyFields();
  cloud.width = 20000; // more than a block
  cloud.height = 1;
  const auto one = cloud.data;
  cloud.data.resize(cloud.width * cloud.point_step);
  for (auto& byte : cloud.data)
    byte = static_cast<std::uint8_t>(random());
  for (std::size_t i = 0; i < cloud.width; ++i)
    std::memcpy(&cloud.data[i * cloud.point_step], one.data(), 12); // x, y, z
  cloud.fields.erase(cloud.fields.begin()); // points without x do not shrink
  cloud.fields.erase(cloud.fields.begin());
  cloud.fields.erase(cloud.fields.begin());
  saveCloud(path("out.pcd"), cloud);
  EXPECT_NE(bytesOf(path("out.pcd")).find("\nDATA binary\n"), std::string::npos);
  pcl::PCLPointCloud2 again;
  ASSERT_EQ(pcl::PCDReader().read(path("out.pcd"), again), 0);
  expectSameFields(cloud, again);
}

TEST_F(CloudWriter, ListsAreKept)
{
  auto cloud = manyFields();
  cloud.fields[11].count = 3; // b, c, d and e are beside it
  cloud.fields[11].name = "histogram";
  cloud.fields[11].datatype = pcl::PCLPointField::UINT8;
  saveCloud(path("out.ply"), cloud);
  EXPECT_NE(bytesOf(path("out.ply")).find("property list uint uchar histogram\n"),
            std::string::npos);
  const auto file = loadCloud(path("out.ply")); // which leaves lists out
  EXPECT_EQ(file.points->size(), 6u);
  EXPECT_TRUE(hasField(file.cloud, "gps_time"));
  saveCloud(path("out.pcd"), cloud);
  expectSameFields(cloud, loadCloud(path("out.pcd")).cloud);
}

TEST_F(CloudWriter, WhatAFormatLacksIsRefused)
{
  for (const char* name : {"out.las", "out.ply.gz", "out.txt", "out."}) {
    try {
      requireWritableCloud(path(name));
      ADD_FAILURE() << name;
    } catch (const ToolError& error) {
      EXPECT_NE(std::string(error.what()).find("neither .pcd nor .ply"),
                std::string::npos)
          << error.what();
    }
  }
  for (const char* name : {"out", "out.pcd", "out.ply", "out.PCD"})
    EXPECT_NO_THROW(requireWritableCloud(path(name)));
  EXPECT_THROW(requireWritableCloud(path("out.ply"), true), ToolError);
  auto cloud = manyFields();
  addField(cloud, "time", pcl::PCLPointField::UINT64);
  cloud.data.resize(6 * cloud.point_step, 1);
  EXPECT_THROW(saveCloud(path("out.ply"), cloud), ToolError);
  saveCloud(path("out.pcd"), cloud);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("")), {}), 1);
}
