/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/color.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::indoor::test {

/** \brief 0xRRGGBB. */
inline unsigned
rgb(tool::Color color)
{
  return (color.red << 16) + (color.green << 8) + color.blue;
}

/** \brief Pixels as 0xRRGGBB. */
struct Pixels {
  int width = 0, height = 0;
  std::vector<unsigned char> bytes;

  unsigned
  at(int x, int y) const
  {
    const auto* p = bytes.data() + 3 * (static_cast<std::size_t>(y) * width + x);
    return (p[0] << 16) + (p[1] << 8) + p[2];
  }

  template <typename Condition>
  int
  count(const Condition& holds) const
  {
    int found = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        found += holds(at(x, y)) ? 1 : 0;
    return found;
  }
};

/** \brief Read what a PNG file holds. */
inline Pixels
readPng(const std::string& file)
{
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, file.data(), file.size()), 0);
  image.format = PNG_FORMAT_RGB;
  Pixels pixels{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  pixels.bytes.resize(PNG_IMAGE_SIZE(image));
  EXPECT_NE(png_image_finish_read(&image, nullptr, pixels.bytes.data(), 0, nullptr), 0);
  return pixels;
}

} // namespace pcl::indoor::test
