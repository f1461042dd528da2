/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"
#include "files/cloud_check.h"
#include "files/cloud_file.h"
#include "formats/table_file.h"
#include "support/folder_test.h"

#include <pcl/common/io.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <sstream>
#include <vector>

using namespace pcl::indoor::tool;

namespace {

class Tables : public pcl::indoor::test::FolderTest {
protected:
  CloudFile
  load(const std::string& text, const std::string& columns = "") const
  {
    return loadCloud(write("table.txt", text), {columns}, 1);
  }

  std::string
  complaint(const std::string& text, const std::string& columns = "") const
  {
    try {
      load(text, columns);
    } catch (const ToolError& error) {
      const std::string message = error.what(), start = path("table.txt") + ": ";
      return message.rfind(start, 0) == 0 ? message.substr(start.size()) : message;
    }
    return "it was read";
  }
};

std::string
fieldsOf(const CloudFile& file)
{
  std::string names;
  for (const auto& field : file.cloud.fields)
    names += (names.empty() ? "" : " ") + field.name;
  return names;
}

template <typename T>
std::vector<T>
valuesOf(const CloudFile& file, const std::string& name)
{
  const auto& field =
      file.cloud.fields.at(static_cast<std::size_t>(getFieldIndex(file.cloud, name)));
  std::vector<T> values(file.cloud.width);
  for (std::size_t i = 0; i < values.size(); ++i)
    std::memcpy(&values[i],
                &file.cloud.data[i * file.cloud.point_step + field.offset],
                sizeof(T));
  return values;
}

using Doubles = std::vector<double>;
using Floats = std::vector<float>;
using Wholes = std::vector<std::uint32_t>;

} // namespace

TEST_F(Tables, AnySeparatorSeparates)
{
  for (const char* text : {"1 2.5 -3\n4 5 6\n",
                           "1\t2.5\t-3\n4\t5\t6",
                           "  1   2.5 \t-3  \r\n\r\n4 5 6\r\n",
                           "1,2.5,-3\n4,5,6\n",
                           "1, 2.5, -3,\n4, 5, 6,\n",
                           "1;2.5;-3\n4;5;6\n",
                           "\"1\";\"2.5\";\"-3\"\n4;5;6\n",
                           "\xef\xbb\xbf+1 25e-1 -3\n4 5 6\n"}) {
    const auto file = load(text);
    EXPECT_EQ(fieldsOf(file), "x y z") << text;
    EXPECT_EQ(valuesOf<double>(file, "x"), (Doubles{1, 4})) << text;
    EXPECT_EQ(valuesOf<double>(file, "y"), (Doubles{2.5, 5})) << text;
    EXPECT_EQ(valuesOf<double>(file, "z"), (Doubles{-3, 6})) << text;
  }
}

TEST_F(Tables, CommentsAndBlankLinesAreLeftOut)
{
  const auto file = load("# made by hand\n\n// x marks the spot\n1 2 3\n#4 5 6\n7 8 9");
  EXPECT_EQ(valuesOf<double>(file, "x"), (Doubles{1, 7}));
}

TEST_F(Tables, HeadersNameTheColumns)
{
  for (const char* header : {"z,X,y,R,G,B,Label,Nx,GPS time",
                             "\"Z\";\"X\";\"Y\";red;green;blue;label;normal_x;gps_time",
                             "//Z X Y r g b label nx gps_time",
                             "# z x y r g b label nx gps_time"}) {
    const auto file =
        load(std::string(header) + "\n3 1 2 255 128 0 4000000000 0.5 7\n");
    EXPECT_EQ(fieldsOf(file), "x y z rgb label normal_x gps_time") << header;
    EXPECT_EQ(valuesOf<double>(file, "x"), (Doubles{1})) << header;
    EXPECT_EQ(valuesOf<double>(file, "z"), (Doubles{3})) << header;
    EXPECT_EQ(valuesOf<std::uint32_t>(file, "rgb"), (Wholes{0xff8000})) << header;
    EXPECT_EQ(valuesOf<std::uint32_t>(file, "label"), (Wholes{4000000000u})) << header;
    EXPECT_EQ(valuesOf<float>(file, "normal_x"), (Floats{0.5f})) << header;
    EXPECT_EQ(valuesOf<float>(file, "gps_time"), (Floats{7})) << header;
  }
}

TEST_F(Tables, WithoutAHeaderTheNumberOfColumnsTells)
{
  EXPECT_EQ(fieldsOf(load("1 2 3\n")), "x y z");
  EXPECT_EQ(fieldsOf(load("1 2 3 4.5\n")), "x y z intensity");
  EXPECT_EQ(fieldsOf(load("1 2 3 4 5\n")), "x y z column_4 column_5");
  EXPECT_EQ(fieldsOf(load("1 2 3 4 5 6\n1 2 3 255 0 6\n")), "x y z rgb");
  EXPECT_EQ(fieldsOf(load("1 2 3 0 0 1\n1 2 3 0.6 0.8 0\n")),
            "x y z normal_x normal_y normal_z");
  EXPECT_EQ(fieldsOf(load("1 2 3 4 5 6\n1 2 3 256 0 6\n")),
            "x y z normal_x normal_y normal_z");
  EXPECT_EQ(fieldsOf(load("2\n1 2 3 -1 4 5 6\n1 2 3 99 4 5 6\n")),
            "x y z intensity rgb");
  EXPECT_EQ(fieldsOf(load("1 2 3 -1 4 5 6.5\n")),
            "x y z column_4 column_5 column_6 column_7");
  EXPECT_EQ(valuesOf<float>(load("1 2 3 -1 4 5 6\n"), "intensity"), (Floats{-1}));
}

TEST_F(Tables, TheOptionSaysWhatColumnsAre)
{
  const auto file = load("7 9 1 2 3 10 20 30\n", "_,room,x,y,z,b,g,r");
  EXPECT_EQ(fieldsOf(file), "x y z room rgb");
  EXPECT_EQ(valuesOf<float>(file, "room"), (Floats{9}));
  EXPECT_EQ(valuesOf<std::uint32_t>(file, "rgb"), (Wholes{0x1e140a}));
  EXPECT_EQ(readLabels(file, "room"), (Wholes{9}));
  // it stands above a header, which need not name anything known
  EXPECT_EQ(fieldsOf(load("east,north,up\n1,2,3\n", "x,y,z")), "x y z");
  EXPECT_EQ(complaint("1 2 3 4\n", "x,y,z"), "line 1 has 4 values, 'x,y,z' names 3");
  EXPECT_EQ(complaint("1 2 3\n", "x,y,_"), "-columns: it names no column 'z'");
  EXPECT_EQ(complaint("1 2 3 4\n", "x,y,z,x"), "-columns: it names columns 'x' twice");
  EXPECT_THROW(loadCloud(write("a.pcd",
                               "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\n"
                               "HEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3\n"),
                         {"x,y,z"},
                         1),
               ToolError);
}

TEST_F(Tables, FieldsThatCannotBeAreNumbered)
{
  // a name twice, an empty one, one of packed colours, colours that are not all there
  const auto file = load("x,y,z,a,a,,rgb,r,g\n1,2,3,4,5,6,7,8.5,9\n");
  EXPECT_EQ(fieldsOf(file), "x y z a column_5 column_6 column_7 r g");
  EXPECT_EQ(valuesOf<float>(file, "r"), (Floats{8.5f}));
}

TEST_F(Tables, NumbersAreReadToTheLastBit)
{
  std::mt19937_64 rng(1);
  std::ostringstream text;
  Doubles expected;
  text.precision(17);
  for (int i = 0; i < 2000; ++i) {
    const double x = 691234 + static_cast<double>(rng() % 1000000007) / 1000000007.0;
    expected.push_back(x);
    text << x << " 5334567.123456789 0.1\n";
  }
  const auto file = load(text.str());
  EXPECT_EQ(valuesOf<double>(file, "x"), expected);
  EXPECT_EQ(valuesOf<double>(file, "y")[7], 5334567.123456789);
  EXPECT_EQ(file.offset.y(), 5334567);
  EXPECT_NEAR((*file.points)[7].y, 0.123456789f, 1e-8f);
}

TEST_F(Tables, WhatIsNotFiniteOrTooLargeIsAPointWithoutAPlace)
{
  const auto file = load("1 2 3\nnan 2 3\n1 -inf 3\n1 2 1e999\n1 2 1e-999\n");
  EXPECT_EQ(file.cloud.width, 5u);
  EXPECT_EQ(file.finite_count, 2u);
}

TEST_F(Tables, CountsOfPartsArePromises)
{
  EXPECT_EQ(load("2\n1 2 3\n4 5 6\n1\n7 8 9\n").cloud.width, 3u);
  EXPECT_EQ(load("//X Y Z\n1\n1 2 3\n").cloud.width, 1u);
  EXPECT_EQ(load("1\nx y z\n1 2 3\n").cloud.width, 1u);
  EXPECT_NE(complaint("3\n1 2 3\n4 5 6\n").find("truncated"), std::string::npos);
  EXPECT_EQ(complaint("1\n1 2 3\n4 5 6\n"),
            "line 3: a point more than the 1 that the file promises");
}

TEST_F(Tables, BadRowsAreNamedByTheirLine)
{
  EXPECT_EQ(complaint("# a\n1 2 3\n\n4 five 6\n"), "line 4: 'five' is not a number");
  EXPECT_EQ(complaint("1 2 3\n4 5 6 7\n"),
            "line 2 has 4 values, the rows before have 3");
  EXPECT_EQ(complaint("1 2\n"), "line 1 has 2 values, a point has at least 3");
  EXPECT_EQ(complaint("1,2,3\n1,,3\n"), "line 2: a value is missing");
  EXPECT_EQ(complaint("1,2,3\n1,2,\n"), "line 2: a value is missing");
  EXPECT_EQ(complaint("x y z r g b\n1 2 3 4 5 6\n1 2 3 4 5 256\n"),
            "line 3: the colour '256' is not a whole number of 0 to 255");
  EXPECT_EQ(complaint("x y z label\n1 2 3 -1\n"),
            "line 2: the label '-1' is not a whole number of 0 to 4294967295");
  EXPECT_EQ(complaint("x y z\n1 2 3 4\n"), "line 2 has 4 values, line 1 names 3");
  EXPECT_EQ(complaint("a b c\n1 2 3\n"), "line 1 names no column 'x'");
  EXPECT_EQ(complaint("x y z x\n1 2 3 4\n"), "line 1 names columns 'x' twice");
  EXPECT_EQ(complaint("x y z\n"), "the cloud is empty (0 points)");
  EXPECT_EQ(complaint("1 2 3\n1 2 3 # here\n"),
            "line 2 has 5 values, the rows before have 3");
  EXPECT_EQ(complaint("1 2 b\n"), "line 1 names no column 'x'");
}

TEST_F(Tables, DecimalCommasAreRefused)
{
  const std::string why = "' is no number; decimals need a point, not a comma";
  EXPECT_EQ(complaint("1,5;2,25;3,5\n"), "line 1: '1,5" + why);
  EXPECT_EQ(complaint("x;y;z\n1;2;3\n1;2,25;3\n"), "line 3: '2,25" + why);
  EXPECT_EQ(complaint("1,5 2,5 3,5\n").substr(0, 7), "line 1:");
  EXPECT_NE(complaint("1,5 2,5 3,5\n").find(why), std::string::npos);
  EXPECT_NE(complaint("1 2 3\n1,5 2 3\n").find(why), std::string::npos);
}

TEST_F(Tables, TheyAreToldFromOtherFilesByEndingOrContent)
{
  for (const char* name : {"a", "a.dat", "a.xyz", "a.XYZ", "a.asc", "a.csv", "a.pts"})
    EXPECT_EQ(checkCloudFile(write(name, "x y z\n1 2 3\n")).format, CloudFormat::Table)
        << name;
  const std::string pcd = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\n"
                          "TYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n"
                          "DATA ascii\n1 2 3\n";
  EXPECT_EQ(checkCloudFile(write("pcd.txt", pcd)).format, CloudFormat::PCD);
  for (const char* text : {"Dear reader,\n", "OFF\n3 1 0\n", "v 1 2 3\nv 4 5 6\n"})
    EXPECT_THROW(loadCloud(write("b", text)), ToolError) << text;
}

TEST_F(Tables, TheNumberOfPointsIsPromisedOrEstimated)
{
  EXPECT_EQ(promisedPoints(write("a.pts", "# by hand\n1234\n1 2 3\n")), 1234u);
  std::string text = "x y z\n";
  for (int i = 0; i < 1000; ++i)
    text += "1.25 2.50 3.75\n";
  EXPECT_NEAR(static_cast<double>(promisedPoints(write("a.csv", text))), 1000, 10);
  EXPECT_EQ(promisedPoints(write("b.txt", "nothing\n")), 0u);
}
