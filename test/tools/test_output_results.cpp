/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Runs the tools, found by PCL_INDOOR_TOOLS, and looks at the form of what they write.
#include "files/cloud_file.h"
#include "pictures/color.h"
#include "pictures/svg_raster.h"
#include "support/folder_test.h"
#include "support/run_tool.h"
#include "support/synthetic_scenes.h"

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <sys/stat.h> // for mkfifo
#include <sys/wait.h> // for WIFEXITED

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

using pcl::indoor::test::bytesOf;

class OutputResults : public pcl::indoor::test::FolderTest {
protected:
  void
  SetUp() override
  {
    FolderTest::SetUp();
    pcl::PointCloud<pcl::PointXYZ> cloud;
    for (const auto& point : test::twoRooms().points)
      cloud.emplace_back(point.x(), point.y(), point.z());
    pcl::io::savePCDFileBinary(path("in.pcd"), cloud);
  }

  int
  run(const std::string& tool, const std::string& arguments) const
  {
    return test::runTool(tool, path("in.pcd") + " " + arguments, path("said"));
  }

  /** Does each point have the colour of its label? PCL's readers say. */
  template <typename Reader>
  void
  expectColors(const std::string& name, const std::string& field) const
  {
    const auto labels = readLabels(loadCloud(path(name)), field);
    pcl::PointCloud<pcl::PointXYZRGB> cloud;
    ASSERT_EQ(Reader().read(path(name), cloud), 0) << name;
    ASSERT_EQ(cloud.size(), labels.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const auto color = labelColor(labels[i]);
      ASSERT_EQ(cloud[i].getRGBVector3i(),
                Eigen::Vector3i(color.red, color.green, color.blue))
          << name << " " << i;
    }
  }
};

} // namespace

TEST_F(OutputResults, CloudsOpenInTheColoursOfWhatWasFound)
{
  ASSERT_EQ(run("pcl_room_segmentation", path("rooms.pcd")), 0);
  expectColors<pcl::PCDReader>("rooms.pcd", "room");
  ASSERT_EQ(run("pcl_noise_resilient_lccp", path("objects.ply")), 0);
  expectColors<pcl::PLYReader>("objects.ply", "object");
  ASSERT_EQ(run("pcl_indoor_pipeline", path("out") + " -model none"), 0);
  expectColors<pcl::PCDReader>("out/cloud.pcd", "object");
  ASSERT_EQ(run("pcl_indoor_pipeline", path("out") + " -colour room"), 0);
  expectColors<pcl::PCDReader>("out/cloud.pcd", "room");
  ASSERT_EQ(run("pcl_indoor_pipeline", path("out") + " -colour none"), 0);
  EXPECT_FALSE(hasField(loadCloud(path("out/cloud.pcd")).cloud, "rgb"));
  EXPECT_NE(run("pcl_indoor_pipeline", path("out") + " -model none -colour class"), 0);
}

TEST_F(OutputResults, TablesSumTheSceneUp)
{
  ASSERT_EQ(run("pcl_indoor_pipeline", path("out")), 0);
  const auto said = bytesOf(path("said"));
  EXPECT_NE(said.find("\n" + path("out") + ": 1 storey, 2 rooms, "), std::string::npos)
      << said;
  for (const char* part : {"\nstorey  rooms  area, m^2  objects\n     0      2 ",
                           "\nclass ",
                           "\nSegmenting rooms ",
                           "\nFinding objects ",
                           "\nall "})
    EXPECT_NE(said.find(part), std::string::npos) << part << said;
  ASSERT_EQ(run("pcl_indoor_pipeline", path("out") + " -quiet"), 0);
  EXPECT_TRUE(bytesOf(path("said")).empty() || !canRasterise());
}

TEST_F(OutputResults, ResultsOfAnEarlierRunDoNotStay)
{
  ASSERT_EQ(run("pcl_indoor_pipeline", path("out")), 0);
  std::ofstream(path("out/notes.txt")) << "of the user";
  EXPECT_EQ(std::filesystem::exists(path("out/classes.png")), canRasterise());
  ASSERT_EQ(run("pcl_indoor_pipeline", path("out") + " -model none"), 0);
  EXPECT_FALSE(std::filesystem::exists(path("out/classes.png")));
  EXPECT_TRUE(std::filesystem::exists(path("out/notes.txt")));
}

TEST_F(OutputResults, TheReportIsOnePageWhereItIsWanted)
{
  ASSERT_EQ(run("pcl_indoor_pipeline", path("out")), 0);
  const auto page = bytesOf(path("out/report.html"));
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u);
  EXPECT_EQ(page.substr(page.size() - 8), "</html>\n");
  for (const char* link :
       {"src=\"http", "href=\"http", "@import", "{{SCENE}}", "fetch("})
    EXPECT_EQ(page.find(link), std::string::npos) << link;
  ASSERT_EQ(run("pcl_indoor_pipeline", path("out") + " -report " + path("own.html")),
            0);
  EXPECT_FALSE(std::filesystem::exists(path("out/report.html")));
  EXPECT_EQ(bytesOf(path("own.html")).size(),
            page.size() + path("own.html").size() - 6);
  ASSERT_EQ(run("pcl_indoor_pipeline", path("none") + " -report none"), 0);
  EXPECT_FALSE(std::filesystem::exists(path("none/report.html")));
  EXPECT_NE(run("pcl_indoor_pipeline", path("no") + " -report " + path("no/no.html")),
            0);
  EXPECT_FALSE(std::filesystem::exists(path("no")));
}

TEST_F(OutputResults, AFullDiskIsSaidInOneLineAndLeavesFinishedRoomsOnly)
{
  const auto files = [&] {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path("")))
      if (entry.path().string().rfind(path("out/.unfinished"), 0) != 0 &&
          entry.path() != path("out")) // with them the same command goes on
        names.insert(entry.path().string());
    return names;
  };
  std::ofstream(path("said"));
  const auto before = files();
  const auto with_limit = [&](const std::string& tool, const std::string& arguments) {
    const std::string command = "ulimit -f 4; " + std::string(PCL_INDOOR_TOOLS) + "/" +
                                tool + " " + path("in.pcd") + " " + arguments + " 2> " +
                                path("said");
    const int status = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1) << command;
    EXPECT_NE(bytesOf(path("said")).find(": cannot be written, File too large\n"),
              std::string::npos);
    EXPECT_EQ(files(), before);
  };
  with_limit("pcl_room_segmentation", path("out.pcd") + " -json " + path("out.json"));
  with_limit("pcl_noise_resilient_lccp", path("out.ply"));
  with_limit("pcl_indoor_pipeline", path("out"));
}

TEST_F(OutputResults, EveryOutputMayBeAPipe)
{
  ASSERT_EQ(
      run("pcl_room_segmentation",
          path("file.pcd") + " -json " + path("file.json") + " -map " + path("file")),
      0);
  for (const char* name : {"pipe.pcd", "pipe.json", "pipe_rooms.svg"})
    ASSERT_EQ(mkfifo(path(name).c_str(), 0600), 0);
  std::string cloud, json, picture;
  std::thread cloud_reader([&] { cloud = bytesOf(path("pipe.pcd")); });
  std::thread json_reader([&] { json = bytesOf(path("pipe.json")); });
  std::thread picture_reader([&] { picture = bytesOf(path("pipe_rooms.svg")); });
  const int status =
      run("pcl_room_segmentation",
          path("pipe.pcd") + " -json " + path("pipe.json") + " -map " + path("pipe"));
  ASSERT_EQ(status, 0) << bytesOf(path("said"));
  cloud_reader.join();
  json_reader.join();
  picture_reader.join();
  EXPECT_EQ(cloud, bytesOf(path("file.pcd")));
  EXPECT_EQ(nlohmann::json::parse(json)["rooms"],
            nlohmann::json::parse(bytesOf(path("file.json")))["rooms"]);
  EXPECT_EQ(picture, bytesOf(path("file_rooms.svg")));
}

TEST_F(OutputResults, FormatsHoldTheSame)
{
  const std::string rooms = "pcl_room_segmentation";
  ASSERT_EQ(run(rooms, path("out.pcd")), 0);
  ASSERT_EQ(run(rooms, path("out.ply")), 0);
  ASSERT_EQ(run(rooms, path("double.ply") + " -double"), 0);
  const auto pcd = loadCloud(path("out.pcd"));
  for (const char* name : {"out.ply", "double.ply"}) {
    EXPECT_EQ(bytesOf(path(name)).substr(0, 4), "ply\n");
    const auto ply = loadCloud(path(name));
    EXPECT_EQ(readLabels(ply, "room"), readLabels(pcd, "room"));
    ASSERT_EQ(ply.points->size(), pcd.points->size());
    for (std::size_t i = 0; i < ply.points->size(); ++i)
      ASSERT_EQ((*ply.points)[i].getVector3fMap(), (*pcd.points)[i].getVector3fMap());
  }
  EXPECT_NE(bytesOf(path("double.ply")).find("property double x\n"), std::string::npos);
}
