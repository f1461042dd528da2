/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Plans of two rooms with a door between them, as SVG and DXF.
#include "pictures/floor_plan.h"

#include "pictures/plan_dxf.h"
#include "pictures/plan_svg.h"
#include "pictures/svg_raster.h"
#include "support/occurrences.h"
#include "support/png_pixels.h"

#include <gtest/gtest.h>

#include "scene/pictures/segmented_rooms.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;
using pcl::indoor::test::occurrences;
using pcl::indoor::test::segmentedRooms;

namespace {

/** Group codes with their values. */
std::vector<std::pair<int, std::string>>
readDxf(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<std::pair<int, std::string>> pairs;
  for (std::string code, value; std::getline(stream, code);) {
    EXPECT_TRUE(std::getline(stream, value));
    pairs.emplace_back(std::stoi(code), value);
  }
  return pairs;
}

} // namespace

TEST(FloorPlan, StationsAreDrawnOnTheirStorey)
{
  const ScanStations stations{{{1.0, 1.5, 1.5}, {5.0, 1.0, 1.5}, {90.0, 0.0, 1.5}}, {}};
  const auto plan =
      floorPlan(segmentBuilding(test::twoRooms().points, {}, {}, stations));
  ASSERT_EQ(plan.storeys.size(), 1u);
  ASSERT_EQ(plan.storeys[0].stations.size(), 2u); // the third stands in no room
  EXPECT_EQ(plan.storeys[0].stations[1], Eigen::Vector2d(5.0, 1.0));
  EXPECT_EQ(occurrences(planSvg(plan), "class=\"station\""), 2u);
  EXPECT_EQ(occurrences(storeySvgs(plan)[0], "class=\"station\""), 2u);
  EXPECT_EQ(occurrences(planSvg(floorPlan(segmentedRooms())), "class=\"station\""), 0u);
}

TEST(FloorPlan, OpeningsAreGapsInTheWalls)
{
  const auto plan = floorPlan(segmentedRooms());
  ASSERT_EQ(plan.storeys.size(), 1u);
  const auto& storey = plan.storeys[0];
  ASSERT_EQ(storey.rooms.size(), 2u);
  ASSERT_EQ(storey.openings.size(), 1u);
  const auto& door = storey.openings[0];
  EXPECT_TRUE(door.is_door);
  EXPECT_NEAR(std::abs(door.along.y()), 1.0, 0.05); // the wall between stands across x
  EXPECT_NEAR(door.along.dot(door.into), 0.0, 1e-9);
  EXPECT_NEAR((door.leafEnd() - door.threshold().first).norm(), door.width, 1e-9);
  const auto& smaller =
      *std::min_element(storey.rooms.begin(),
                        storey.rooms.end(),
                        [](const auto& a, const auto& b) { return a.area < b.area; });
  EXPECT_GT((smaller.place - door.middle).dot(door.into), 0.0);
  for (const auto& room : storey.rooms)
    EXPECT_EQ(room.place, widestPlace(room.rings));

  double around = 0.0, walls = 0.0;
  for (const auto& room : storey.rooms)
    for (const auto& ring : room.rings)
      for (std::size_t i = 0; i < ring.size(); ++i)
        around += (ring[(i + 1) % ring.size()] - ring[i]).norm();
  for (const auto& [begin, end] : storey.walls)
    walls += (end - begin).norm();
  EXPECT_NEAR(around - walls, 2.0 * door.width, 0.02); // a gap on each side
}

TEST(FloorPlan, RoomsHaveTheNamesOfTheirNumbers)
{
  auto plan = floorPlan(segmentedRooms());
  EXPECT_EQ(planSvg(plan).find("kitchen"), std::string::npos);
  addNames({"", "kitchen", "of no room"}, plan);
  for (const auto& room : plan.storeys[0].rooms)
    EXPECT_EQ(room.name, room.label == 2 ? "kitchen" : "");
  EXPECT_NE(planSvg(plan).find(">kitchen "), std::string::npos);
  EXPECT_EQ(planSvg(plan).find("of no room"), std::string::npos);
}

TEST(FloorPlan, NothingFoundIsAnEmptyPlan)
{
  const auto plan = floorPlan({});
  EXPECT_TRUE(plan.storeys.empty());
  EXPECT_EQ(planSvg(plan).substr(0, 4), "<svg");
  EXPECT_EQ(readDxf(planDxf(plan)).back().second, "EOF");
}

TEST(FloorPlan, DrawingsShowRoomsDoorsAndObjects)
{
  const PlanObject object{7, 0, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}};
  const auto plan = floorPlan(segmentedRooms(), {object});
  const auto svg = planSvg(plan);
  EXPECT_EQ(occurrences(svg, "id=\"room-"), 2u);
  EXPECT_EQ(occurrences(svg, "class=\"door\""), 1u);
  EXPECT_EQ(occurrences(svg, " m²</text>"), 2u);
  EXPECT_EQ(occurrences(svg, "id=\"scale\""), 1u);
  EXPECT_EQ(occurrences(svg, "id=\"direction\""), 1u);
  EXPECT_EQ(occurrences(svg, "data-object"), 0u);
  const auto storeys = storeySvgs(plan);
  ASSERT_EQ(storeys.size(), 1u);
  EXPECT_EQ(occurrences(storeys[0], "data-object=\"7\""), 1u);
  EXPECT_EQ(occurrences(storeys[0], "id=\"scale\""), 0u);
}

TEST(FloorPlan, DxfHoldsTheSameInPlacesOfTheScan)
{
  auto plan = floorPlan(segmentedRooms());
  plan.origin = {691000.0, 5334000.0};
  const auto pairs = readDxf(planDxf(plan));
  std::map<std::string, std::size_t> entities;
  double least_x = 1e9;
  std::string entity;
  for (const auto& [code, value] : pairs) {
    if (code == 0)
      ++entities[entity = value];
    if (code == 10 && entity == "VERTEX")
      least_x = std::min(least_x, std::stod(value));
  }
  EXPECT_EQ(entities["SECTION"], 3u);
  EXPECT_EQ(entities["ENDSEC"], 3u);
  EXPECT_EQ(entities["LAYER"], 4u);
  EXPECT_EQ(entities["POLYLINE"], 2u);
  EXPECT_EQ(entities["SEQEND"], 2u);
  EXPECT_EQ(entities["ARC"], 1u);
  EXPECT_EQ(entities["TEXT"], 4u);
  EXPECT_EQ(entities["LINE"], plan.storeys[0].walls.size() + 2);
  EXPECT_NEAR(least_x, plan.box.min().x() + 691000.0, 1e-3);
  EXPECT_EQ(pairs.back(), std::make_pair(0, std::string("EOF")));
}

TEST(FloorPlan, WallsAreGreyBesideDoorsAndWindowsLieAcrossThem)
{
  auto plan = floorPlan(segmentedRooms());
  const auto before = occurrences(planSvg(plan), "class=\"");
  const auto& door = plan.storeys[0].openings.at(0);
  BuildingModel model;
  model.walls.resize(2);
  model.walls[0].begin = door.middle - 2.0 * door.along;
  model.walls[0].end = door.middle + 2.0 * door.along;
  model.walls[0].thickness = 0.2;
  model.walls[1] = model.walls[0]; // of which one side was seen
  model.walls[1].thickness = 0.0;
  ModelOpening window;
  window.kind = ModelOpeningKind::Window;
  window.along = door.along;
  window.width = 0.8;
  model.openings = {window};
  addModel(model, plan);
  const auto& storey = plan.storeys[0];
  ASSERT_EQ(storey.bodies.size(), 2u); // left and right of the door
  double length = 0.0;
  for (const auto& body : storey.bodies) {
    length += (body.axis.second - body.axis.first).norm();
    const auto corners = body.corners();
    EXPECT_NEAR((corners[3] - corners[0]).norm(), 0.2, 1e-9);
  }
  EXPECT_NEAR(length, 4.0 - door.width, 1e-9);
  ASSERT_EQ(storey.windows.size(), 1u);
  const auto corners = storey.windows[0].corners();
  EXPECT_NEAR((corners[1] - corners[0]).norm(), 0.8, 1e-9);
  EXPECT_NEAR((corners[3] - corners[0]).norm(), 0.2, 1e-9); // as thick as its wall
  EXPECT_EQ(occurrences(planSvg(plan), "class=\""), before + 2);
  EXPECT_EQ(readDxf(planDxf(plan)).size(),
            readDxf(planDxf(floorPlan(segmentedRooms()))).size() + 5 * 8);
}

TEST(FloorPlan, PngShowsTheWallsOfTheSvg)
{
  if (!canRasterise())
    GTEST_SKIP() << "built without librsvg";
  const auto files =
      rasterised({{"plan.png", planSvg(floorPlan(segmentedRooms()))}}).get();
  const auto drawing = test::readPng(files.at(0).second);
  const int walls = drawing.count(
      [](unsigned pixel) { return pixel < 0x606060u && (pixel & 0xFFu) < 0x60u; });
  EXPECT_GT(walls, 2000);
  EXPECT_LT(walls, drawing.width * drawing.height / 10);
}
