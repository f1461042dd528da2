/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/tool_error.h"
#include "pictures/picture.h"

#include <png.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <tuple>

using namespace pcl::indoor::tool;

namespace {

int
distance(Color a, Color b)
{
  return std::abs(a.red - b.red) + std::abs(a.green - b.green) +
         std::abs(a.blue - b.blue);
}

int
countOf(const Picture& picture, Color color)
{
  int count = 0;
  for (int x = 0; x < picture.width(); ++x)
    for (int y = 0; y < picture.height(); ++y)
      count += distance(picture.at(x, y), color) == 0;
  return count;
}

} // namespace

TEST(Picture, NearLabelsHaveDistinctColours)
{
  for (std::uint32_t a = 0; a < 200; ++a)
    for (std::uint32_t b = a + 1; b < a + 8; ++b)
      EXPECT_GT(distance(labelColor(a), labelColor(b)), 40) << a << " and " << b;
}

TEST(Picture, HeatGrowsLighterAndIsBounded)
{
  const auto light = [](Color c) { return 2 * c.red + 3 * c.green + c.blue; };
  for (int i = 0; i < 50; ++i)
    EXPECT_LT(light(heatColor(i / 50.0)), light(heatColor((i + 1) / 50.0))) << i;
  EXPECT_EQ(distance(heatColor(-3.0), heatColor(0.0)), 0);
  EXPECT_EQ(distance(heatColor(7.0), heatColor(1.0)), 0);
  EXPECT_EQ(heatColor(std::numeric_limits<double>::quiet_NaN()).red, 128);
}

TEST(Picture, DrawingOutsideIsCutOff)
{
  Picture picture(10, 5);
  picture.set(-1, 0, {0, 0, 0});
  picture.set(10, 0, {0, 0, 0});
  picture.set(0, 5, {0, 0, 0});
  EXPECT_EQ(countOf(picture, {0, 0, 0}), 0);
  picture.fillRectangle(8, 3, 5, 5, {0, 0, 0});
  EXPECT_EQ(countOf(picture, {0, 0, 0}), 4);
  picture.drawLabel(0, 0, "123456", 3); // wider than the picture
}

TEST(Picture, TextHasItsSizeAndScale)
{
  Picture picture(60, 20);
  picture.drawText(1, 1, "-", {0, 0, 0}, 2);
  EXPECT_EQ(countOf(picture, {0, 0, 0}), 5 * 4); // a row of five dots of 2 x 2
  EXPECT_EQ(Picture::textWidth("12", 3), 33);
  EXPECT_EQ(Picture::textHeight(3), 21);
  Picture small(60, 20), capital(60, 20);
  small.drawText(0, 0, "ab", {0, 0, 0});
  capital.drawText(0, 0, "AB", {0, 0, 0});
  EXPECT_EQ(countOf(small, {0, 0, 0}), countOf(capital, {0, 0, 0}));
}

TEST(Picture, APngHoldsThePixels)
{
  const auto path =
      (std::filesystem::temp_directory_path() / "pcl_indoor_test_picture.png").string();
  Picture picture(3, 2);
  picture.set(2, 1, {10, 20, 30});
  savePng(path, picture);
  png_image image;
  std::memset(&image, 0, sizeof(image));
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0);
  image.format = PNG_FORMAT_RGB;
  ASSERT_EQ(std::make_tuple(image.width, image.height), std::make_tuple(3u, 2u));
  std::uint8_t pixels[18];
  ASSERT_NE(png_image_finish_read(&image, nullptr, pixels, 0, nullptr), 0);
  EXPECT_EQ(pixels[0], 255);
  EXPECT_EQ(std::make_tuple(pixels[15], pixels[16], pixels[17]),
            std::make_tuple(10, 20, 30));
  std::filesystem::remove(path);
  EXPECT_THROW(savePng("/dev/null/picture.png", picture), ToolError);
}
