/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <png.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::test {

constexpr int palette_bits = -8;

/** What a PNG file of these values holds, row after row.
 * \param[in] bits of a pixel: 8 or 16 of grey, 24 of red, green and blue, or
 * palette_bits: an index of 8 bits
 */
inline std::string
pngBytes(std::uint32_t width,
         std::uint32_t height,
         int bits,
         const std::vector<std::uint16_t>& values)
{
  std::vector<std::uint8_t> bytes;
  for (const auto value : values) {
    if (bits == 16)
      bytes.push_back(static_cast<std::uint8_t>(value >> 8));
    bytes.push_back(static_cast<std::uint8_t>(value));
  }
  std::string file;
  auto* png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  auto* info = png_create_info_struct(png);
  const auto add = [](png_structp own, png_bytep from, std::size_t size) {
    static_cast<std::string*>(png_get_io_ptr(own))
        ->append(reinterpret_cast<const char*>(from), size);
  };
  png_set_write_fn(png, &file, add, nullptr);
  png_set_IHDR(png,
               info,
               width,
               height,
               bits == 16 ? 16 : 8,
               bits == palette_bits ? PNG_COLOR_TYPE_PALETTE
               : bits == 24         ? PNG_COLOR_TYPE_RGB
                                    : PNG_COLOR_TYPE_GRAY,
               PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  const png_color palette[] = {{0, 0, 0}, {128, 0, 0}, {0, 128, 0}, {128, 128, 0}};
  if (bits == palette_bits)
    png_set_PLTE(png, info, palette, 4);
  png_write_info(png, info);
  for (std::uint32_t y = 0; y < height; ++y)
    png_write_row(png, &bytes[y * (bytes.size() / height)]);
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return file;
}

} // namespace pcl::indoor::test
