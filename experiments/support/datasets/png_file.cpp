/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "datasets/png_file.h"

#include "files/tool_error.h"

#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace pcl::indoor::tool {
namespace {

enum class Content { Numbers, Colors };

/** What libpng needs and says while it reads a file. Its errors come back by a jump, so
 * that nothing with a destructor may begin to live between. */
struct Reading {
  explicit Reading(const std::string& name)
  : path(name)
  , file(std::fopen(name.c_str(), "rb"), &std::fclose)
  {
    if (!file)
      throw ToolError(path + ": cannot be opened");
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &stop, &ignore);
    if (png)
      info = png_create_info_struct(png);
    if (!info)
      throw std::bad_alloc();
    png_set_user_limits(png, 65535, 65535);
    png_init_io(png, file.get());
  }

  ~Reading() { png_destroy_read_struct(&png, &info, nullptr); }

  Reading(const Reading&) = delete;
  Reading&
  operator=(const Reading&) = delete;

  static void
  stop(png_structp png, png_const_charp message)
  {
    auto& reading = *static_cast<Reading*>(png_get_error_ptr(png));
    std::snprintf(reading.problem, sizeof(reading.problem), "%s", message);
    std::longjmp(reading.back, 1);
  }

  static void
  ignore(png_structp /*png*/, png_const_charp /*warning*/)
  {}

  const std::string& path;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file;
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::jmp_buf back;
  char problem[160] = ""; ///< a copy: libpng's text ends with the jump
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint8_t*> rows;
};

/** Reads the header. \return did it work? */
bool
readHeader(Reading& reading)
{
  if (setjmp(reading.back) != 0)
    return false;
  png_read_info(reading.png, reading.info);
  return true;
}

/** Bytes that a file has at least: deflate makes of 1032 bytes no less than one. */
std::size_t
leastSize(const Reading& reading, std::size_t height)
{
  return png_get_rowbytes(reading.png, reading.info) * height / 1032;
}

/** Says how the values are wanted. \return bytes of a row, 0 after an error */
std::size_t
chooseFormat(Reading& reading, Content content)
{
  auto* const png = reading.png;
  if (setjmp(reading.back) != 0)
    return 0;
  if (content == Content::Colors) {
    png_set_expand(png);
    png_set_strip_16(png);
    png_set_strip_alpha(png);
    png_set_gray_to_rgb(png);
  }
  else
    png_set_packing(png); // a byte per value, which stays as it is
  png_set_interlace_handling(png);
  png_read_update_info(png, reading.info);
  return png_get_rowbytes(png, reading.info);
}

bool
readRows(Reading& reading)
{
  if (setjmp(reading.back) != 0)
    return false;
  png_read_image(reading.png, reading.rows.data());
  png_read_end(reading.png, nullptr);
  return true;
}

PngImage
readPng(const std::string& path, Content content)
{
  Reading reading(path);
  const auto fail = [&] {
    return ToolError(path + ": the PNG cannot be read: " + reading.problem);
  };
  if (!readHeader(reading))
    throw fail();
  PngImage image;
  image.width = png_get_image_width(reading.png, reading.info);
  image.height = png_get_image_height(reading.png, reading.info);
  image.bits = png_get_bit_depth(reading.png, reading.info);
  const auto type = png_get_color_type(reading.png, reading.info);
  if (content == Content::Numbers && type != PNG_COLOR_TYPE_GRAY &&
      type != PNG_COLOR_TYPE_PALETTE)
    throw ToolError(path +
                    ": the image has colours or alpha, not one number per pixel");
  image.channels = content == Content::Colors ? 3 : 1;
  if (const auto least = leastSize(reading, image.height);
      std::filesystem::file_size(path) < least)
    throw ToolError(path + ": " + std::to_string(image.width) + " x " +
                    std::to_string(image.height) + " pixels need at least " +
                    std::to_string(least) + " bytes, the file is shorter");
  const auto row_size = chooseFormat(reading, content);
  if (row_size == 0)
    throw fail();
  reading.bytes.resize(row_size * image.height);
  for (std::size_t y = 0; y < image.height; ++y)
    reading.rows.push_back(reading.bytes.data() + y * row_size);
  if (!readRows(reading))
    throw fail();
  const bool is_wide = content == Content::Numbers && image.bits == 16;
  image.values.resize(image.pixelCount() * image.channels);
  const auto* byte = reading.bytes.data();
  for (auto& value : image.values) { // of 16 bits the high byte is first
    value = *byte++;
    if (is_wide)
      value = static_cast<std::uint16_t>(value << 8 | *byte++);
  }
  return image;
}

} // namespace

PngImage
readNumberPng(const std::string& path)
{
  return readPng(path, Content::Numbers);
}

PngImage
readColorPng(const std::string& path)
{
  return readPng(path, Content::Colors);
}

} // namespace pcl::indoor::tool
