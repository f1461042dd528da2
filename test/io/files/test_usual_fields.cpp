/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_file.h"
#include "files/cloud_sample.h"
#include "support/folder_test.h"

#include <cmath>
#include <cstring>
#include <limits>

using namespace pcl::indoor::tool;

namespace {

/** A value as a file has its bytes. */
template <typename T>
std::string
bytes(T value)
{
  return std::string(reinterpret_cast<const char*>(&value), sizeof(value));
}

class UsualFieldsTest : public pcl::indoor::test::FolderTest {
protected:
  /** What a cloud in one piece gives; it must be the same in parts. */
  CloudFile
  load(const std::string& name, const std::string& content)
  {
    const auto file = loadCloud(write(name, content), {}, 1);
    if (const auto stream = CloudStream::open(path(name))) {
      ++streams_;
      EXPECT_EQ(stream->notes(), file.notes);
      std::vector<std::uint8_t> data;
      stream->forEachPart([&](std::uint64_t, pcl::PCLPointCloud2& part) {
        EXPECT_EQ(namesOf(part), namesOf(file.cloud));
        data.insert(data.end(), part.data.begin(), part.data.end());
      });
      EXPECT_EQ(data, file.cloud.data);
    }
    return file;
  }

  static std::string
  namesOf(const pcl::PCLPointCloud2& cloud)
  {
    std::string names;
    for (const auto& field : cloud.fields)
      names += (names.empty() ? "" : " ") + field.name;
    return names;
  }

  /** A binary PCD. */
  static std::string
  pcd(const std::string& fields,
      const std::string& sizes,
      const std::string& types,
      const std::string& counts,
      const std::string& points,
      int count)
  {
    return "VERSION 0.7\nFIELDS " + fields + "\nSIZE " + sizes + "\nTYPE " + types +
           "\nCOUNT " + counts + "\nWIDTH " + std::to_string(count) +
           "\nHEIGHT 1\nPOINTS " + std::to_string(count) + "\nDATA binary\n" + points;
  }

  static std::string
  ply(const std::string& format, const std::string& properties, int count)
  {
    return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(count) +
           "\n" + properties + "end_header\n";
  }

  int streams_ = 0; ///< files that could be read in parts
};

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string bytes_of_colors =
    "property uchar red\nproperty uchar green\nproperty uchar blue\n";

std::string
colorOf(const CloudFile& file, std::size_t point)
{
  const auto color = (*readColors(file))[point];
  return std::to_string(color.r) + " " + std::to_string(color.g) + " " +
         std::to_string(color.b);
}

} // namespace

TEST_F(UsualFieldsTest, CapitalsOfPcdAreCoordinatesAndColors)
{
  std::string points;
  for (int i = 0; i < 3; ++i)
    points += bytes(691234.5 + i) + bytes(5334567.25) + bytes(500.0) +
              bytes(std::uint16_t(7)) + bytes(std::uint16_t(200 * 256)) +
              bytes(std::uint16_t(255)) + bytes(std::uint16_t(65535));
  const auto file = load("pdal.pcd",
                         pcd("X Y Z Intensity Red Green Blue",
                             "8 8 8 2 2 2 2",
                             "F F F U U U U",
                             "1 1 1 1 1 1 1",
                             points,
                             3));
  EXPECT_EQ(namesOf(file.cloud), "x y z Intensity Red Green Blue rgb");
  EXPECT_EQ(readNumbers(file, "x")[2], 691236.5);
  EXPECT_EQ(colorOf(file, 0), "200 0 255");
  EXPECT_EQ(readLabels(file, "Red")[1], 200u * 256u);
  EXPECT_EQ(file.notes.size(), 2u);
  EXPECT_EQ(streams_, 1);
}

TEST_F(UsualFieldsTest, WholeCoordinatesAreReadAsDoubles)
{
  const std::string points = bytes(std::int32_t(-1500)) + bytes(std::int32_t(20)) +
                             bytes(std::int32_t(2000000001));
  auto file =
      load("whole.pcd", pcd("x y z", "4 4 4", "I I I", "1 1 1", points + points, 2));
  EXPECT_EQ(readNumbers(file, "z")[1], 2000000001.0);
  EXPECT_EQ(static_cast<double>((*file.points)[0].x) + file.offset.x(), -1500.0);
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_NE(file.notes[0].find("whole numbers"), std::string::npos);
  const std::string longs =
      bytes(std::int64_t(1) << 40) + bytes(std::int64_t(-2)) + bytes(std::int64_t(3));
  file = load("long.pcd", pcd("x y z", "8 8 8", "I I I", "1 1 1", longs, 1));
  EXPECT_EQ(readNumbers(file, "x")[0], std::ldexp(1.0, 40));
  file = load("ascii.ply",
              ply("ascii",
                  "property int x\nproperty int y\nproperty int z\nproperty uchar a\n",
                  2) +
                  "1500 2 3 255\n4 5 -6 7\n");
  EXPECT_EQ(namesOf(file.cloud), "x y z a");
  EXPECT_EQ(readNumbers(file, "z")[1], -6.0);
}

TEST_F(UsualFieldsTest, FieldsOfNoValuesAreLeftOut)
{
  const std::string point =
      bytes(1.0f) + bytes(2.0f) + bytes(3.0f) + "ab" + bytes(std::uint8_t(9)) + "cde";
  const auto file = load("count0.pcd",
                         pcd("x y z _ ring noise _",
                             "4 4 4 1 1 2 1",
                             "F F F U U U U",
                             "1 1 1 2 1 0 3",
                             point + point,
                             2));
  EXPECT_EQ(namesOf(file.cloud), "x y z _ ring _");
  EXPECT_EQ(readLabels(file, "ring")[1], 9u);
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_NE(file.notes[0].find("'noise'"), std::string::npos) << file.notes[0];
  EXPECT_EQ(streams_, 1);
  const auto ascii =
      load("ascii.pcd",
           "VERSION 0.7\nFIELDS x y z a\nSIZE 4 4 4 4\nTYPE F F F F\n"
           "COUNT 1 1 1 0\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3\n");
  EXPECT_EQ((*ascii.points)[0].z, 3.0f);
  try {
    load("bad.pcd", pcd("x y z odd", "4 4 4 3", "F F F U", "1 1 1 1", point, 1));
    FAIL();
  } catch (const ToolError& error) {
    EXPECT_NE(std::string(error.what()).find("'odd'"), std::string::npos);
  }
}

TEST_F(UsualFieldsTest, NamesOfPlyInCapitals)
{
  const auto file =
      load("capitals.ply",
           ply("ascii",
               "property float X\nproperty float Y\nproperty float Z\n"
               "property float NX\nproperty float NY\nproperty float NZ\n",
               1) +
               "1 2 3 0 0 1\n");
  EXPECT_EQ(namesOf(file.cloud), "x y z normal_x normal_y normal_z");
  EXPECT_TRUE(file.has_normals);
  const auto both =
      load("both.ply", ply("ascii", xyz + "property float X\n", 1) + "1 2 3 4\n");
  EXPECT_EQ(namesOf(both.cloud), "x y z X");
  EXPECT_TRUE(both.notes.empty());
  EXPECT_THROW(load("two.ply",
                    ply("ascii", "property float X\nproperty float Y\n", 1) + "1 2\n"),
               ToolError);
}

TEST_F(UsualFieldsTest, ColorsOfEveryRangeFillTheirBytes)
{
  struct Case {
    const char *type, *names[3], *values, *color;
  };
  for (const auto& [type, names, values, color] :
       {Case{"float", {"red", "green", "blue"}, "0.8 0.1 0", "204 26 0"},
        Case{"double", {"r", "g", "b"}, "1 0.5 nan", "255 128 0"},
        Case{"float", {"Red", "Green", "Blue"}, "204 25.6 1", "204 26 1"},
        Case{"float", {"red", "green", "blue"}, "65535 256 255", "255 1 0"},
        Case{"ushort", {"red", "green", "blue"}, "200 30 40", "200 30 40"},
        Case{"ushort",
             {"diffuse_red", "diffuse_green", "diffuse_blue"},
             "51400 30 256",
             "200 0 1"},
        Case{"uchar",
             {"diffuse_red", "diffuse_green", "diffuse_blue"},
             "1 2 3",
             "1 2 3"},
        Case{"int", {"R", "G", "B"}, "1 2 3", "1 2 3"}}) {
    std::string properties = xyz;
    for (const char* name : names)
      properties += std::string("property ") + type + " " + name + "\n";
    const auto file =
        load("a.ply", ply("ascii", properties, 1) + "1 2 3 " + values + "\n");
    EXPECT_EQ(colorOf(file, 0), color) << type << " " << names[0] << " " << values;
    EXPECT_EQ(file.notes.size(), 1u);
  }
}

TEST_F(UsualFieldsTest, ThreeFieldsThatAreNoColorsStayAlone)
{
  for (const std::string values : {"-1 2 3", "70000 2 3"}) {
    std::string properties = xyz;
    for (const char* name : {"r", "g", "b"})
      properties += std::string("property float ") + name + "\n";
    const auto file =
        load("a.ply", ply("ascii", properties, 1) + "1 2 3 " + values + "\n");
    EXPECT_EQ(namesOf(file.cloud), "x y z r g b");
    EXPECT_TRUE(file.notes.empty());
  }
  const auto other =
      load("b.ply",
           ply("ascii", xyz + "property float rgb\n" + bytes_of_colors, 1) +
               "1 2 3 0 4 5 6\n");
  EXPECT_EQ(namesOf(other.cloud), "x y z rgb red green blue");
}

TEST_F(UsualFieldsTest, ColorsOfBytesInFrontOfTheCoordinates)
{
  const std::string point = bytes(std::uint8_t(1)) + bytes(std::uint8_t(2)) +
                            bytes(std::uint8_t(3)) + bytes(std::uint8_t(255)) +
                            bytes(4.0f) + bytes(5.0f) + bytes(6.0f);
  const auto file = load(
      "first.ply",
      ply("binary_little_endian", bytes_of_colors + "property uchar alpha\n" + xyz, 2) +
          point + point);
  EXPECT_EQ(namesOf(file.cloud), "rgba x y z");
  EXPECT_EQ(colorOf(file, 1), "1 2 3");
  EXPECT_EQ((*file.points)[1].z, 6.0f);
  EXPECT_TRUE(file.notes.empty());
  EXPECT_EQ(streams_, 1);
}

TEST_F(UsualFieldsTest, ListsInFrontOfThePoints)
{
  const std::string header =
      "ply\nformat ascii 1.0\nelement camera 1\n"
      "property float view_px\nproperty list uchar int k\n"
      "element vertex 2\n" +
      xyz + "property list char float w\nproperty uchar c\nend_header\n";
  const auto file = load("list.ply", header + "1.5 2 7 8\n1 2 3 2 9 9 1\n4 5 6 0 2\n");
  EXPECT_EQ((*file.points)[1].x, 4.0f);
  EXPECT_EQ(readLabels(file, "c")[1], 2u);
}

TEST_F(UsualFieldsTest, AListOfNegativeLengthIsDamage)
{
  for (const std::string type : {"char", "short", "int"}) {
    const auto content = ply("ascii", "property list " + type + " float w\n" + xyz, 2) +
                         "-1 1 2 3\n0 4 5 6\n" + std::string(200000, ' ');
    try {
      load("list.ply", content);
      FAIL() << type;
    } catch (const ToolError& error) {
      EXPECT_NE(std::string(error.what()).find("damaged"), std::string::npos)
          << error.what();
    }
  }
}

/** The range of colours is decided by the same points in one piece and in parts. */
TEST_F(UsualFieldsTest, LargeFilesAreTheSameInParts)
{
  std::string points;
  for (int i = 0; i < 1300000; ++i)
    points += bytes(0.001f * static_cast<float>(i)) + bytes(1.0f) + bytes(2.0f) +
              bytes(std::uint16_t(i % 5000 == 4999 ? 300 : 200)) +
              bytes(std::uint16_t(30)) + bytes(std::uint16_t(40));
  const auto file = load(
      "large.pcd",
      pcd("x y z r g b", "4 4 4 2 2 2", "F F F U U U", "1 1 1 1 1 1", points, 1300000));
  EXPECT_EQ(streams_, 1);
  EXPECT_TRUE(hasField(file.cloud, "rgb"));
}

TEST(SampleBlocks, ShowEveryPointOfASmallFileOnceAndAMillionOfALargeOne)
{
  for (const std::uint64_t count : {0u, 1u, 100u, 300u, 70001u, 1048576u, 5000000u}) {
    std::uint64_t next = 0, seen = 0;
    sampleBlocks(count, [&](std::uint64_t first, std::size_t size) {
      EXPECT_GE(first, next);
      next = first + size;
      seen += size;
      EXPECT_LE(next, count);
    });
    EXPECT_EQ(seen, std::min<std::uint64_t>(count, 1048576));
  }
}
