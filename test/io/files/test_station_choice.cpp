/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/station_choice.h"

#include "files/tool_error.h"
#include "support/folder_test.h"

#include <gtest/gtest.h>

using namespace pcl::indoor::tool;
using pcl::indoor::Station;

namespace {

class StationChoiceTest : public pcl::indoor::test::FolderTest {
protected:
  /** Three points, and what a field station says of them. */
  CloudFile
  scan(const std::vector<std::uint32_t>& station_of_point = {})
  {
    auto file = loadCloud(write("scan.xyz", "0 0 0\n1 0 0\n0 1 0\n"));
    if (!station_of_point.empty())
      appendField(file.cloud, "station", station_of_point);
    return file;
  }

  void
  expectRefused(const StationChoice& choice, CloudFile file, const std::string& reason)
  {
    try {
      choose(choice, file);
      ADD_FAILURE() << "not refused: " << reason;
    } catch (const ToolError& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos)
          << error.what();
    }
  }
};

std::vector<Station>
twoStations()
{
  return {{"east", Eigen::Vector3d(1, 0, 0)}, {"west", Eigen::Vector3d(2, 0, 0)}};
}

} // namespace

TEST_F(StationChoiceTest, PositionsStandInATable)
{
  for (const char* text : {"1.5 2 3\n500000.25 5800000.5 120\n",
                           "x,y,z\n1.5,2,3\n500000.25,5800000.5,120\n",
                           "1.5;2;3\n500000.25;5800000.5;120\n"}) {
    const auto stations = readStations(write("positions.csv", text));
    ASSERT_EQ(stations.size(), 2u) << text;
    EXPECT_EQ(stations[0].name, "1");
    EXPECT_EQ(*stations[0].position, Eigen::Vector3d(1.5, 2, 3));
    EXPECT_EQ(*stations[1].position, Eigen::Vector3d(500000.25, 5800000.5, 120));
  }
}

TEST_F(StationChoiceTest, OneStationIsEnough)
{
  EXPECT_EQ(readStations(write("positions.csv", "1 2 3\n")).size(), 1u);
}

TEST_F(StationChoiceTest, OddFilesAreRefused)
{
  expectRefused(StationChoice{path("none.csv")}, scan(), "none.csv");
  expectRefused(StationChoice{write("empty.csv", "")}, scan(), "empty.csv");
  expectRefused(StationChoice{write("flat.csv", "1 2\n3 4\n")}, scan(), "flat.csv");
  expectRefused(
      StationChoice{write("nan.csv", "1 2 3\nnan 1 2\n")}, scan(), "station 2");
}

TEST_F(StationChoiceTest, ThoseOfAFileStandInForItsOwn)
{
  auto file = scan();
  file.stations = twoStations();
  choose(StationChoice{write("positions.csv", "5 0 0\n6 0 0\n")}, file);
  ASSERT_EQ(file.stations.size(), 2u);
  EXPECT_EQ(file.stations[1].name, "west");
  EXPECT_EQ(*file.stations[1].position, Eigen::Vector3d(6, 0, 0));
  expectRefused(StationChoice{write("three.csv", "5 0 0\n6 0 0\n7 0 0\n")},
                file,
                "3 positions for the 2 stations");
}

TEST_F(StationChoiceTest, IgnoredStationsHaveNoPositions)
{
  auto file = scan({1, 2, 1});
  file.stations = twoStations();
  EXPECT_EQ(stationPositions(file).size(), 2u);
  EXPECT_EQ(stationsOfPoints(file), (std::vector<std::uint32_t>{1, 2, 1}));
  choose(StationChoice{"", true}, file);
  EXPECT_EQ(file.stations.size(), 2u);
  EXPECT_TRUE(stationPositions(file).empty());
  EXPECT_TRUE(stationsOfPoints(file).empty());
}

TEST_F(StationChoiceTest, AFieldThatDoesNotFitIsNoted)
{
  const StationChoice choice{write("positions.csv", "5 0 0\n6 0 0\n")};
  auto fits = scan({2, 0, 1});
  choose(choice, fits);
  EXPECT_TRUE(fits.notes.empty());
  EXPECT_EQ(stationsOfPoints(fits), (std::vector<std::uint32_t>{2, 0, 1}));
  auto larger = scan({2, 3, 1});
  choose(choice, larger);
  ASSERT_EQ(larger.notes.size(), 1u);
  EXPECT_NE(larger.notes[0].find("does not fit the 2 positions"), std::string::npos);
  EXPECT_TRUE(stationsOfPoints(larger).empty());
}

TEST_F(StationChoiceTest, OfOneStationAreAllPoints)
{
  auto file = scan();
  EXPECT_TRUE(stationsOfPoints(file).empty());
  choose(StationChoice{write("positions.csv", "5 0 0\n")}, file);
  EXPECT_EQ(stationsOfPoints(file), std::vector<std::uint32_t>(3, 1));
}

TEST_F(StationChoiceTest, PositionsAreInTheFrameOfThePoints)
{
  auto file = scan();
  file.offset = Eigen::Vector3d(0.5, 0, 0);
  file.stations = twoStations();
  ASSERT_EQ(stationPositions(file).size(), 2u);
  EXPECT_EQ(stationPositions(file)[0], Eigen::Vector3d(0.5, 0, 0));
}

TEST_F(StationChoiceTest, AllPositionsOrNoneAreKnown)
{
  auto file = scan({1, 2, 1});
  file.stations = twoStations();
  file.stations[1].position.reset();
  EXPECT_TRUE(stationPositions(file).empty());
  EXPECT_TRUE(stationsOfPoints(file).empty());
}
