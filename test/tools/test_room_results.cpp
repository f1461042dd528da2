/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Runs pcl_room_segmentation on the simulated flat and looks at the maps and the JSON
// file that it writes.
#include "files/cloud_file.h"
#include "pictures/svg_raster.h"
#include "support/folder_test.h"
#include "support/occurrences.h"
#include "support/run_tool.h"

#include <pcl/conversions.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

using namespace pcl::indoor::tool;

namespace {

using pcl::indoor::test::bytesOf;
using pcl::indoor::test::occurrences;

/** The flat: a living room of 4.8 x 3.8 m, a bedroom of 3.3 x 3.8 m, a hallway of
 * 8.3 x 1.6 m between the walls' faces; the hallway has a door to each. */
struct SimulatedFlat {
  static bool
  make(const std::string& folder)
  {
    return pcl::indoor::test::runTool("pcl_scan_simulation",
                                      PCL_INDOOR_PLANS "/flat.json " + folder +
                                          "/flat.pcd -quiet") == 0;
  }
};

class RoomResults : public pcl::indoor::test::PreparedFolderTest<SimulatedFlat> {
protected:
  int
  run(const std::string& tool, const std::string& arguments) const
  {
    return pcl::indoor::test::runTool(tool, arguments + " -quiet", path("said"));
  }
};

double
areaOf(const nlohmann::json& lines)
{
  double twice = 0.0;
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) {
      const auto& next = line[(i + 1) % line.size()];
      twice += line[i][0].get<double>() * next[1].get<double>() -
               next[0].get<double>() * line[i][1].get<double>();
    }
  return 0.5 * twice;
}

} // namespace

TEST_F(RoomResults, JsonDescribesTheFlat)
{
  ASSERT_EQ(run("pcl_room_segmentation",
                path("flat.pcd") + " " + path("out.pcd") + " -json " + path("r.json")),
            0)
      << bytesOf(path("said"));
  const auto json = nlohmann::json::parse(bytesOf(path("r.json")));
  ASSERT_EQ(json["rooms"].size(), 3u);
  const auto labels = readLabels(loadCloud(path("out.pcd")), "room");
  std::multiset<double> areas;
  std::multiset<std::size_t> neighbours;
  for (const auto& room : json["rooms"]) {
    const double area = room["area"];
    areas.insert(area);
    neighbours.insert(room["neighbours"].size());
    EXPECT_EQ(room["points"], std::count(labels.begin(), labels.end(), room["room"]));
    EXPECT_EQ(room["storey"], 0);
    EXPECT_NEAR(room["height"].get<double>(), 2.6, 0.15); // a voxel and a half
    EXPECT_NEAR(
        room["volume"].get<double>(), area * room["height"].get<double>(), 0.01);
    EXPECT_NEAR(areaOf(room["footprint"]), area, 0.02 * area);
    for (const auto& neighbour : room["neighbours"]) {
      EXPECT_NE(neighbour["room"], room["room"]);
      EXPECT_NEAR(neighbour["position"][1].get<double>(), 4.0, 0.15);
      // the doors are 0.9 m wide; each post and the open leaf may cover a voxel
      EXPECT_GE(neighbour["width"].get<double>(), 0.55);
      EXPECT_LE(neighbour["width"].get<double>(), 1.05);
    }
  }
  // a voxel less at each wall of two; a lamp at the ceiling of the largest
  const double truth[] = {3.3 * 3.8, 8.3 * 1.6, 4.8 * 3.8};
  std::size_t i = 0;
  for (const double area : areas) {
    EXPECT_LT(area, truth[i] * 1.02);
    EXPECT_GT(area, truth[i] * 0.88);
    ++i;
  }
  EXPECT_EQ(neighbours, (std::multiset<std::size_t>{1, 1, 2}));
}

TEST_F(RoomResults, TheFieldMethodTakesItsOptions)
{
  const auto rooms = [this](const std::string& options) {
    EXPECT_EQ(run("pcl_room_segmentation",
                  path("flat.pcd") + " " + path("out.pcd") + " -method field -json " +
                      path("r.json") + options),
              0)
        << bytesOf(path("said"));
    return nlohmann::json::parse(bytesOf(path("r.json")))["rooms"].size();
  };
  for (const char* size : {"0.1", "0.15", "0.2"})
    EXPECT_EQ(
        rooms(std::string(" -interior_voxel_size ") + size + " -voxel_size " + size),
        3u)
        << size;
  EXPECT_EQ(rooms(" -visibility_weight 0"), 3u);
  EXPECT_EQ(rooms(" -field_weight 0"), 3u);
  // all distances are at most the sum of the weights, 1; the rooms' pieces nearer
  EXPECT_EQ(rooms(" -dbscan_distance 0.25"), 3u);
  EXPECT_EQ(rooms(" -dbscan_distance 1.1"), 1u);
  EXPECT_EQ(rooms(" -dbscan_distance 25 -euclidean_weight 70 -field_weight 25 "
                  "-visibility_weight 5"),
            3u);
}

TEST_F(RoomResults, MapsShowRoomsDoorsAndScale)
{
  ASSERT_EQ(run("pcl_room_segmentation",
                path("flat.pcd") + " " + path("out.pcd") + " -map " + path("m")),
            0)
      << bytesOf(path("said"));
  for (const char* picture : {"m_rooms.png", "m_field.png", "m_plan.png"})
    EXPECT_EQ(bytesOf(path(picture)).substr(0, 4), canRasterise() ? "\x89PNG" : "");
  const auto svg = bytesOf(path("m_rooms.svg"));
  EXPECT_EQ(svg.substr(0, 4), "<svg");
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  EXPECT_EQ(occurrences(svg, "<g id=\"storey-"), 1u);
  EXPECT_EQ(occurrences(svg, "<path id=\"room-"), 3u);
  EXPECT_EQ(occurrences(svg, "class=\"door\""), 2u);
  EXPECT_EQ(occurrences(svg, " m²</text>"), 3u);
  EXPECT_EQ(occurrences(svg, "class=\"walls\""), 1u);
  EXPECT_EQ(occurrences(svg, "id=\"scale\""), 1u);
}

TEST_F(RoomResults, AnyAxisMayPointUp)
{
  const auto file = loadCloud(path("flat.pcd"));
  pcl::PCLPointCloud2 lying;
  pcl::PointCloud<pcl::PointXYZ> turned;
  for (const auto& point : *file.points) // up is -y
    turned.emplace_back(point.x, -point.z, point.y);
  pcl::toPCLPointCloud2(turned, lying);
  saveCloud(path("lying.pcd"), lying);
  ASSERT_EQ(run("pcl_room_segmentation", path("flat.pcd") + " " + path("a.pcd")), 0);
  ASSERT_EQ(
      run("pcl_room_segmentation", path("lying.pcd") + " " + path("b.pcd") + " -up -y"),
      0)
      << bytesOf(path("said"));
  EXPECT_EQ(readLabels(loadCloud(path("a.pcd")), "room"),
            readLabels(loadCloud(path("b.pcd")), "room"));
}

TEST_F(RoomResults, UnitsAreNamedAndTaken)
{
  const auto file = loadCloud(path("flat.pcd"));
  pcl::PCLPointCloud2 bytes;
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (const auto& point : *file.points)
    cloud.emplace_back(1000 * point.x, 1000 * point.y, 1000 * point.z);
  pcl::toPCLPointCloud2(cloud, bytes);
  saveCloud(path("mm.pcd"), bytes);
  const auto out = " " + path("out.pcd") + " -json " + path("r.json");
  ASSERT_EQ(run("pcl_room_segmentation", path("mm.pcd") + out + " -unit m"), 0);
  EXPECT_EQ(occurrences(bytesOf(path("said")), "\n"), 2u) << bytesOf(path("said"));
  EXPECT_EQ(occurrences(bytesOf(path("said")), "probably in millimetres"), 1u);
  EXPECT_EQ(occurrences(bytesOf(path("said")), "no room was found"), 1u);
  const auto wrong = nlohmann::json::parse(bytesOf(path("r.json")));
  EXPECT_EQ(wrong["warnings"].size(), 2u);
  ASSERT_EQ(run("pcl_room_segmentation", path("mm.pcd") + out), 0);
  EXPECT_EQ(occurrences(bytesOf(path("said")), "millimetres"), 1u)
      << bytesOf(path("said"));
  const auto found = nlohmann::json::parse(bytesOf(path("r.json")));
  EXPECT_EQ(found["coordinate_unit"], "mm");
  EXPECT_EQ(found["rooms"].size(), 3u);

  ASSERT_EQ(run("pcl_room_segmentation", path("flat.pcd") + out), 0);
  const auto metres = nlohmann::json::parse(bytesOf(path("r.json")));
  ASSERT_EQ(run("pcl_room_segmentation", path("mm.pcd") + out + " -unit mm"), 0);
  EXPECT_EQ(bytesOf(path("said")), "");
  const auto json = nlohmann::json::parse(bytesOf(path("r.json")));
  EXPECT_EQ(json["unit"], "metre");
  EXPECT_EQ(json["coordinate_unit"], "mm");
  EXPECT_EQ(json["voxel_size"], 0.1);
  EXPECT_LT(json["points_outside"], file.points->size() / 100); // beyond the windows
  ASSERT_EQ(json["rooms"].size(), 3u);
  for (int i = 0; i < 3; ++i) {
    const auto& room = json["rooms"][i];
    const auto& same = metres["rooms"][i];
    EXPECT_NEAR(room["area"].get<double>(), same["area"].get<double>(), 0.01);
    EXPECT_NEAR(room["box"]["upper"][0].get<double>(),
                1000 * same["box"]["upper"][0].get<double>(),
                1.0);
  }
}

TEST_F(RoomResults, FarPointsAndAnotherFrameDoNotStopThePipeline)
{
  const auto file = loadCloud(path("flat.pcd"));
  const auto save = [&](const std::string& name, double scale, bool lying, bool far) {
    pcl::PointCloud<pcl::PointXYZ> cloud;
    for (const auto& p : *file.points) {
      const Eigen::Vector3f q = static_cast<float>(scale) * p.getVector3fMap();
      if (lying) // up is y
        cloud.emplace_back(q.x(), q.z(), -q.y());
      else
        cloud.emplace_back(q.x(), q.y(), q.z());
    }
    if (far)
      // only the first is a place outside; with the others nothing can be computed
      for (const float value : {1e7f, 1e20f, std::numeric_limits<float>::max()})
        cloud.emplace_back(value, 1.0f, -value);
    pcl::PCLPointCloud2 bytes;
    pcl::toPCLPointCloud2(cloud, bytes);
    saveCloud(path(name), bytes);
  };
  const auto segmented = [&](const std::string& name, const std::string& options) {
    EXPECT_EQ(run("pcl_indoor_pipeline", path(name) + " " + path("scene") + options), 0)
        << bytesOf(path("said"));
    EXPECT_TRUE(bytesOf(path("said")).empty() || !canRasterise());
    return loadCloud(path("scene/cloud.pcd"));
  };
  save("flat_only.pcd", 1.0, false, false);
  const auto plain = segmented("flat_only.pcd", "");
  const auto rooms = readLabels(plain, "room"), objects = readLabels(plain, "object");
  const std::size_t outside =
      nlohmann::json::parse(bytesOf(path("scene/scene.json")))["points_outside"];
  EXPECT_LT(outside, rooms.size() / 100); // seen through the windows
  EXPECT_GT(*std::max_element(objects.begin(), objects.end()), 3u);

  save("far.pcd", 1.0, false, true);
  auto with_far = segmented("far.pcd", "");
  auto far_rooms = readLabels(with_far, "room"),
       far_objects = readLabels(with_far, "object");
  const auto json = nlohmann::json::parse(bytesOf(path("scene/scene.json")));
  EXPECT_EQ(json["points_outside"], outside + 1);
  for (std::size_t i = rooms.size(); i < far_rooms.size(); ++i)
    EXPECT_EQ(far_rooms[i] + far_objects[i], 0u);
  far_rooms.resize(rooms.size());
  far_objects.resize(rooms.size());
  EXPECT_EQ(far_rooms, rooms);
  EXPECT_EQ(far_objects, objects);

  save("lying.pcd", 1.0, true, false);
  EXPECT_EQ(readLabels(segmented("lying.pcd", " -up y"), "object"), objects);
  save("cm.pcd", 100.0, false, false);
  const auto other = segmented("cm.pcd", " -unit cm");
  EXPECT_EQ(readLabels(other, "room"), rooms);
}

TEST_F(RoomResults, CoarseFloatsAreWarnedOf)
{
  const auto file = loadCloud(path("flat.pcd"));
  pcl::PCLPointCloud2 bytes;
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (const auto& point : *file.points)
    cloud.emplace_back(point.x, point.y + 5.8e6f, point.z);
  pcl::toPCLPointCloud2(cloud, bytes);
  saveCloud(path("utm.pcd"), bytes);
  ASSERT_EQ(run("pcl_room_segmentation", path("utm.pcd") + " " + path("out.pcd")), 0);
  EXPECT_EQ(occurrences(bytesOf(path("said")), "\n"), 2u) << bytesOf(path("said"));
  EXPECT_EQ(occurrences(bytesOf(path("said")), "steps of 0.5 m"), 1u);
  EXPECT_EQ(occurrences(bytesOf(path("said")), "Walls were seen on only"), 1u);
  EXPECT_EQ(occurrences(bytesOf(path("said")), "no room was found"), 0u);
}
