/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/geojson_file.h"

#include "export/route_graph.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace pcl::indoor::tool;
using pcl::indoor::test::SceneJson;
using pcl::indoor::test::SmallScene;

TEST(GeoJsonFile, HasAFeatureForEachObject)
{
  const auto json = geoJson(savedScene(SmallScene::json()));
  std::map<std::string, int> kinds;
  for (const auto& feature : json["features"])
    ++kinds[feature["properties"]["kind"]];
  EXPECT_EQ(kinds,
            (std::map<std::string, int>{
                {"room", 3}, {"wall", 2}, {"door", 2}, {"window", 1}, {"object", 3}}));
  EXPECT_FALSE(json.contains("crs"));
}

TEST(GeoJsonFile, RoomsHaveTheirNamesWhereTheyAreKnown)
{
  const auto json = geoJson(savedScene(SmallScene::json()));
  EXPECT_FALSE(json["features"][0]["properties"].contains("name"));
  EXPECT_EQ(json["features"][1]["properties"]["name"], "kitchen");
  EXPECT_EQ(json["features"][1]["properties"]["name_probability"], 0.8);
  EXPECT_FALSE(json["features"][2]["properties"].contains("name"));
}

TEST(GeoJsonFile, ColumnsAreClosedRings)
{
  auto scene = SmallScene::json();
  scene["columns"] = {SmallScene::column(true)};
  const auto json = geoJson(savedScene(scene));
  for (const auto& feature : json["features"])
    if (feature["properties"]["kind"] == "column") {
      const auto& ring = feature["geometry"]["coordinates"][0];
      EXPECT_EQ(ring.size(), 25u);
      EXPECT_EQ(ring.front(), ring.back());
      EXPECT_EQ(feature["properties"]["height"], 2.5);
      return;
    }
  FAIL() << "there is no column";
}

TEST(GeoJsonFile, PlacesAreThoseOfTheFile)
{
  const auto json = geoJson(savedScene(SmallScene::json()), 25832);
  EXPECT_EQ(json["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::25832");
  const auto& rooms = json["features"];
  const auto& outer = rooms[1]["geometry"]["coordinates"][0][0];
  EXPECT_EQ(outer[0], SceneJson({104.2, 200.0, 10.0}));
  EXPECT_EQ(outer.size(), 5u); // closed
  EXPECT_EQ(outer[4], outer[0]);
  EXPECT_EQ(rooms[1]["geometry"]["coordinates"][0].size(), 2u); // with its hole
}

TEST(GeoJsonFile, WallsArePolygonsWhereTheirThicknessIsKnown)
{
  const auto json = geoJson(savedScene(SmallScene::json()));
  const auto& known = json["features"][3];
  EXPECT_EQ(known["geometry"]["type"], "Polygon");
  std::set<double> sides;
  for (const auto& corner : known["geometry"]["coordinates"][0])
    sides.insert(corner[0].get<double>());
  EXPECT_EQ(sides, (std::set<double>{104.0, 104.2}));
  EXPECT_EQ(json["features"][4]["geometry"]["type"], "LineString");
  EXPECT_FALSE(json["features"][4]["properties"].contains("thickness"));
}

TEST(RouteGraph, IsAsNav2ReadsIt)
{
  const auto graph = doorGraph(savedScene(SmallScene::json()));
  const auto json = routeGraph(graph, 0);
  std::set<std::size_t> ids, nodes;
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& feature : json["features"]) {
    const auto& properties = feature["properties"];
    EXPECT_TRUE(ids.insert(properties["id"].get<std::size_t>()).second);
    if (feature["geometry"]["type"] == "Point") {
      nodes.insert(properties["id"].get<std::size_t>());
      EXPECT_EQ(properties["frame"], "map");
      continue;
    }
    EXPECT_EQ(feature["geometry"]["type"], "MultiLineString");
    EXPECT_GT(properties["cost"].get<double>(), 0.0);
    edges.emplace(properties["startid"], properties["endid"]);
  }
  EXPECT_FALSE(edges.empty());
  for (const auto& [from, to] : edges) {
    EXPECT_EQ(nodes.count(from) + nodes.count(to), 2u);
    EXPECT_EQ(edges.count({to, from}), 1u);
  }
  EXPECT_EQ(routeGraph(graph, 1)["features"].size(), 4u); // room, stairs, both ways
}
