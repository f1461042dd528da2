/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Drawings as text, and what of them comes out as PNG.
#include "pictures/svg_drawing.h"

#include "files/output_file.h"
#include "files/tool_error.h"
#include "pictures/png_bytes.h"
#include "pictures/svg_raster.h"
#include "support/comma_locale.h"
#include "support/folder_test.h"
#include "support/png_pixels.h"

#include <cmath>

using namespace pcl::indoor::tool;
using pcl::indoor::test::bytesOf;
using pcl::indoor::test::readPng;
using pcl::indoor::test::rgb;

namespace {

using SvgDrawingFiles = pcl::indoor::test::FolderTest;

bool
holds(const SvgDrawing& drawing, const std::string& part)
{
  return drawing.str().find(part) != std::string::npos;
}

} // namespace

TEST(PixelImage, APngHoldsThePixels)
{
  PixelImage image(3, 2);
  image.set(2, 1, {10, 20, 30});
  const auto pixels = readPng(
      pngBytes(image.width(), image.height(), [&](int y) { return image.row(y); }));
  ASSERT_EQ(pixels.width, 3);
  ASSERT_EQ(pixels.height, 2);
  EXPECT_EQ(pixels.at(0, 0), 0xFFFFFFu);
  EXPECT_EQ(pixels.at(2, 1), 0x0A141Eu);
  EXPECT_EQ(rgb(image.at(2, 1)), 0x0A141Eu);
  EXPECT_EQ(PixelImage(0, 0).width(), 1);
}

TEST(SvgDrawing, TextsStayTexts)
{
  EXPECT_EQ(xmlText("a <b> & \"c\"\x1b\xff"),
            "a &#60;b&#62; &#38; &#34;c&#34;\\x1b\\xff");
  EXPECT_EQ(xmlText("Zürich"), "Zürich");
  SvgDrawing drawing(100.0, 50.0);
  drawing.text({1.0, 2.0}, "</text><script>");
  EXPECT_FALSE(holds(drawing, "<script>"));
}

TEST(SvgDrawing, ScaleBarsHaveRoundLengths)
{
  for (const auto& [units_per_metre, metres] : {std::pair{200.0, 1},
                                                {60.0, 1},
                                                {50.0, 2},
                                                {29.0, 5},
                                                {11.0, 10},
                                                {0.25, 500}}) {
    SvgDrawing drawing(100.0, 50.0);
    drawing.scaleBar({0.0, 0.0}, units_per_metre);
    EXPECT_TRUE(holds(drawing, ">" + std::to_string(metres) + " m<")) << metres;
    EXPECT_TRUE(holds(drawing, formatted("H%.1fv", metres * units_per_metre)));
  }
}

TEST(SvgDrawing, NumbersHaveAPointWhereTheLocaleHasAComma)
{
  const pcl::indoor::test::CommaLocale locale;
  if (!locale.hasComma())
    GTEST_SKIP() << "no locale with a comma is installed";
  EXPECT_EQ(formatted("%.1f %g", 2.5, 0.25), "2.5 0.25");
  EXPECT_TRUE(locale.hasComma()); // as before
}

TEST(SvgDrawing, DrawingsLieBelowEachOther)
{
  const SvgDrawing wide(200.0, 30.0), high(100.0, 70.0);
  const auto both = stacked({wide, high}, 5.0);
  EXPECT_EQ(both.width(), 200.0);
  EXPECT_EQ(both.height(), 105.0);
  EXPECT_TRUE(holds(both, "translate(0.0 35.0)"));
  EXPECT_TRUE(holds(both, "fill=\"white\""));
  EXPECT_FALSE(holds(SvgDrawing(1.0, 1.0, false), "white"));
  EXPECT_GT(stacked({}).height(), 0.0);
}

TEST(SvgDrawing, IsDrawnAsPng)
{
  if (!canRasterise())
    GTEST_SKIP() << "built without librsvg";
  SvgDrawing drawing(60.0, 40.0);
  drawing.rectangle({10.0, 10.0}, {20.0, 5.0}, {255, 0, 0});
  drawing.text({35.0, 25.0}, "88", {Anchor::Start, 14.0});
  const auto twice = readPng(rasterised({{"a", drawing.str()}}).get().at(0).second);
  ASSERT_EQ(twice.width, 120);
  ASSERT_EQ(twice.height, 80);
  EXPECT_EQ(twice.at(40, 25), 0xFF0000u);
  EXPECT_EQ(twice.at(40, 35), 0xFFFFFFu);
  const auto letters = twice.count([](unsigned c) { return (c & 0xFF00u) < 0x8000u; }) -
                       40 * 10; // of the rectangle
  EXPECT_GT(letters, 100) << "no letters";
  EXPECT_LT(letters, 800);

  const SvgDrawing large(8000.0, 4.0);
  const auto reduced = readPng(rasterised({{"a", large.str()}}).get().at(0).second);
  EXPECT_EQ(reduced.width, 10000);
  EXPECT_EQ(reduced.height, 5);
}

TEST(SvgDrawing, PixelsAreExactSquares)
{
  if (!canRasterise())
    GTEST_SKIP() << "built without librsvg";
  PixelImage image(30, 20);
  for (int x = 0; x < 30; ++x)
    for (int y = 0; y < 20; ++y)
      image.set(x, y, labelColor(static_cast<std::uint32_t>(30 * y + x)));
  for (const int scale : {1, 3, 12}) {
    SvgDrawing tile(30 * scale, 20 * scale), drawing(400.3, 300.6);
    tile.image({0.0, 0.0}, image.enlarged(scale));
    drawing.drawing({8.0, 5.0}, tile);
    const auto pixels =
        readPng(rasterised({{"a", drawing.str(), 1.0}}).get().at(0).second);
    for (int x = 0; x < 30 * scale; ++x)
      for (int y = 0; y < 20 * scale; ++y)
        ASSERT_EQ(pixels.at(8 + x, 5 + y), rgb(image.at(x / scale, y / scale)))
            << x << ", " << y << " at " << scale;
  }
}

TEST_F(SvgDrawingFiles, WhatCannotBeDrawnIsLeftOutWithOneWarning)
{
  const auto svg = SvgDrawing(10.0, 10.0).str();
  testing::internal::CaptureStderr();
  savePictures({{path("a.png"), "<svg"}, {path("b.png"), svg}, {path("c.png"), "no"}});
  const auto said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  EXPECT_NE(said.find("a.png"), std::string::npos);
  EXPECT_NE(said.find("c.png cannot be drawn"), std::string::npos);
  EXPECT_EQ(said.find("b.png") == std::string::npos, canRasterise());
  EXPECT_FALSE(std::filesystem::exists(path("a.png")));
  EXPECT_EQ(std::filesystem::exists(path("b.png")), canRasterise());
}

TEST_F(SvgDrawingFiles, AreSvgWhereTheirNameSaysSo)
{
  const auto svg = SvgDrawing(10.0, 10.0).str();
  testing::internal::CaptureStderr();
  savePictures({{path("a.SVG"), svg}});
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(bytesOf(path("a.SVG")), svg);
  EXPECT_THROW(savePictures({{"/dev/null/a.svg", svg}}), ToolError);
}
