/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_file.h"

#include "support/folder_test.h"

#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

using namespace pcl::indoor::tool;

namespace {

class CloudFiles : public pcl::indoor::test::FolderTest {};

pcl::PointCloud<pcl::PointXYZINormal>
organisedCloud()
{
  pcl::PointCloud<pcl::PointXYZINormal> cloud(6, 4);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud[i].getVector3fMap() = Eigen::Vector3f(0.1f * i, 0.2f * i, -0.3f * i - 1.0f);
    cloud[i].getNormalVector3fMap() = Eigen::Vector3f::UnitY();
    cloud[i].intensity = 100.0f + i;
    cloud[i].curvature = 0.01f;
  }
  cloud[5].x = std::numeric_limits<float>::quiet_NaN();
  cloud.is_dense = false;
  cloud.sensor_origin_ = Eigen::Vector4f(1, 2, 3, 0);
  cloud.sensor_orientation_ = Eigen::Quaternionf(0.5f, 0.5f, 0.5f, 0.5f);
  return cloud;
}

std::string
utmPcd()
{
  return "VERSION .7\nFIELDS x y z label\nSIZE 8 8 8 1\nTYPE F F F U\nCOUNT 1 1 1 1\n"
         "WIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA ascii\n"
         "691234.1234 5334567.0005 512.25 1\n691235.1236 5334568.0015 513.25 2\n"
         "691236.5 nan 511 255\n";
}

} // namespace

TEST_F(CloudFiles, EveryEncodingGivesTheSameCloud)
{
  const auto cloud = organisedCloud();
  pcl::PCDWriter writer;
  writer.writeASCII(path("ascii.pcd"), cloud);
  writer.writeBinary(path("binary.pcd"), cloud);
  writer.writeBinaryCompressed(path("compressed.pcd"), cloud);
  for (const char* name : {"ascii.pcd", "binary.pcd", "compressed.pcd"}) {
    SCOPED_TRACE(name);
    const auto file = loadCloud(path(name));
    EXPECT_EQ(file.points->width, 6u);
    EXPECT_EQ(file.points->height, 4u);
    EXPECT_EQ(file.finite_count, 23u);
    EXPECT_FALSE(file.points->is_dense);
    EXPECT_TRUE(std::isnan((*file.points)[5].x) && std::isnan((*file.points)[5].z));
    EXPECT_FLOAT_EQ((*file.points)[7].z, -3.1f);
    EXPECT_EQ(file.pose.origin.head<3>(), Eigen::Vector3f(1, 2, 3));
    EXPECT_TRUE(hasField(file.cloud, "intensity"));
    ASSERT_TRUE(file.has_normals);
    const auto normals = readNormals(file);
    EXPECT_EQ((*normals)[3].normal_y, 1.0f);
    EXPECT_EQ((*normals)[3].curvature, 0.01f);
  }
}

TEST_F(CloudFiles, PointsBehindThePromisedOnesAreSaid)
{
  pcl::PCDWriter().writeBinary(path("more.pcd"), organisedCloud());
  EXPECT_TRUE(loadCloud(path("more.pcd")).notes.empty());
  const auto add = [&](std::size_t bytes) {
    std::ofstream(path("more.pcd"), std::ios::binary | std::ios::app)
        << std::string(bytes, '\x3e');
  };
  constexpr std::size_t point = 8 * sizeof(float);
  add(point - 1);
  EXPECT_TRUE(loadCloud(path("more.pcd")).notes.empty()) << "less than a point";
  add(point + 1);
  const auto file = loadCloud(path("more.pcd"));
  EXPECT_EQ(file.points->size(), 24u);
  EXPECT_EQ(file.notes,
            std::vector<std::string>({"the header promises 24 points, the file holds "
                                      "26: those behind the promised ones are left "
                                      "out"}));
}

TEST_F(CloudFiles, PlyIsReadWithItsDoubles)
{
  const auto file = loadCloud(write(
      "cloud.ply",
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\n"
      "property double y\nproperty double z\nproperty float scalar_Intensity\n"
      "end_header\n691234.1234 5334567.0005 1 0.5\n691234.1235 5334567.0006 2 0.6\n"));
  EXPECT_EQ(file.finite_count, 2u);
  EXPECT_TRUE(hasField(file.cloud, "scalar_Intensity"));
  EXPECT_NEAR((*file.points)[1].x - (*file.points)[0].x, 1e-4, 1e-6); // float near 0
}

TEST_F(CloudFiles, PlyNumbersTooLargeForADoubleAreNotZero)
{
  const auto with = [this](const std::string& type, const std::string& word) {
    return write("far.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty " + type +
                     " x\nproperty float y\nproperty float z\nproperty int n\n"
                     "end_header\n1 2 3 4\n5 2 3 4\n" +
                     word + " 2 3 4\n");
  };
  for (const char* type : {"float", "double"}) {
    EXPECT_EQ(loadCloud(with(type, "1e400")).finite_count, 2u);
    EXPECT_EQ(loadCloud(with(type, "1e-400")).finite_count, 3u);
  }
}

TEST_F(CloudFiles, ABodyThatLooksLikeAHeaderIsReadAsPoints)
{
  const std::string header = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n"
                             "COUNT 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA binary\n";
  // PCL would take these lines for more of the header, and gigabytes for the second
  for (const std::string body :
       {"HEIGHT 1\nPOINTS 2 2\nDATA b", "POINTS 2147483647  \nDATA b"}) {
    const auto cloud = loadCloud(write("two.pcd", header + body)).cloud;
    EXPECT_EQ(std::string(cloud.data.begin(), cloud.data.end()), body.substr(0, 24));
  }
}

TEST_F(CloudFiles, PointsWithoutPropertiesAreRefusedBeforeTheyAreCounted)
{
  const auto ply = write(
      "bare.ply", "ply\nformat ascii 1.0\nelement vertex 2147483647\nend_header\n");
  try {
    loadCloud(ply);
    FAIL();
  } catch (const ToolError& error) {
    EXPECT_EQ(error.what(), ply + ": the points have no properties");
  }
}

TEST_F(CloudFiles, PlyOfPclsWriterIsReadInEveryEncoding)
{
  auto cloud = organisedCloud();
  pcl::PLYWriter writer;
  writer.write(path("ascii.ply"), cloud, false, true);
  writer.write(path("binary.ply"), cloud, true, true);
  for (const char* name : {"ascii.ply", "binary.ply"}) {
    SCOPED_TRACE(name);
    const auto file = loadCloud(path(name));
    ASSERT_EQ(file.points->size(), 24u);
    EXPECT_EQ(file.finite_count, 23u);
    EXPECT_FLOAT_EQ((*file.points)[7].z, -3.1f);
    ASSERT_TRUE(file.has_normals);
    EXPECT_EQ((*readNormals(file))[3].normal_y, 1.0f);
    EXPECT_EQ(file.pose.origin.head<3>(), Eigen::Vector3f(1, 2, 3));
    EXPECT_TRUE(file.pose.orientation.isApprox(cloud.sensor_orientation_, 1e-3f));
  }
}

TEST_F(CloudFiles, PlyListsOtherElementsAndBigEndianAreUnderstood)
{
  std::string text = "ply\nformat binary_big_endian 1.0\nelement tag 1\n"
                     "property list uchar ushort numbers\nelement vertex 2\n"
                     "property uchar red\nproperty float x\nproperty float y\n"
                     "property list uchar uchar names\nproperty float z\n"
                     "property uchar green\nproperty uchar blue\nend_header\n";
  const std::string one("\x3f\x80\0\0", 4), two("\x40\0\0\0", 4);
  text += std::string("\x02\0\x01\0\x02", 5);
  text += "\x01" + one + two +
          "\x03"
          "abc" +
          one + "\x02\x03";
  text += "\x04" + two + one + std::string("\0", 1) + two + "\x05\x06";
  const auto file = loadCloud(write("cloud.ply", text));
  ASSERT_EQ(file.points->size(), 2u);
  EXPECT_EQ((*file.points)[0].getVector3fMap(), Eigen::Vector3f(1, 2, 1));
  EXPECT_EQ((*file.points)[1].getVector3fMap(), Eigen::Vector3f(2, 1, 2));
  pcl::PointCloud<pcl::PointXYZRGB> colored;
  pcl::fromPCLPointCloud2(file.cloud, colored);
  EXPECT_EQ(colored[0].getRGBVector3i(), Eigen::Vector3i(1, 2, 3));
  EXPECT_EQ(colored[1].getRGBVector3i(), Eigen::Vector3i(4, 5, 6));
  EXPECT_THROW(loadCloud(write("cut.ply", text.substr(0, text.size() - 1))), ToolError);
}

TEST_F(CloudFiles, LargeCoordinatesKeepTheirMillimetresAndTheirBytes)
{
  auto file = loadCloud(write("utm.pcd", utmPcd()));
  const auto bytes = file.cloud.data;
  EXPECT_EQ(file.finite_count, 2u);
  const Eigen::Vector3d difference =
      ((*file.points)[1].getVector3fMap() - (*file.points)[0].getVector3fMap())
          .cast<double>();
  // floats of about 1 m resolve 0.06 micrometres
  EXPECT_LT((difference - Eigen::Vector3d(1.0002, 1.001, 1.0)).norm(), 1e-6);
  EXPECT_NEAR((*file.points)[0].x + file.offset.x(), 691234.1234, 1e-6);
  EXPECT_EQ(file.offset.z(), 0.0); // a small coordinate stays as it is

  appendField(file.cloud, "room", {4, 5, 0});
  saveCloud(path("out.pcd"), file.cloud, file.pose);
  const auto again = loadCloud(path("out.pcd"));
  ASSERT_EQ(again.cloud.point_step, 29u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_TRUE(
        std::equal(&bytes[25 * i], &bytes[25 * i] + 25, &again.cloud.data[29 * i]));
  EXPECT_EQ(readLabels(again, "room"), (std::vector<std::uint32_t>{4, 5, 0}));
  EXPECT_EQ(readLabels(again, "label"), (std::vector<std::uint32_t>{1, 2, 255}));
}

TEST_F(CloudFiles, AnAppendedFieldReplacesItsNamesakeOfAnyType)
{
  pcl::io::savePCDFileBinary(path("in.pcd"), organisedCloud());
  auto file = loadCloud(path("in.pcd"));
  std::vector<std::uint32_t> values(24);
  for (std::uint32_t i = 0; i < 24; ++i)
    values[i] = i * 200000000u % 4000000001u;
  appendField(file.cloud, "intensity", values);
  appendField(file.cloud, "object", values);
  values[3] = 12;
  appendField(file.cloud, "object", values);
  saveCloud(path("out.pcd"), file.cloud, file.pose);
  const auto again = loadCloud(path("out.pcd"));
  EXPECT_EQ(readLabels(again, "object"), values);
  EXPECT_EQ(again.cloud.fields.size(), file.cloud.fields.size());
  EXPECT_EQ(again.points->width, 6u);
  EXPECT_TRUE(again.pose.orientation.isApprox(organisedCloud().sensor_orientation_));
  pcl::PointCloud<pcl::PointNormal> points;
  pcl::fromPCLPointCloud2(again.cloud, points);
  EXPECT_FLOAT_EQ(points[7].z, -3.1f);
  EXPECT_FLOAT_EQ(points[7].normal_y, 1.0f);
  EXPECT_THROW(appendField(file.cloud, "object", {1, 2}), ToolError);
}

TEST_F(CloudFiles, WithoutCoordinatesTheFieldsAreNamed)
{
  const auto file = write(
      "in.pcd",
      "VERSION 0.7\nFIELDS position normal\nSIZE 4 4\nTYPE F F\nCOUNT 3 3\nWIDTH 1\n"
      "HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1\nDATA ascii\n1 2 3 0 0 1\n");
  try {
    loadCloud(file);
    FAIL();
  } catch (const ToolError& error) {
    EXPECT_EQ(std::string(error.what()),
              file + ": the file has no floating-point field 'x', its fields are: "
                     "position normal");
  }
}

TEST_F(CloudFiles, PointsWithoutAnyFieldAreRefused)
{
  const auto file =
      write("in.ply",
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty list uchar "
            "int near\nend_header\n1 7\n1 8\n");
  try {
    loadCloud(file);
    FAIL();
  } catch (const ToolError& error) {
    EXPECT_EQ(std::string(error.what()),
              file + ": the file has no floating-point field 'x', nor any other");
  }
}

TEST_F(CloudFiles, LabelsMustBeWholeNumbers)
{
  pcl::io::savePCDFileBinary(path("in.pcd"), organisedCloud());
  const auto file = loadCloud(path("in.pcd"));
  EXPECT_EQ(readLabels(file, "intensity")[3], 103u); // floats, but whole
  EXPECT_THROW(readLabels(file, "curvature"), ToolError);
  EXPECT_THROW(readLabels(file, "x"), ToolError);
  EXPECT_THROW(readLabels(file, "label"), ToolError);
}

TEST_F(CloudFiles, NumbersInAHeaderCannotAskForEverything)
{
  const auto with = [](const std::string& size,
                       const std::string& count,
                       const std::string& points) {
    return "VERSION .7\nFIELDS x y z\nSIZE " + size + "\nTYPE F F F\nCOUNT " + count +
           "\nWIDTH " + points + "\nHEIGHT 1\nPOINTS " + points + "\nDATA binary\n";
  };
  for (const auto& text : {with("4 4 4", "1 1 1", "2000000000"),
                           with("4 4 4", "1 1 1", "-3"),
                           with("4 4 4", "1 1 1", "99999999999999999999"),
                           with("4 4 4", "1 1 2000000000", "3"),
                           with("4 4 3", "1 1 1", "3"),
                           with("4 4", "1 1 1", "3"),
                           with("4 4 4", "1 1", "3"),
                           with("4 4 4", "1 0 1", "3"),
                           with("4 4 4\nPOINTSX 2000000000", "1 1 1", "3") +
                               std::string(36, '\0')}) // which PCL would take
    EXPECT_THROW(loadCloud(write("bad.pcd", text)), ToolError) << text;
}

TEST_F(CloudFiles, AsciiNumbersThatTheirFieldsCannotHoldAreRefused)
{
  const auto with = [this](const std::string& type,
                           const std::string& size,
                           const std::string& word) {
    return write("a.pcd",
                 "VERSION .7\nFIELDS x y z value\nSIZE 4 4 4 " + size +
                     "\nTYPE F F F " + type +
                     "\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n"
                     "1 2 3 " +
                     word + "\n4 5 6 0\n");
  };
  using Words = std::vector<std::array<std::string, 3>>;
  for (const auto& [type, size, word] : Words{{"U", "1", "300"},
                                              {"U", "1", "nan"},
                                              {"I", "1", "200"},
                                              {"U", "2", "65536"},
                                              {"I", "2", "-32769"},
                                              {"U", "4", "-1"},
                                              {"I", "4", "1.7"},
                                              {"I", "4", "1e3"},
                                              {"I", "4", "2147483648"},
                                              {"I", "8", "9223372036854775808"},
                                              {"U", "8", "18446744073709551616"}}) {
    const auto file = with(type, size, word);
    try {
      loadCloud(file);
      ADD_FAILURE() << type << size << " " << word;
    } catch (const ToolError& error) {
      EXPECT_EQ(error.what(),
                file + ": '" + word +
                    "' in point 0 does not fit the type of its field");
    }
  }
  for (const auto& [type, size, word] : Words{{"U", "1", "255"},
                                              {"U", "1", "+7"},
                                              {"I", "1", "-128"},
                                              {"U", "4", "4294967295"},
                                              {"I", "4", "3.000"},
                                              {"U", "8", "18446744073709551615"},
                                              {"F", "4", "1e400"},
                                              {"F", "4", "nan"}})
    EXPECT_EQ(loadCloud(with(type, size, word)).cloud.width, 2u) << word;
}

TEST_F(CloudFiles, CompressedPointsTakeNoMemoryThatTheyCannotFill)
{
  const std::uint32_t sizes[] = {4, 3600000000}; // bytes, compressed and not
  const auto file = write(
      "bad.pcd",
      "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
      "WIDTH 300000000\nHEIGHT 1\nPOINTS 300000000\nDATA binary_compressed\n" +
          std::string(reinterpret_cast<const char*>(sizes), sizeof(sizes)) + "abcd");
  try {
    loadCloud(file);
    FAIL();
  } catch (const ToolError& error) {
    EXPECT_EQ(error.what(),
              file + ": the compressed points are 4 bytes, too few for the 3600000000 "
                     "that are promised");
  }
}

TEST_F(CloudFiles, PointsOfTooManyBytesAreRefused)
{
  // 2^34 bytes of 2^30 points: no number of 64 bits is as large
  constexpr int many = 2147, left = 483648;
  std::string fields = "x y z", sizes = "8 8 8", types = "F F F", counts = "1 1 1";
  for (int i = 0; i <= many; ++i) {
    fields += " f" + std::to_string(i);
    sizes += " 8";
    types += " F";
    counts += i < many ? " 1000000" : " " + std::to_string(left - 3);
  }
  const auto file =
      write("bad.pcd",
            "VERSION .7\nFIELDS " + fields + "\nSIZE " + sizes + "\nTYPE " + types +
                "\nCOUNT " + counts +
                "\nWIDTH 1073741824\nHEIGHT 1\nPOINTS 1073741824\nDATA binary\n");
  try {
    loadCloud(file);
    FAIL();
  } catch (const ToolError& error) {
    EXPECT_EQ(error.what(),
              file + ": a point of the header has 17179869184 bytes, more than "
                     "16777216");
  }
}

// Whatever a file's first bytes are changed to, the reader answers with a cloud or an
// error.
TEST_F(CloudFiles, DamagedHeadersNeverCrash)
{
  std::mt19937 rng(42);
  pcl::io::savePCDFileBinary(path("in.pcd"), organisedCloud());
  const auto good = pcl::indoor::test::bytesOf(path("in.pcd"));
  std::size_t refused = 0;
  pcl::PLYWriter().write(path("in.ply"), organisedCloud(), true, true);
  const auto good_ply = pcl::indoor::test::bytesOf(path("in.ply"));
  const std::string texts[] = {utmPcd(), good, good_ply};
  for (int trial = 0; trial < 600; ++trial) {
    auto text = texts[trial % 3];
    for (int change = 0; change < 3; ++change)
      text[rng() % 200] = "0123456789 \n-.FUIxyz"[rng() % 20];
    try {
      loadCloud(write("bad.pcd", text));
    } catch (const ToolError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100u);
}

TEST_F(CloudFiles, AViewpointThatIsNoneIsTheOrigin)
{
  for (const std::string viewpoint : {"-inf 1 2 1 0 0 0", "1 2 x 1 0 0 0"}) {
    auto text = utmPcd();
    const std::string known = "0 0 0 1 0 0 0";
    text.replace(text.find(known), known.size(), viewpoint);
    const auto pose = loadCloud(write("cloud.pcd", text)).pose;
    EXPECT_EQ(pose.origin, Eigen::Vector4f::Zero().eval()) << viewpoint;
    EXPECT_EQ(pose.orientation.coeffs(), Eigen::Vector4f(0, 0, 0, 1)) << viewpoint;
  }
  auto text = utmPcd();
  text.replace(text.find("0 0 0 1"), 7, "+1 -2 3 1");
  EXPECT_EQ(loadCloud(write("cloud.pcd", text)).pose.origin,
            Eigen::Vector4f(1, -2, 3, 0));
}

TEST_F(CloudFiles, CoordinatesTooLargeToComputeWithAreLeftOut)
{
  const std::string header =
      "VERSION .7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\n"
      "HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA ascii\n";
  const auto file = loadCloud(write("far.pcd", header + "1 2 3\n2 3 4\n1e20 0 0\n"));
  EXPECT_EQ(file.finite_count, 2u);
  EXPECT_FALSE(file.points->is_dense);
  EXPECT_TRUE(std::isnan((*file.points)[2].x));
  EXPECT_THROW(loadCloud(write("all.pcd", header + "1e20 0 0\n-1e20 0 0\n0 1e19 0\n")),
               ToolError);
}

TEST_F(CloudFiles, AFolderIsToldFromAFile)
{
  const auto folder = std::filesystem::path(path("a.pcd")).parent_path().string();
  try {
    loadCloud(folder);
    FAIL();
  } catch (const ToolError& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, folder.size() + 10),
              folder + ": a folder");
  }
}

TEST_F(CloudFiles, OtherFormatsAreNamedWithTheCommandThatConvertsThem)
{
  const auto messageFor = [&](const std::string& name, const std::string& bytes) {
    try {
      loadCloud(write(name, bytes));
    } catch (const ToolError& error) {
      const std::string text = error.what();
      const std::string start =
          path(name) + ": not a PCD, PLY, LAS, E57 or PTX file but ";
      EXPECT_EQ(text.substr(0, start.size()), start);
      return text.substr(std::min(start.size(), text.size()));
    }
    return std::string("it was read");
  };
  const auto ends = [&](const std::string& text, const std::string& end) {
    EXPECT_EQ(text.substr(text.size() - std::min(text.size(), end.size())), end)
        << text;
  };
  ends(messageFor("a.fbx", "Kaydara FBX"), " " + path("a.fbx") + " " + path("a.obj"));
  ends(messageFor("a.ply", "DRACO"),
       " -i " + path("a.ply") + " -o " + path("a.unpacked.ply"));
  ends(messageFor("a IN OUT.x.fbx", "Kaydara FBX"),
       " '" + path("a IN OUT.x.fbx") + "' '" + path("a IN OUT.x.obj") + "'");
  EXPECT_EQ(messageFor("a.rcp", "PK\x03\x04").substr(0, 8), "a ReCap ");
  EXPECT_EQ(messageFor("a.bag", "#ROSBAG V2.0\n\x01\x02").substr(0, 9), "a ROS bag");
  EXPECT_EQ(messageFor("a.usdz", "PK\x03\x04").substr(0, 11), "a USD scene");
  EXPECT_EQ(messageFor("a.dxf", "0\nSECTION\n2\nHEADER\n").substr(0, 9), "a drawing");
  EXPECT_EQ(messageFor("a.bin", "CCB2").substr(0, 23), "a file of CloudCompare;");
  EXPECT_EQ(messageFor("a.FBX", "what is this").substr(0, 12), "an FBX scene");
  EXPECT_EQ(messageFor("b.ply", "version https://git-lfs.github.com/spec/v1\n"),
            "a pointer of Git LFS; fetch the file that it stands for: git lfs pull");
  EXPECT_EQ(messageFor("b.pcd", "<!DOCTYPE html><html>404").substr(0, 11),
            "a web page;");
  EXPECT_EQ(messageFor("a.vtp", "<?xml version=\"1.0\"?>").substr(0, 13),
            "a file of VTK");
  EXPECT_EQ(messageFor("a.xlsx", "PK\x03\x04").substr(0, 13), "a spreadsheet");
  EXPECT_NE(messageFor("a b.csv", std::string("\xff\xfex\0,\0", 6))
                .find("iconv -f UTF-16 -t UTF-8 '" + path("a b.csv") + "' -o '" +
                      path("a b.txt") + "'"),
            std::string::npos);
}
