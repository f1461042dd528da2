/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_file.h"
#include "files/cloud_formats.h"
#include "files/tool_error.h"
#include "formats/table/table_file.h"
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

/** The notes of a file, one behind the other. */
std::string
notesOf(const CloudFile& file)
{
  std::string notes;
  for (const auto& note : file.notes)
    notes += (notes.empty() ? "" : " | ") + note;
  return notes;
}

template <typename T>
std::vector<T>
columnValues(const CloudFile& file, const std::string& name)
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
    EXPECT_EQ(columnValues<double>(file, "x"), (Doubles{1, 4})) << text;
    EXPECT_EQ(columnValues<double>(file, "y"), (Doubles{2.5, 5})) << text;
    EXPECT_EQ(columnValues<double>(file, "z"), (Doubles{-3, 6})) << text;
  }
}

TEST_F(Tables, CommentsAndBlankLinesAreLeftOut)
{
  const auto file = load("# made by hand\n\n// x marks the spot\n1 2 3\n#4 5 6\n7 8 9");
  EXPECT_EQ(columnValues<double>(file, "x"), (Doubles{1, 7}));
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
    EXPECT_EQ(columnValues<double>(file, "x"), (Doubles{1})) << header;
    EXPECT_EQ(columnValues<double>(file, "z"), (Doubles{3})) << header;
    EXPECT_EQ(columnValues<std::uint32_t>(file, "rgb"), (Wholes{0xff8000})) << header;
    EXPECT_EQ(columnValues<std::uint32_t>(file, "label"), (Wholes{4000000000u}))
        << header;
    EXPECT_EQ(columnValues<float>(file, "normal_x"), (Floats{0.5f})) << header;
    EXPECT_EQ(columnValues<float>(file, "gps_time"), (Floats{7})) << header;
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
  EXPECT_EQ(fieldsOf(load("2\n1 2 3 -1 4 5 6\n1 2 3 99 4 5 6\n")),
            "x y z intensity rgb");
  EXPECT_EQ(fieldsOf(load("1 2 3 -1 4 5 6.5\n")),
            "x y z column_4 column_5 column_6 column_7");
  EXPECT_EQ(columnValues<float>(load("1 2 3 -1 4 5 6\n"), "intensity"), (Floats{-1}));
  EXPECT_EQ(notesOf(load("1 2 3\n")), "");
  EXPECT_EQ(
      notesOf(load("1 2 3 4 5\n")),
      "its columns are taken as x,y,z,column_4,column_5; -columns says otherwise");
}

TEST_F(Tables, ColumnsAreNormalsOnlyIfTheirLengthIsOne)
{
  std::string normals, axes, some, mirrors;
  for (int i = 0; i < 40; ++i) {
    const std::string axis = i % 3 == 0 ? "1 0 0" : i % 3 == 1 ? "0 1 0" : "0 0 1";
    normals += "1 2 3 " + std::string(i == 7 ? "0 0 0" : "0.61 -0.79 0.04") + "\n";
    axes += "1 2 3 " + axis + "\n";
    some += "1 2 3 " + std::string(i % 5 == 0 ? "0.1 0.1 0.1" : "0.6 0.8 0") + "\n";
    mirrors += "1 2 3 " + std::string(i % 5 == 0 ? "-9 0 0" : "0.6 0.8 0") + "\n";
  }
  const std::string with_normals = "x y z normal_x normal_y normal_z";
  EXPECT_EQ(fieldsOf(load(normals)), with_normals);
  EXPECT_EQ(fieldsOf(load(axes)), with_normals);
  EXPECT_EQ(fieldsOf(load(some)), "x y z rgb");
  EXPECT_EQ(fieldsOf(load(mirrors)), "x y z column_4 column_5 column_6");
}

TEST_F(Tables, TimesBeforeThePlaceAreNoPlace)
{
  std::string seconds, of_week;
  for (int i = 0; i < 12; ++i) {
    const auto row =
        " " + std::to_string(i % 3) + ".5 2.25 " + std::to_string(i % 2) + ".75\n";
    seconds += std::to_string(1600000000 + i / 2) + ".125" + row;
    of_week += std::to_string(300000 + i / 2) + ".125" + row;
  }
  const auto clock = load(seconds);
  EXPECT_EQ(clock.cloud.fields.size(), 3u);
  EXPECT_EQ(columnValues<double>(clock, "y"), Doubles(12, 2.25));
  const auto unclear = load(of_week); // may be an easting
  EXPECT_EQ(columnValues<double>(unclear, "z"), Doubles(12, 2.25));
  ASSERT_EQ(unclear.notes.size(), 2u);
  EXPECT_NE(unclear.notes[1].find("set -columns _,x,y,z"), std::string::npos);
}

TEST_F(Tables, ColoursAreTakenByTheirRange)
{
  const auto rgb = [this](const std::string& text, const std::string& columns = "") {
    return columnValues<std::uint32_t>(load(text, columns), "rgb");
  };
  const Wholes red = {0xff8000, 0x102030};
  EXPECT_EQ(rgb("1 2 3 255 128 0\n1 2 3 16 32 48\n"), red);
  EXPECT_EQ(rgb("1 2 3 1 0.502 0\n1 2 3 0.063 0.125 0.188\n"), red);
  EXPECT_EQ(rgb("1 2 3 65535 32896 0\n1 2 3 4112 8224 12336\n"), red);
  EXPECT_EQ(rgb("x y z r g b\n1 2 3 1 0.502 0\n1 2 3 0.063 0.125 0.188\n"), red);
  EXPECT_EQ(rgb("x y z r g b\n1 2 3 65535 32896 0\n1 2 3 4112 8224 12336\n"), red);
  EXPECT_EQ(rgb("x y z r g b\n1 2 3 255 127.6 0\n1 2 3 16.4 32 48\n"), red);
  EXPECT_EQ(rgb("1 2 3 255.0 128.0 0.0\n1 2 3 16 32 48\n"), red);
  EXPECT_EQ(rgb("1 2 3 1 0.502 0\n1 2 3 0.063 0.125 0.188\n", "x,y,z,r,g,b"), red);
  EXPECT_EQ(notesOf(load("x y z r g b\n1 2 3 0.5 0 0\n")), "it has colours of 0 to 1");
  EXPECT_EQ(notesOf(load("1 2 3 500 0 0\n")),
            "its columns are taken as x,y,z,r,g,b, with colours of 0 to 65535; "
            "-columns says otherwise");
  EXPECT_EQ(fieldsOf(load("1 2 3 70000 0 0\n")), "x y z column_4 column_5 column_6");
  EXPECT_EQ(fieldsOf(load("1 2 3 12.5 0 0\n")), "x y z column_4 column_5 column_6");
  // an intensity before or behind them
  EXPECT_EQ(fieldsOf(load("1 2 3 200 30 40 0.5\n")), "x y z rgb intensity");
  EXPECT_EQ(fieldsOf(load("1 2 3 200 30 40 4000\n")), "x y z rgb intensity");
  EXPECT_EQ(fieldsOf(load("1 2 3 0.6 0 0.8 0.01\n")),
            "x y z normal_x normal_y normal_z column_7");
  EXPECT_EQ(fieldsOf(load("1 2 3 9 8 7 0 0 1\n")),
            "x y z rgb normal_x normal_y normal_z");
}

TEST_F(Tables, OtherWordsNameTheColumns)
{
  const std::string rows = "1 2 3\n4 5 6\n";
  for (const char* header : {"Easting Northing Elevation",
                             "E N H",
                             "X(m) Y(m) Z(m)",
                             "X [m] Y [m] Z [m]",
                             "x_coordinate y_coordinate z_coordinate",
                             "East North Height",
                             "Pos_X Pos_Y Pos_Z",
                             "Points:0 Points:1 Points:2",
                             "cartesianX cartesianY cartesianZ",
                             "Ost Nord H\303\266he",
                             "Est Nord Hauteur",
                             "Abscisse Ordonn\303\251e Altitude",
                             "Este Norte Cota",
                             "X-Koordinate Y-Koordinate Z-Koordinate",
                             "x_m y_m z_m"}) {
    const auto file = load(header + ("\n" + rows));
    EXPECT_EQ(fieldsOf(file), "x y z") << header;
    EXPECT_EQ(columnValues<double>(file, "y"), (Doubles{2, 5})) << header;
  }
  // northing first is no mirror
  const auto file = load("PointNumber,Northing,Easting,Elevation,Code\n1,5,6,7,TREE\n");
  EXPECT_EQ(fieldsOf(file), "x y z pointnumber");
  EXPECT_EQ(columnValues<double>(file, "x"), (Doubles{6}));
  EXPECT_EQ(columnValues<double>(file, "y"), (Doubles{5}));
  EXPECT_EQ(notesOf(file),
            "its columns are taken as pointnumber,y,x,z,_; -columns says otherwise | "
            "columns without numbers are left out: 'code'");
  // plain names come first
  EXPECT_EQ(fieldsOf(load("x,y,z,height,n\n1,2,3,4,5\n")), "x y z height n");
  EXPECT_EQ(fieldsOf(load("x\ty\tz\tRed\tGreen\tBlue\tNx\tReflectance (dB)\n"
                          "1\t2\t3\t4\t5\t6\t7\t8\n")),
            "x y z rgb normal_x reflectance");
  EXPECT_EQ(fieldsOf(load("X Y Z Rf Gf Bf\n1 2 3 0.5 0.2 0.1\n")), "x y z rgb");
  for (const char* colours :
       {"Rot Gr\303\274n Blau", "Rouge Vert Bleu", "Rosso Verde Blu"})
    EXPECT_EQ(fieldsOf(load(std::string("X Y Z ") + colours + "\n1 2 3 4 5 6\n")),
              "x y z rgb")
        << colours;
}

TEST_F(Tables, UnitsOfAHeaderAreSaid)
{
  const std::string note = "its header names the unit of its coordinates: -unit ";
  EXPECT_EQ(notesOf(load("X [m],Y [m],Z [m],Intensity [0-1]\n1,2,3,0.5\n")), "");
  EXPECT_EQ(notesOf(load("X (ft),Y (ft),Z (ft)\n1,2,3\n")), note + "ft");
  EXPECT_EQ(notesOf(load("x,y,z\nmm,mm,mm\n1,2,3\n")), note + "mm");
  EXPECT_EQ(notesOf(load("x_cm y_cm z_cm\n1 2 3\n")), note + "cm");
  EXPECT_EQ(notesOf(load("X [US survey feet] Y [US survey feet] Z [US survey feet]\n"
                         "1 2 3\n")),
            note + "ft");
  EXPECT_EQ(notesOf(load("x (m),y (m),z (ft)\n1,2,3\n")),
            "its header names the units m and ft for coordinates, which are taken as "
            "one: make them one");
  EXPECT_EQ(notesOf(load("x (km),y (km),z (km)\n1,2,3\n")),
            "its header names the unit 'km', which -unit does not know");
}

TEST_F(Tables, NamesOfRowsAreLeftOut)
{
  for (const char* text : {"P1,1.5,2,3\nP2,4,5,6\n",
                           "name,x,y,z\nP1,1.5,2,3\nP2,4,5,6\n",
                           "\"X\" \"Y\" \"Z\"\n\"P1\" 1.5 2 3\n\"P2\" 4 5 6\n",
                           "a b\t1.5\t2\t3\nc d\t4\t5\t6\n",
                           "1.5 2 3 wall\n4 5 6 roof\n"}) {
    const auto file = load(text);
    EXPECT_EQ(fieldsOf(file), "x y z") << text;
    EXPECT_EQ(columnValues<double>(file, "x"), (Doubles{1.5, 4})) << text;
    EXPECT_EQ(columnValues<double>(file, "z"), (Doubles{3, 6})) << text;
  }
  EXPECT_EQ(notesOf(load("P1,1.5,2,3\n")),
            "its columns are taken as _,x,y,z; -columns says otherwise, for example "
            "_,y,x,z where northing comes first");
  std::string counted, whole;
  for (int i = 0; i < 12; ++i) {
    counted += std::to_string(i) + ",0.5,0.25,0.125\n";
    whole += std::to_string(i) + ",0.5,0.25\n";
  }
  EXPECT_EQ(fieldsOf(load(counted)), "x y z");
  EXPECT_EQ(columnValues<double>(load(counted), "x")[7], 0.5);
  EXPECT_EQ(columnValues<double>(load(whole), "x")[7], 7); // else there is no place
  std::string scanner, millimetres, grid;
  for (int i = 0; i < 12; ++i) {
    const auto row = std::to_string(i / 4) + " " + std::to_string(i % 4);
    const auto place = std::to_string(i) + ".5 0.25 0.125";
    scanner += row + " " + place + " 200 30 40\n";
    millimetres += row + " 7 0.6 0.8 0.01\n";
    grid += row + " 0." + std::to_string(i) + " 0.5\n";
  }
  EXPECT_EQ(fieldsOf(load(scanner)), "x y z rgb");
  EXPECT_EQ(columnValues<double>(load(scanner), "x")[7], 7.5);
  EXPECT_EQ(notesOf(load(scanner)),
            "its columns are taken as _,_,x,y,z,r,g,b; -columns says otherwise, for "
            "example _,_,y,x,z,r,g,b where northing comes first");
  EXPECT_EQ(fieldsOf(load(millimetres)), "x y z normal_x normal_y normal_z");
  EXPECT_EQ(fieldsOf(load(grid)), "x y z intensity"); // two are no place
  // a column of unknown name may lack values
  EXPECT_EQ(fieldsOf(load("x,y,z,code,time\n1,2,3,,5\n1,2,3,A,5\n")), "x y z time");
}

TEST_F(Tables, TheOptionSaysWhatColumnsAre)
{
  const auto file = load("7 9 1 2 3 10 20 30\n", "_,room,x,y,z,b,g,r");
  EXPECT_EQ(fieldsOf(file), "x y z room rgb");
  EXPECT_EQ(columnValues<float>(file, "room"), (Floats{9}));
  EXPECT_EQ(columnValues<std::uint32_t>(file, "rgb"), (Wholes{0x1e140a}));
  EXPECT_EQ(readLabels(file, "room"), (Wholes{9}));
  // it stands above a header, which need not name anything known
  EXPECT_EQ(fieldsOf(load("east,north,up\n1,2,3\n", "x,y,z")), "x y z");
  EXPECT_EQ(complaint("1 2 3 4\n", "x,y,z"), "line 1 has 4 values, 'x,y,z' names 3");
  EXPECT_EQ(complaint("1 2 3\n", "x,y,_"), "line 1: -columns names no column 'z'");
  EXPECT_EQ(complaint("1 2 3 4\n", "x,y,z,x"),
            "line 1: -columns names columns 'x' twice");
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
  EXPECT_EQ(columnValues<float>(file, "r"), (Floats{8.5f}));
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
  EXPECT_EQ(columnValues<double>(file, "x"), expected);
  EXPECT_EQ(columnValues<double>(file, "y")[7], 5334567.123456789);
  EXPECT_EQ(file.offset.y(), 5334567);
  EXPECT_NEAR((*file.points)[7].y, 0.123456789f, 1e-8f);
}

TEST_F(Tables, WhatIsNotFiniteOrTooLargeIsAPointWithoutAPlace)
{
  const auto file = load("1 2 3\nnan 2 3\n1 -inf 3\n1 2 1e999\n1 2 1e-999\n");
  EXPECT_EQ(file.cloud.width, 5u);
  EXPECT_EQ(file.finite_count, 2u);
}

TEST_F(Tables, PartsAreStations)
{
  const auto file = loadCloud(write("a.pts", "2\n1 2 3\n4 5 6\n1\n7 8 9\n"), {}, 1);
  EXPECT_EQ(readLabels(file, "station"), (std::vector<std::uint32_t>{1, 1, 2}));
  ASSERT_EQ(file.stations.size(), 2u);
  EXPECT_EQ(file.stations[1].name, "scan 2");
  EXPECT_FALSE(file.stations[1].position);
  const auto one = loadCloud(write("b.pts", "2\n1 2 3\n4 5 6\n"), {}, 1);
  EXPECT_FALSE(hasField(one.cloud, "station"));
  const auto named = loadCloud(
      write("c.csv", "1\nx,y,z,station\n1,2,3,9\n"), {}, 1); // a column of this name
  EXPECT_EQ(readNumbers(named, "station"), std::vector<double>{9});
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
  EXPECT_EQ(complaint("x y z r g b\n1 2 3 4 5 6\n1 2 3 4 5 -1\n"),
            "line 3: the colour '-1' is not a number of 0 to 65535");
  EXPECT_EQ(complaint("x y z intensity\n1 2 3 high\n"),
            "line 2: 'high' is not a number");
  EXPECT_EQ(complaint("x y z label\n1 2 3 -1\n"),
            "line 2: the label '-1' is not a whole number of 0 to 4294967295");
  EXPECT_EQ(complaint("x y z\n1 2 3 4\n"), "line 2 has 4 values, line 1 names 3");
  EXPECT_EQ(complaint("x y z\n"), "the cloud is empty (0 points)");
  EXPECT_EQ(complaint("1 2 3\n1 2 3 # here\n"),
            "line 2 has 5 values, the rows before have 3");
}

TEST_F(Tables, MessagesNameTheColumnsThatWouldDo)
{
  const std::string none =
      "line 1 names no column 'x'; name them, for example -columns ";
  EXPECT_EQ(complaint("a b c\n1 2 3\n"), none + "x,y,z");
  EXPECT_EQ(complaint("id;p;q;s;red;green;blue\nA;1;2;3;4;5;6\n"),
            none + "_,x,y,z,r,g,b");
  EXPECT_EQ(complaint("x y z x\n1 2 3 4\n"),
            "line 1 names columns 'x' twice; name them, for example -columns x,y,z,_");
  EXPECT_EQ(complaint("x,y,when\n1,2,3\n"),
            "line 1 names no column 'z'; name them, for example -columns x,y,z");
  EXPECT_EQ(complaint("1 2 b\n"), none + "x,y,z");
  EXPECT_EQ(complaint("x,y\n1,2\n"),
            "line 1 names no column 'z', nor other numbers that could be it; blanks, "
            "tabs, commas or semicolons part them");
  EXPECT_EQ(
      complaint("Latitude,Longitude,Height\n48.1,11.5,3\n"),
      "line 1 names the column 'latitude': angles are no coordinates, project them "
      "first");
  EXPECT_EQ(fieldsOf(load("id;p;q;s;red;green;blue\nA;1;2;3;4;5;6\n", "_,x,y,z,r,g,b")),
            "x y z rgb");
}

TEST_F(Tables, DecimalsMayHaveCommas)
{
  for (const char* text : {"1,5;2,25;-3,5\n4;5;6\n",
                           "X;Y;Z\n1,5;2,25;-3,5\n4;5;6\n",
                           "1,5\t2,25\t-3,5\n4\t5\t6\n",
                           "1,5 2,25 -3,5\n4 5 6\n",
                           "\"1,5\",\"2,25\",\"-3,5\"\n\"4\",\"5\",\"6\"\n"}) {
    const auto file = load(text);
    EXPECT_EQ(fieldsOf(file), "x y z") << text;
    EXPECT_EQ(columnValues<double>(file, "x"), (Doubles{1.5, 4})) << text;
    EXPECT_EQ(columnValues<double>(file, "y"), (Doubles{2.25, 5})) << text;
    EXPECT_EQ(columnValues<double>(file, "z"), (Doubles{-3.5, 6})) << text;
    EXPECT_EQ(notesOf(file), "its decimals have commas") << text;
  }
  EXPECT_EQ(columnValues<double>(load("1;2;3\n1,5;2;3\n"), "x"), (Doubles{1, 1.5}));
  EXPECT_EQ(complaint("1,5;2.5;3\n"),
            "line 1: '2.5' has another decimal sign than numbers before; points and "
            "commas are mixed");
  EXPECT_EQ(complaint("1,234,5;2;3\n1;2;3\n").substr(0, 7), "line 1 ");
}

TEST_F(Tables, CommasOfBothRolesAreRefused)
{
  const std::string why =
      ": commas part the values and the decimals, too; export it "
      "with points as decimals, or with semicolons between the values";
  EXPECT_EQ(complaint("1,2345,2,3456,0,1234\n1,5,2,0456,0,12\n"), "line 2" + why);
  EXPECT_EQ(complaint("X,Y,Z\n1,2345,-2,3456,0,1234\n"), "line 2" + why);
  EXPECT_EQ(complaint("X,Y,Z,Intensity\n1,2345,-2,3456,0,1234,120\n"), "line 2" + why);
  EXPECT_EQ(complaint("1,2345,2,3456,0,1234\n1,5,2,45,3\n"),
            "line 2 has 5 values, the rows before have 6; commas must not part "
            "decimals, too");
  EXPECT_EQ(
      complaint("1,5 2,5\n"),
      "line 1: '5 2' is no number; where commas part values, decimals need a point");
  // whole numbers, points with commas behind them
  EXPECT_EQ(fieldsOf(load("1234,2345,1200,255,0,16\n0,10,20,1,2,3\n")), "x y z rgb");
  EXPECT_EQ(fieldsOf(load("1.0,2.0,3.0,007\n")), "x y z intensity");
}

TEST_F(Tables, ControlCharactersAreLeftOut)
{
  auto file = load("1 2 3 4 5 6\n1 2 3 103.0\x10"
                   "000 100 90\n1 2 3 185\x10"
                   "187 7\n");
  EXPECT_EQ(columnValues<std::uint32_t>(file, "rgb"),
            (Wholes{0x040506, 0x67645a, 0xb9bb07}));
  EXPECT_EQ(file.notes.back(), "control characters are left out in line 2 and 1 more");
}

TEST_F(Tables, TheyAreToldFromOtherFilesByEndingOrContent)
{
  for (const char* name : {"a", "a.dat", "a.xyz", "a.XYZ", "a.asc", "a.csv", "a.pts"})
    EXPECT_EQ(cloudFormatOf(write(name, "x y z\n1 2 3\n"))->name, std::string("table"))
        << name;
  const std::string pcd = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\n"
                          "TYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n"
                          "DATA ascii\n1 2 3\n";
  EXPECT_EQ(cloudFormatOf(write("pcd.txt", pcd))->name, std::string("PCD"));
  for (const char* text : {"Dear reader,\n", "OFF\n3 1 0\n"})
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
