/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Runs the installed-like tools, found by PCL_INDOOR_TOOLS, on good input and looks at
// what they write.
#include "files/cloud_file.h"
#include "pictures/svg_raster.h"
#include "support/folder_test.h"
#include "support/run_tool.h"
#include "support/synthetic_scenes.h"

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/io/pcd_io.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <sys/wait.h> // for WIFEXITED

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <set>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

using pcl::indoor::test::bytesOf;

/** A folder of its own for each test, gone afterwards. */
class ToolResults : public pcl::indoor::test::FolderTest {
protected:
  int
  status(const std::string& tool, const std::string& arguments) const
  {
    return test::runTool(tool, arguments + " -quiet", path("said"));
  }

  /** Runs a tool; it must succeed and print nothing, or this, where no terminal is. */
  void
  run(const std::string& tool,
      const std::string& arguments,
      const std::string& said = "") const
  {
    EXPECT_EQ(status(tool, arguments), 0) << bytesOf(path("said"));
    EXPECT_EQ(bytesOf(path("said")), said) << tool << " " << arguments;
  }

  /** Runs a tool that must complain in one line and write no out.pcd. */
  void
  expectRefusal(const std::string& tool, const std::string& arguments) const
  {
    const int result = status(tool, arguments);
    EXPECT_TRUE(WIFEXITED(result) && WEXITSTATUS(result) == 1) << arguments;
    const auto said = bytesOf(path("said"));
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << arguments << said;
    EXPECT_FALSE(std::filesystem::exists(path("out.pcd"))) << arguments;
  }
};

/** Two rooms with a door, a table and a cabinet; an intensity per point, and some
 * points without a place. */
pcl::PointCloud<pcl::PointXYZI>
scanOfTwoRooms()
{
  const auto scene = test::twoRooms();
  pcl::PointCloud<pcl::PointXYZI> cloud;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    pcl::PointXYZI point;
    point.getVector3fMap() = scene.points[i];
    point.intensity = static_cast<float>(i % 1000);
    if (i % 100 == 7)
      point.y = std::numeric_limits<float>::quiet_NaN();
    cloud.push_back(point);
  }
  cloud.is_dense = false;
  cloud.sensor_origin_ = Eigen::Vector4f(1, 1, 1.5f, 0);
  return cloud;
}

/** The top of a table with four times three boxes of 16 x 14 cm, 7 to 18 cm high and 4
 * cm apart, as scanned from all sides; intensity 1 in the middle of the boxes' tops. */
pcl::PointCloud<pcl::PointXYZI>
tableWithTwelveBoxes()
{
  constexpr float spacing = 0.006f;
  const auto height = [](int box) { return 0.07f + 0.01f * static_cast<float>(box); };
  const Eigen::Vector2f half(0.08f, 0.07f);
  std::mt19937 rng(1);
  std::normal_distribution<float> noise(0, 0.001f);
  pcl::PointCloud<pcl::PointXYZI> cloud;
  const auto add = [&](float x, float y, float z, bool is_middle) {
    pcl::PointXYZI point(is_middle ? 1.0f : 0.0f);
    point.getVector3fMap() =
        Eigen::Vector3f(x + noise(rng), y + noise(rng), z + noise(rng));
    cloud.push_back(point);
  };
  for (int i = 0; i < 160; ++i)
    for (int j = 0; j < 110; ++j) {
      const float x = spacing * static_cast<float>(i),
                  y = spacing * static_cast<float>(j);
      const Eigen::Vector2f in_box = // of boxes every 20 and 18 cm, from their middles
          Eigen::Vector2f(std::fmod(x, 0.2f) - 0.1f, std::fmod(y, 0.18f) - 0.09f)
              .cwiseAbs();
      const bool is_box =
          x < 0.8f && y < 0.54f && (in_box.array() < half.array()).all();
      const int box = static_cast<int>(x / 0.2f) + 4 * static_cast<int>(y / 0.18f);
      add(x, y, is_box ? height(box) : 0, is_box && in_box.maxCoeff() < 0.04f);
    }
  for (int box = 0; box < 12; ++box)
    for (float z = spacing; z < height(box); z += spacing)
      for (float along = -1; along <= 1; along += 0.08f)
        for (const float side : {-1.0f, 1.0f}) {
          const Eigen::Vector2f middle(0.1f + 0.2f * static_cast<float>(box % 4),
                                       0.09f + 0.18f * static_cast<float>(box / 4));
          add(middle.x() + side * half.x(), middle.y() + along * half.y(), z, false);
          add(middle.x() + along * half.x(), middle.y() + side * half.y(), z, false);
        }
  return cloud;
}

/** What a point of scanOfTwoRooms() belongs to: 0 to 3 as in the field structure; none
 * where other surfaces are near. */
std::optional<std::uint32_t>
structureAt(const Eigen::Vector3f& point)
{
  const float near = 0.15f;
  const auto is_at = [&](int axis, float place) {
    return std::abs(point[axis] - place) < near;
  };
  const Eigen::AlignedBox3f table(Eigen::Vector3f(1, 1, 0),
                                  Eigen::Vector3f(2.4f, 1.8f, 0.75f));
  const Eigen::AlignedBox3f cabinet(Eigen::Vector3f(5.5f, 2.4f, 0),
                                    Eigen::Vector3f(6.7f, 2.9f, 1.8f));
  std::vector<std::uint32_t> kinds;
  if (is_at(2, 0.0f))
    kinds.push_back(1);
  for (const float x : {0.0f, 4.05f, 7.1f})
    if (is_at(0, x))
      kinds.push_back(2);
  for (const float y : {0.0f, 3.0f})
    if (is_at(1, y))
      kinds.push_back(2);
  if (is_at(2, 2.5f))
    kinds.push_back(3);
  for (const auto& furniture : {table, cabinet})
    if (furniture.exteriorDistance(point) < near)
      kinds.push_back(0);
  return kinds.size() == 1 ? std::optional(kinds.front()) : std::nullopt;
}

void
expectTrueStructure(const pcl::PointCloud<pcl::PointXYZI>& cloud,
                    const std::vector<std::uint32_t>& structure)
{
  ASSERT_EQ(structure.size(), cloud.size());
  std::array<std::size_t, 4> judged{}, wrong{};
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!pcl::isFinite(cloud[i])) {
      EXPECT_EQ(structure[i], 0u) << i;
    }
    else if (const auto expected = structureAt(cloud[i].getVector3fMap())) {
      ++judged[*expected];
      wrong[*expected] += structure[i] != *expected;
    }
  }
  for (std::size_t kind = 0; kind < 4; ++kind) {
    EXPECT_GT(judged[kind], 1000u) << kind;
    EXPECT_LE(wrong[kind], judged[kind] / 1000) << kind << " of " << judged[kind];
  }
}

void
expectEveryFinitePointHas(const CloudFile& file, const std::string& field)
{
  const auto labels = readLabels(file, field);
  std::size_t without = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (pcl::isFinite((*file.points)[i]))
      without += labels[i] == 0;
    else
      EXPECT_EQ(labels[i], 0u) << field << " of point " << i;
  }
  EXPECT_EQ(without, 0u) << field;
}

} // namespace

TEST_F(ToolResults, RoomSegmentationAddsTheRoomAndKeepsTheRest)
{
  pcl::io::savePCDFileBinary(path("in.pcd"), scanOfTwoRooms());
  run("pcl_room_segmentation", path("in.pcd") + " " + path("out.pcd"));
  const auto in = loadCloud(path("in.pcd"));
  const auto out = loadCloud(path("out.pcd"));
  expectEveryFinitePointHas(out, "room");
  EXPECT_EQ(readLabels(out, "intensity"), readLabels(in, "intensity"));
  EXPECT_EQ(out.pose.origin, in.pose.origin);
  const auto rooms = readLabels(out, "room");
  EXPECT_EQ(*std::max_element(rooms.begin(), rooms.end()), 2u);
}

TEST_F(ToolResults, NoiseResilientLccpAddsTheObjectAndKeepsTheRest)
{
  pcl::io::savePCDFileBinary(path("in.pcd"), scanOfTwoRooms());
  for (const char* partition : {"graph", "lccp"}) {
    run("pcl_noise_resilient_lccp",
        path("in.pcd") + " " + path("out.pcd") +
            " -voxel_resolution 0.06 -seed_resolution 0.24 -partition " + partition);
    const auto out = loadCloud(path("out.pcd"));
    expectEveryFinitePointHas(out, "object");
    EXPECT_EQ(readLabels(out, "intensity"),
              readLabels(loadCloud(path("in.pcd")), "intensity"));
  }
}

TEST_F(ToolResults, NoiseResilientLccpPresetsSetTheirOptions)
{
  pcl::io::savePCDFileBinary(path("in.pcd"), scanOfTwoRooms());
  const auto objects = [&](const std::string& options) {
    run("pcl_noise_resilient_lccp", path("in.pcd") + " " + path("out.pcd") + options);
    return readLabels(loadCloud(path("out.pcd")), "object");
  };
  EXPECT_EQ(objects(" -preset objects"), objects(""));
  EXPECT_NE(objects(" -preset thesis"), objects(""));
  EXPECT_EQ(objects(" -preset thesis"),
            objects(" -preset thesis -partition felzenszwalb"));
  objects(" -preset parts");
  expectEveryFinitePointHas(loadCloud(path("out.pcd")), "object");
}

TEST_F(ToolResults, NoiseResilientLccpTellsColoursApart)
{
  pcl::PointCloud<pcl::PointXYZRGB> plate; // red and blue halves, in two spellings
  for (int x = 0; x < 84; ++x)
    for (int y = 0; y < 36; ++y) {
      const std::uint8_t red = x < 42 ? 200 : 0;
      plate.push_back({0.01f * static_cast<float>(x),
                       0.01f * static_cast<float>(y),
                       0.0f,
                       red,
                       0,
                       static_cast<std::uint8_t>(200 - red)});
    }
  pcl::PointCloud<pcl::PointXYZRGBA> other_field;
  pcl::copyPointCloud(plate, other_field);
  pcl::io::savePCDFileBinary(path("rgb.pcd"), plate);
  pcl::io::savePCDFileBinary(path("rgba.pcd"), other_field);
  const auto one = " All 3024 points are one segment: "; // which is said
  const auto count = [&](const std::string& input, const std::string& options) {
    EXPECT_EQ(status("pcl_noise_resilient_lccp",
                     path(input) + " " + path("out.pcd") +
                         " -preset thesis -ransac_share 0 -graph_scale 0.3" + options),
              0)
        << options;
    const auto objects = readLabels(loadCloud(path("out.pcd")), "object");
    std::set<std::uint32_t> found; // not at the border of the halves
    for (std::size_t k = 0; k < objects.size(); ++k)
      if (k / 36 < 36 || k / 36 >= 48)
        found.insert(objects[k]);
    EXPECT_EQ(bytesOf(path("said")).find(one) != std::string::npos, found.size() == 1);
    return found.size();
  };
  EXPECT_EQ(count("rgb.pcd", ""), 1u);
  EXPECT_EQ(count("rgb.pcd", " -fpfh_weight 1"), 1u);
  EXPECT_EQ(count("rgb.pcd", " -colour_weight 1"), 2u);
  EXPECT_EQ(count("rgba.pcd", " -colour_weight 1 -fpfh_weight 1"), 2u);
  EXPECT_GT(count("rgb.pcd", " -spatial_weight 20"), 2u) << "far from each other";
  pcl::PointCloud<pcl::PointXYZ> plain;
  pcl::copyPointCloud(plate, plain);
  pcl::io::savePCDFileBinary(path("plain.pcd"), plain);
  std::filesystem::remove(path("out.pcd"));
  expectRefusal("pcl_noise_resilient_lccp",
                path("plain.pcd") + " " + path("out.pcd") +
                    " -preset thesis -colour_weight 1");
  EXPECT_NE(bytesOf(path("said")).find("no colours"), std::string::npos);
}

TEST_F(ToolResults, NoiseResilientLccpTellsObjectsOnATableApartFromAnySide)
{
  const auto cloud = tableWithTwelveBoxes();
  pcl::io::savePCDFileBinary(path("in.pcd"), cloud);
  const auto run_with = [&](const std::string& options) {
    EXPECT_EQ(test::runTool("pcl_noise_resilient_lccp",
                            path("in.pcd") + " " + path("out.pcd") + options,
                            path("said")),
              0)
        << options;
    const auto objects = readLabels(loadCloud(path("out.pcd")), "object");
    std::set<std::uint32_t> on_boxes; // in the middle of their tops
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (cloud[i].intensity > 0)
        on_boxes.insert(objects[i]);
    return on_boxes.size();
  };
  const char* line = "no larger than what stands on a table";
  EXPECT_GE(run_with(" -quiet"), 10u);
  EXPECT_NE(bytesOf(path("said")).find(line), std::string::npos);
  EXPECT_GE(run_with(" -preset single_view"), 10u);
  EXPECT_EQ(bytesOf(path("said")).find(line), std::string::npos);
  EXPECT_LE(run_with(" -preset objects"), 2u) << "as furniture of a room";
}

TEST_F(ToolResults, NoiseResilientLccpRefusesWrongLevels)
{
  pcl::io::savePCDFileBinary(path("in.pcd"), scanOfTwoRooms());
  for (const char* level : {"1.01", "-1.01", "-0.5", "nan"}) {
    expectRefusal("pcl_noise_resilient_lccp",
                  path("in.pcd") + " " + path("out.pcd") + " -level " + level);
    EXPECT_NE(bytesOf(path("said")).find("-level: "), std::string::npos) << level;
  }
}

TEST_F(ToolResults, NoiseResilientLccpTellsTheStructureOfARoom)
{
  for (const bool is_first : {true, false}) {
    auto cloud = scanOfTwoRooms();
    for (auto& point : cloud)
      if ((point.x < 4.05f) != is_first)
        point.x = std::numeric_limits<float>::quiet_NaN();
    pcl::io::savePCDFileBinary(path("in.pcd"), cloud);
    run("pcl_noise_resilient_lccp", path("in.pcd") + " " + path("out.pcd"));
    expectTrueStructure(cloud, readLabels(loadCloud(path("out.pcd")), "structure"));
  }
}

TEST_F(ToolResults, PipelineNumbersObjectsThroughTheRooms)
{
  pcl::io::savePCDFileBinary(path("in.pcd"), scanOfTwoRooms());
  run("pcl_indoor_pipeline", path("in.pcd") + " " + path("a/b"));
  const auto out = loadCloud(path("a/b/cloud.pcd"));
  expectEveryFinitePointHas(out, "room");
  expectEveryFinitePointHas(out, "object");
  EXPECT_TRUE(hasField(out.cloud, "intensity"));

  const auto rooms = readLabels(out, "room");
  const auto objects = readLabels(out, "object");
  std::map<std::uint32_t, std::set<std::uint32_t>> rooms_of_object;
  for (std::size_t i = 0; i < rooms.size(); ++i)
    if (objects[i] > 0)
      rooms_of_object[objects[i]].insert(rooms[i]);
  ASSERT_GT(rooms_of_object.size(), 10u); // two times six sides, a table, a cabinet
  std::uint32_t number = 0, room = 0;
  for (const auto& [object, its_rooms] : rooms_of_object) {
    EXPECT_EQ(object, ++number);
    ASSERT_EQ(its_rooms.size(), 1u) << "object " << object << " lies in several rooms";
    EXPECT_GE(*its_rooms.begin(), room);
    room = *its_rooms.begin();
  }
  EXPECT_EQ(room, 2u);
}

TEST_F(ToolResults, PipelineDescribesTheSceneThatItWrites)
{
  pcl::io::savePCDFileBinary(path("in.pcd"), scanOfTwoRooms());
  run("pcl_indoor_pipeline", path("in.pcd") + " " + path("out"));
  const auto out = loadCloud(path("out/cloud.pcd"));
  const auto objects = readLabels(out, "object");
  const auto scene = nlohmann::json::parse(bytesOf(path("out/scene.json")));
  EXPECT_EQ(scene["points"], out.points->size());
  EXPECT_EQ(scene["finite_points"], out.finite_count);
  ASSERT_EQ(scene["rooms"].size(), 2u);
  std::multiset<double> areas;
  std::size_t listed = 0;
  for (const auto& room : scene["rooms"]) {
    areas.insert(room["area"].get<double>());
    EXPECT_NEAR(room["height"].get<double>(), 2.5, 0.3); // three voxels
    listed += room["objects"].size();
    EXPECT_EQ(room["footprint"].at(0).size(), 4u);
    ASSERT_EQ(room["neighbours"].size(), 1u);
    EXPECT_NE(room["neighbours"][0]["room"], room["room"]);
  }
  EXPECT_NEAR(*areas.begin(), 9.0, 1.5); // a voxel on every side
  EXPECT_NEAR(*areas.rbegin(), 12.0, 1.5);
  EXPECT_EQ(listed, scene["objects"].size());
  for (const auto& object : scene["objects"]) {
    const auto id = object["object"].get<std::uint32_t>();
    EXPECT_EQ(object["points"], std::count(objects.begin(), objects.end(), id));
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(object["box"]["lower"][axis], object["centroid"][axis]);
      EXPECT_LE(object["centroid"][axis], object["box"]["upper"][axis]);
    }
  }
  for (const char* picture : {"out/rooms.png", "out/potential_field.png"})
    EXPECT_EQ(bytesOf(path(picture)).substr(0, 4), canRasterise() ? "\x89PNG" : "");
}

TEST_F(ToolResults, PipelineTellsTheStructureOfPointsAndObjectsAlike)
{
  const auto cloud = scanOfTwoRooms();
  pcl::io::savePCDFileBinary(path("in.pcd"), cloud);
  run("pcl_indoor_pipeline", path("in.pcd") + " " + path("out"));
  const auto out = loadCloud(path("out/cloud.pcd"));
  const auto objects = readLabels(out, "object");
  const auto structure = readLabels(out, "structure");
  const auto scene = nlohmann::json::parse(bytesOf(path("out/scene.json")));
  const std::vector<std::string> names = {"none", "floor", "wall", "ceiling"};
  for (std::size_t i = 0; i < objects.size(); ++i) {
    ASSERT_LT(structure[i], names.size());
    const auto name =
        objects[i] == 0 ? names[0]
                        : scene["objects"][objects[i] - 1].value("structure", names[0]);
    ASSERT_EQ(name, names[structure[i]]) << "object " << objects[i];
  }
  expectTrueStructure(cloud, structure);
}

TEST_F(ToolResults, PipelineGivesTheSameForAnyNumberOfThreadsAndReplacesOldResults)
{
  pcl::io::savePCDFileBinary(path("in.pcd"), scanOfTwoRooms());
  run("pcl_indoor_pipeline", path("in.pcd") + " " + path("one") + " -threads 1");
  std::filesystem::create_directories(path("three"));
  std::ofstream(path("three/cloud.pcd")) << "old";
  run("pcl_indoor_pipeline", path("in.pcd") + " " + path("three") + " -threads 3");
  for (const char* name : {"cloud.pcd",
                           "scene.json",
                           "report.html",
                           "plan.svg",
                           "plan.png",
                           "plan.dxf",
                           "rooms.png",
                           "potential_field.png",
                           "classes.png"})
    EXPECT_EQ(bytesOf(path("one/") + name), bytesOf(path("three/") + name)) << name;
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("three")), {}),
            canRasterise() ? 9 : 5);
}

TEST_F(ToolResults, PipelineKeepsLargeCoordinatesAndTheirLabels)
{
  const auto cloud = scanOfTwoRooms();
  const Eigen::Vector3d shift(691000.0, 5334000.0, 512.0);
  const auto write = [&](const std::string& name, const Eigen::Vector3d& offset) {
    std::ofstream stream(path(name));
    stream << "ply\nformat ascii 1.0\nelement vertex " << cloud.size()
           << "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    stream.precision(17);
    for (const auto& point : cloud) {
      const Eigen::Vector3d place = point.getVector3fMap().cast<double>() + offset;
      stream << place.x() << " " << place.y() << " " << place.z() << "\n";
    }
  };
  write("near.ply", Eigen::Vector3d::Zero());
  write("far.ply", shift);
  const auto note = [&](const std::string& name, const std::string& offset) {
    return "Note: " + path(name + "/cloud.pcd") + ": x, y, z are floats" + offset +
           "; -double writes doubles\n";
  };
  run("pcl_indoor_pipeline", path("near.ply") + " " + path("near"), note("near", ""));
  run("pcl_indoor_pipeline",
      path("far.ply") + " " + path("far"),
      note("far", ", to which the offset 691003 5334001 0 has to be added"));
  const auto near = loadCloud(path("near/cloud.pcd"));
  const auto far = loadCloud(path("far/cloud.pcd"));
  EXPECT_EQ(readLabels(near, "room"), readLabels(far, "room"));
  EXPECT_GT(far.offset.x(), 600000.0);
  const auto scene = nlohmann::json::parse(bytesOf(path("far/scene.json")));
  EXPECT_NEAR(scene["rooms"][0]["box"]["lower"][0].get<double>(), shift.x(), 8.0);
  EXPECT_EQ(scene["offset"], nlohmann::json({691003.0, 5334001.0, 0.0}));
  pcl::PointCloud<pcl::PointXYZRGB> seen; // by PCL's own reader
  ASSERT_EQ(pcl::io::loadPCDFile(path("far/cloud.pcd"), seen), 0);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (pcl::isFinite(cloud[i])) {
      EXPECT_NEAR(seen[i].x + 691003.0, cloud[i].x + shift.x(), 1e-6);
      EXPECT_NEAR(seen[i].z, cloud[i].z + shift.z(), 1e-4);
    }
}

TEST_F(ToolResults, PipelineKeepsTheArrangementOfOrganisedClouds)
{
  auto cloud = scanOfTwoRooms();
  cloud.resize(cloud.size() / 100 * 100);
  cloud.width = 100;
  cloud.height = static_cast<std::uint32_t>(cloud.size() / 100);
  pcl::io::savePCDFileBinaryCompressed(path("in.pcd"), cloud);
  run("pcl_indoor_pipeline", path("in.pcd") + " " + path("out"));
  const auto out = loadCloud(path("out/cloud.pcd"));
  EXPECT_EQ(out.cloud.width, 100u);
  EXPECT_EQ(out.cloud.height, cloud.height);
  expectEveryFinitePointHas(out, "object");
}
