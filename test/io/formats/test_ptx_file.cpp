/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_file.h"
#include "files/cloud_formats.h"
#include "files/cloud_stream.h"
#include "files/tool_error.h"
#include "support/expect_part.h"
#include "support/folder_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace pcl::indoor::tool;

namespace {

/** The header of a scan that is turned by a right angle about z, x to y. */
std::string
headerOf(std::size_t columns, std::size_t rows, const std::string& place)
{
  return std::to_string(columns) + "\n" + std::to_string(rows) + "\n" + place +
         "\n0 1 0\n-1 0 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n" + place + " 1\n";
}

const std::string identity = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";

class PtxFiles : public pcl::indoor::test::FolderTest {
protected:
  CloudFile
  load(const std::string& text)
  {
    return loadCloud(write("scan.ptx", text), {}, 1);
  }

  std::string
  refusal(const std::string& text)
  {
    try {
      load(text);
    } catch (const ToolError& error) {
      const std::string message = error.what(), start = path("scan.ptx") + ": ";
      EXPECT_EQ(message.substr(0, start.size()), start);
      return message.substr(std::min(start.size(), message.size()));
    }
    return "it was read";
  }
};

} // namespace

TEST_F(PtxFiles, PointsAreMovedByTheMatrixAndKeepRowAndColumn)
{
  const auto file =
      load(headerOf(2, 3, "691234.5 5334567.25 500") + "1 0 0 0.5 255 0 0\n"
                                                       "0 2 0 0.25 0 255 0\n"
                                                       "0 0 3 1.0 0 0 255\n"
                                                       "0 0 0 0.500000 0 0 0\n"
                                                       "1.5 2.5 -3.5 0 1 2 3\r\n"
                                                       "-1e-3 0 0 0.125 10 20 30\n");
  const CloudPlaces found(file.cloud);
  ASSERT_EQ(found.size(), 6u);
  const Eigen::Vector3d place(691234.5, 5334567.25, 500);
  const Eigen::Vector3d expected[] = {{0, 1, 0},
                                      {-2, 0, 0},
                                      {0, 0, 3},
                                      {NAN, NAN, NAN},
                                      {-2.5, 1.5, -3.5},
                                      {0, -1e-3, 0}};
  for (std::size_t i = 0; i < 6; ++i)
    if (i == 3)
      EXPECT_TRUE(std::isnan(found.at(i).x()));
    else
      EXPECT_LT((found.at(i) - expected[i] - place).norm(), 2e-9); // a step of 5334567
  EXPECT_EQ(readLabels(file, "row"), (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 2}));
  EXPECT_EQ(readLabels(file, "column"), (std::vector<std::uint32_t>{0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(readNumbers(file, "intensity"),
            (std::vector<double>{0.5, 0.25, 1, 0.5, 0, 0.125}));
  EXPECT_EQ(readColors(file)->at(4).rgba & 0xffffff, 0x010203u);
  EXPECT_EQ(file.finite_count, 5u);
  EXPECT_EQ(
      file.notes,
      std::vector<std::string>{"points at 0 0 0 saw no return and are left out: 1"});
  ASSERT_EQ(file.stations.size(), 1u);
  EXPECT_EQ(file.stations[0].position, place);
  EXPECT_FALSE(hasField(file.cloud, "station"));
}

TEST_F(PtxFiles, ScansFollowEachOther)
{
  const auto file = load(headerOf(1, 2, "1 2 3") + "1 0 0 0.5\n0 1 0 0.5\n" +
                         "0\n5\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + identity + // no points
                         "2\n1\n7 8 9\n1 0 0\n0 1 0\n0 0 1\n" + identity +
                         "7 8 10 0.5\n0.0 -0.0 0 0.5\n\n");
  EXPECT_EQ(readLabels(file, "station"), (std::vector<std::uint32_t>{1, 1, 2, 2}));
  ASSERT_EQ(file.stations.size(), 2u);
  EXPECT_EQ(file.stations[0].name, "scan 1");
  EXPECT_EQ(file.stations[0].position, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(file.stations[1].name, "scan 3");
  EXPECT_EQ(file.stations[1].position, Eigen::Vector3d(7, 8, 9)); // moved before
  EXPECT_EQ(CloudPlaces(file.cloud).at(2), Eigen::Vector3d(7, 8, 10));
  EXPECT_EQ(file.finite_count, 3u);
}

TEST_F(PtxFiles, FieldsThatNotAllScansHaveAreLeftOutAndNamed)
{
  const auto file = load(headerOf(1, 1, "1 2 3") + "1 0 0 0.5 1 2 3\n" +
                         headerOf(1, 1, "1 2 3") + "1 0 1 0.5\n");
  EXPECT_FALSE(hasField(file.cloud, "rgb"));
  EXPECT_TRUE(hasField(file.cloud, "intensity"));
  EXPECT_EQ(file.notes[0], "fields that not all of the scans have are left out: rgb");
  EXPECT_FALSE(hasField(load(headerOf(1, 1, "1 2 3") + "1 0 0\n").cloud, "intensity"));
  EXPECT_TRUE(hasField(load(headerOf(1, 1, "1 2 3") + "1 0 0 1 2 3\n").cloud, "rgb"));
}

TEST_F(PtxFiles, ManyPointsAreReadInParts)
{
  std::mt19937 random(1);
  std::string text;
  for (const char* place : {"1 2 3", "-10 5.5 0"}) {
    text += headerOf(70, 100, place);
    for (int i = 0; i < 7000; ++i) {
      char line[100];
      std::snprintf(line,
                    sizeof(line),
                    "%.6f %.6f %.6f %.3f\n%s",
                    random() % 7 == 0 ? 0.0 : 1e-9 * random(),
                    0.0,
                    0.0,
                    0.5,
                    random() % 50 == 0 ? " \n" : "");
      text += line;
    }
  }
  const auto file = load(text);
  const auto stream = CloudStream::open(path("scan.ptx"));
  ASSERT_TRUE(stream);
  ASSERT_EQ(stream->pointCount(), 14000u);
  EXPECT_NEAR(static_cast<double>(promisedPoints(path("scan.ptx"))), 14000, 700);
  EXPECT_EQ(stream->notes(), file.notes);
  EXPECT_EQ(stream->stations()[1].position, Eigen::Vector3d(-10, 5.5, 0));
  for (int trial = 0; trial < 50; ++trial) {
    const auto first = random() % 14000, count = 1 + random() % (14000 - first);
    pcl::indoor::test::expectPart(*stream, file.cloud, first, count);
  }
}

TEST_F(PtxFiles, AreToldByTheirFirstLines)
{
  const auto text = headerOf(1, 2, "1 2 3") + "1 0 0 0.5\n0 1 0 0.5\n";
  EXPECT_EQ(cloudFormatOf(write("scan.txt", text))->name, std::string("PTX"));
  EXPECT_EQ(cloudFormatOf(write("scan.ptx", "2\n"))->name, std::string("PTX"));
  EXPECT_EQ(cloudFormatOf(write("scan.pts", "2\n1 2 3\n4 5 6\n"))->name,
            std::string("table"));
  EXPECT_EQ(cloudFormatOf(write("a.txt", "2\n3\n1 2 3 4\n"))->name,
            std::string("table"));
}

TEST_F(PtxFiles, DamagedFilesAreRefused)
{
  const auto good = headerOf(2, 1, "1 2 3");
  EXPECT_EQ(refusal(good + "1 0 0 0.5\n"),
            "the file is truncated, its header promises 2 points of a scan, it has 1");
  EXPECT_EQ(refusal(good.substr(0, good.size() - 8)),
            "the file ends within the header of a scan");
  EXPECT_EQ(refusal(""), "the cloud is empty (0 points)");
  EXPECT_EQ(refusal("2\n\n"), "the file ends within the header of a scan");
  EXPECT_EQ(refusal(good + "1 0 0 0.5\n1 0 0\n"),
            "line 12: '1 0 0' are not 4 numbers, as the first point has");
  EXPECT_EQ(refusal(good + "1 0 0 0.5\n1 0 x 0.5\n"),
            "line 12: '1 0 x 0.5' are not 4 numbers, as the first point has");
  EXPECT_EQ(refusal(good + "1 0\n1 0\n"), "line 11: a point has 3, 4, 6 or 7 numbers");
  EXPECT_EQ(refusal(good + "1 0 0 1 2 256\n1 0 0 1 2 3\n"),
            "line 11: a colour is not a number of 0 to 255");
  EXPECT_EQ(refusal(good + "1 0 0 1\n1 0 0 2\n1 0 0 3\n"),
            "line 13: the header of a scan has 1 number here");
  EXPECT_EQ(refusal("2\n1\n1 2\n"), "line 3: the header of a scan has 3 numbers here");
  for (const char* count : {"-1", "1.5", "nan", "1e10"})
    EXPECT_NE(refusal(count + good.substr(1)).find("no number of columns"),
              std::string::npos)
        << count;
  EXPECT_NE(
      refusal(headerOf(2000000, 2000000, "1 2 3")).find("more than 2^31 - 1 points"),
      std::string::npos);
  EXPECT_NE(refusal(headerOf(20000, 20000, "1 2 3")).find("it has 0"),
            std::string::npos);
  auto column = good; // translation in the last column
  column.replace(column.find("0 1 0 0\n"), 8, "0 1 0 5\n");
  EXPECT_NE(refusal(column + "1 0 0\n1 0 0\n").find("its last column is not"),
            std::string::npos);
  EXPECT_NE(refusal(good + std::string(400000, '1')).find("longer than 65536 bytes"),
            std::string::npos);
}
