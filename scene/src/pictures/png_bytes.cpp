/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/png_bytes.h"

#include <png.h>

#include <new>
#include <utility>

namespace pcl::indoor::tool {
namespace {

/** libpng comes back from errors by a jump: of memory, all else goes well here. */
struct Writing {
  static void
  stop(png_structp png, png_const_charp /*message*/)
  {
    png_longjmp(png, 1);
  }

  static void
  append(png_structp png, png_bytep data, std::size_t size)
  {
    try {
      static_cast<std::string*>(png_get_io_ptr(png))
          ->append(reinterpret_cast<const char*>(data), size);
      return;
    } catch (const std::bad_alloc&) {
    }
    png_error(png, "no memory");
  }

  ~Writing() { png_destroy_write_struct(&png, &info); }

  png_structp png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, &stop, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  std::string bytes;
};

} // namespace

std::string
pngBytes(int width, int height, const std::function<const Color*(int)>& row)
{
  static_assert(sizeof(Color) == 3, "pixels lie as libpng reads them");
  constexpr int level = 4; // of 9: the fastest at which rows that repeat pack well
  constexpr int bits = 8;
  Writing writing;
  if (!writing.info)
    throw std::bad_alloc();
  auto* const png = writing.png;
  if (setjmp(png_jmpbuf(png)) != 0)
    throw std::bad_alloc();
  png_set_write_fn(png, &writing.bytes, &Writing::append, nullptr);
  const auto columns = static_cast<png_uint_32>(width);
  const auto rows = static_cast<png_uint_32>(height);
  png_set_IHDR(png, writing.info, columns, rows, bits, PNG_COLOR_TYPE_RGB, 0, 0, 0);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE | PNG_FILTER_UP);
  png_set_compression_level(png, level);
  png_write_info(png, writing.info);
  for (int y = 0; y < height; ++y)
    png_write_row(png, &row(y)->red);
  png_write_end(png, nullptr);
  return std::move(writing.bytes);
}

} // namespace pcl::indoor::tool
