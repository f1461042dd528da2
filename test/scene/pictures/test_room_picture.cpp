/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// The maps of two rooms, as they come out as PNG.
#include "pictures/room_picture.h"

#include "pictures/svg_raster.h"
#include "support/png_pixels.h"

#include <gtest/gtest.h>

#include "scene/pictures/segmented_rooms.h"

using namespace pcl::indoor;
using namespace pcl::indoor::tool;
using pcl::indoor::test::segmentedRooms;

namespace {

test::Pixels
pixelsOf(const SvgDrawing& drawing)
{
  return test::readPng(rasterised({{"a", drawing.str(), 1.0}}).get().at(0).second);
}

int
countOf(const test::Pixels& pixels, Color color)
{
  return pixels.count([&](unsigned pixel) { return pixel == test::rgb(color); });
}

} // namespace

TEST(RoomPicture, PixelsOfARoomHaveExactlyItsColour)
{
  if (!canRasterise())
    GTEST_SKIP() << "built without librsvg";
  const auto& building = segmentedRooms();
  const auto& map = building.maps.at(0);
  const auto pixels = pixelsOf(drawRooms(building));
  constexpr int square = 12 * 12;
  for (std::int32_t label = 1; label <= map.room_count; ++label) {
    int expected = 0;
    for (int x = 0; x < map.labels.nx; ++x)
      for (int y = 0; y < map.labels.ny; ++y)
        expected += map.labels.at(x, y) == label && map.blocked.at(x, y) == 0;
    const auto room = building.room_of[0][static_cast<std::size_t>(label)];
    const int drawn = countOf(pixels, labelColor(room));
    EXPECT_LE(drawn, square * expected); // its number and the door lie upon it
    EXPECT_GT(drawn, square * expected - 3000);
  }
  EXPECT_EQ(countOf(pixels, labelColor(3)), 0);
}

TEST(RoomPicture, TheFieldIsLightInTheMiddleAndSaysItsRange)
{
  const auto drawing = drawPotentialField(segmentedRooms());
  EXPECT_NE(drawing.str().find("id=\"scale\""), std::string::npos);
  EXPECT_NE(drawing.str().find("1.5 m</text>"), std::string::npos);
  if (!canRasterise())
    GTEST_SKIP() << "built without librsvg";
  const auto pixels = pixelsOf(drawing);
  EXPECT_GT(countOf(pixels, heatColor(1.0)), 12 * 12 - 1);
  EXPECT_GT(countOf(pixels, heatColor(0.0)), 100 * 12 * 12);
}

TEST(RoomPicture, StoreysLieBelowEachOtherWithTheirNames)
{
  auto building = segmentedRooms();
  const auto one = drawRooms(building);
  EXPECT_EQ(one.str().find("Storey"), std::string::npos);
  building.maps.push_back(building.maps[0]);
  building.room_of.push_back(building.room_of[0]);
  const auto two = drawRooms(building);
  EXPECT_LT(two.str().find("Storey 1"), two.str().find("Storey 0"));
  EXPECT_GT(two.height(), 1.9 * one.height() - 40.0);
  for (int storey = 2; storey < 40; ++storey) {
    building.maps.push_back(building.maps[0]);
    building.room_of.push_back(building.room_of[0]);
  }
  EXPECT_LT(drawRooms(building).height(), 12000.0); // smaller squares
}

TEST(RoomPicture, NothingFoundIsAnEmptyMap)
{
  EXPECT_NE(drawRooms({}).str().find("<svg"), std::string::npos);
  EXPECT_NE(drawPotentialField({}).str().find("<svg"), std::string::npos);
}
