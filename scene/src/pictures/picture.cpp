/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/picture.h"

#include "files/output_file.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace pcl::indoor::tool {
namespace {

struct Glyph {
  char letter;
  std::array<std::uint8_t, 7> rows; ///< from the top; bit 4 is the leftmost of 5 dots
};

constexpr Glyph glyphs[] = {
    {'0', {0x0e, 0x11, 0x13, 0x15, 0x19, 0x11, 0x0e}},
    {'1', {0x04, 0x0c, 0x04, 0x04, 0x04, 0x04, 0x0e}},
    {'2', {0x0e, 0x11, 0x01, 0x02, 0x04, 0x08, 0x1f}},
    {'3', {0x1f, 0x02, 0x04, 0x02, 0x01, 0x11, 0x0e}},
    {'4', {0x02, 0x06, 0x0a, 0x12, 0x1f, 0x02, 0x02}},
    {'5', {0x1f, 0x10, 0x1e, 0x01, 0x01, 0x11, 0x0e}},
    {'6', {0x06, 0x08, 0x10, 0x1e, 0x11, 0x11, 0x0e}},
    {'7', {0x1f, 0x01, 0x02, 0x04, 0x08, 0x08, 0x08}},
    {'8', {0x0e, 0x11, 0x11, 0x0e, 0x11, 0x11, 0x0e}},
    {'9', {0x0e, 0x11, 0x11, 0x0f, 0x01, 0x02, 0x0c}},
    {'A', {0x0e, 0x11, 0x11, 0x1f, 0x11, 0x11, 0x11}},
    {'B', {0x1e, 0x11, 0x11, 0x1e, 0x11, 0x11, 0x1e}},
    {'C', {0x0e, 0x11, 0x10, 0x10, 0x10, 0x11, 0x0e}},
    {'D', {0x1e, 0x11, 0x11, 0x11, 0x11, 0x11, 0x1e}},
    {'E', {0x1f, 0x10, 0x10, 0x1e, 0x10, 0x10, 0x1f}},
    {'F', {0x1f, 0x10, 0x10, 0x1e, 0x10, 0x10, 0x10}},
    {'G', {0x0e, 0x11, 0x10, 0x17, 0x11, 0x11, 0x0f}},
    {'H', {0x11, 0x11, 0x11, 0x1f, 0x11, 0x11, 0x11}},
    {'I', {0x0e, 0x04, 0x04, 0x04, 0x04, 0x04, 0x0e}},
    {'J', {0x07, 0x02, 0x02, 0x02, 0x02, 0x12, 0x0c}},
    {'K', {0x11, 0x12, 0x14, 0x18, 0x14, 0x12, 0x11}},
    {'L', {0x10, 0x10, 0x10, 0x10, 0x10, 0x10, 0x1f}},
    {'M', {0x11, 0x1b, 0x15, 0x15, 0x11, 0x11, 0x11}},
    {'N', {0x11, 0x19, 0x15, 0x13, 0x11, 0x11, 0x11}},
    {'O', {0x0e, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0e}},
    {'P', {0x1e, 0x11, 0x11, 0x1e, 0x10, 0x10, 0x10}},
    {'Q', {0x0e, 0x11, 0x11, 0x11, 0x15, 0x12, 0x0d}},
    {'R', {0x1e, 0x11, 0x11, 0x1e, 0x14, 0x12, 0x11}},
    {'S', {0x0f, 0x10, 0x10, 0x0e, 0x01, 0x01, 0x1e}},
    {'T', {0x1f, 0x04, 0x04, 0x04, 0x04, 0x04, 0x04}},
    {'U', {0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0e}},
    {'V', {0x11, 0x11, 0x11, 0x11, 0x11, 0x0a, 0x04}},
    {'W', {0x11, 0x11, 0x11, 0x15, 0x15, 0x1b, 0x11}},
    {'X', {0x11, 0x11, 0x0a, 0x04, 0x0a, 0x11, 0x11}},
    {'Y', {0x11, 0x11, 0x0a, 0x04, 0x04, 0x04, 0x04}},
    {'Z', {0x1f, 0x01, 0x02, 0x04, 0x08, 0x10, 0x1f}},
    {'.', {0x00, 0x00, 0x00, 0x00, 0x00, 0x0c, 0x0c}},
    {',', {0x00, 0x00, 0x00, 0x00, 0x0c, 0x04, 0x08}},
    {':', {0x00, 0x0c, 0x0c, 0x00, 0x0c, 0x0c, 0x00}},
    {'-', {0x00, 0x00, 0x00, 0x1f, 0x00, 0x00, 0x00}},
    {'+', {0x00, 0x04, 0x04, 0x1f, 0x04, 0x04, 0x00}},
    {'/', {0x00, 0x01, 0x02, 0x04, 0x08, 0x10, 0x00}},
    {'(', {0x02, 0x04, 0x08, 0x08, 0x08, 0x04, 0x02}},
    {')', {0x08, 0x04, 0x02, 0x02, 0x02, 0x04, 0x08}},
    {'%', {0x18, 0x19, 0x02, 0x04, 0x08, 0x13, 0x03}},
};

constexpr int dots_wide = 5;
constexpr int dots_high = 7;
constexpr int advance = dots_wide + 1;

const Glyph*
glyphOf(char letter)
{
  const char capital =
      static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  for (const auto& glyph : glyphs)
    if (glyph.letter == capital)
      return &glyph;
  return nullptr; // a gap
}

std::uint8_t
byteOf(double value)
{
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

/** hue in turns, saturation and value in [0, 1] */
Color
colorOfHsv(double hue, double saturation, double value)
{
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + 6.0 * hue, 6.0);
    return byteOf(value -
                  value * saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
  };
  return {channel(5.0), channel(3.0), channel(1.0)};
}

} // namespace

Color
labelColor(std::uint32_t label)
{
  if (label == 0)
    return {225, 225, 225};
  // steps of the golden section never come back to a hue and keep successive hues far
  // apart
  constexpr double golden_step = 0.6180339887498949;
  const double hue = std::fmod(golden_step * static_cast<double>(label), 1.0);
  constexpr double saturations[] = {0.62, 0.85, 0.45};
  constexpr double values[] = {0.95, 0.75, 0.85, 0.6};
  return colorOfHsv(hue, saturations[label % 3], values[(label / 3) % 4]);
}

Color
heatColor(double value)
{
  if (std::isnan(value))
    return {128, 128, 128};
  constexpr double stops[][3] = {{0.0, 0.0, 0.02},
                                 {0.34, 0.06, 0.43},
                                 {0.74, 0.21, 0.33},
                                 {0.98, 0.55, 0.04},
                                 {0.99, 1.0, 0.64}};
  const double place = 4.0 * std::clamp(value, 0.0, 1.0);
  const int left = std::min(3, static_cast<int>(place));
  const double part = place - left;
  const auto mix = [&](int c) {
    return byteOf((1.0 - part) * stops[left][c] + part * stops[left + 1][c]);
  };
  return {mix(0), mix(1), mix(2)};
}

Picture::Picture(int width, int height, Color background)
: width_(std::max(width, 1))
, height_(std::max(height, 1))
, pixels_(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_))
{
  fillRectangle(0, 0, width_, height_, background);
}

void
Picture::set(int x, int y, Color color)
{
  if (x < 0 || y < 0 || x >= width_ || y >= height_)
    return;
  const std::size_t first = 3 * (static_cast<std::size_t>(y) * width_ + x);
  pixels_[first] = color.red;
  pixels_[first + 1] = color.green;
  pixels_[first + 2] = color.blue;
}

Color
Picture::at(int x, int y) const
{
  const std::size_t first = 3 * (static_cast<std::size_t>(y) * width_ + x);
  return {pixels_.at(first), pixels_.at(first + 1), pixels_.at(first + 2)};
}

void
Picture::fillRectangle(int x, int y, int width, int height, Color color)
{
  for (int row = y; row < y + height; ++row)
    for (int column = x; column < x + width; ++column)
      set(column, row, color);
}

void
Picture::drawText(int x, int y, const std::string& text, Color color, int scale)
{
  for (const char letter : text) {
    if (const auto* glyph = glyphOf(letter))
      for (int row = 0; row < dots_high; ++row)
        for (int column = 0; column < dots_wide; ++column)
          if ((glyph->rows[row] >> (dots_wide - 1 - column)) & 1)
            fillRectangle(x + column * scale, y + row * scale, scale, scale, color);
    x += advance * scale;
  }
}

void
Picture::drawLabel(int x, int y, const std::string& text, int scale)
{
  const int wide = textWidth(text, scale) + 2 * scale;
  const int high = textHeight(scale) + 2 * scale;
  const int left = std::max(0, std::min(x - wide / 2, width_ - wide));
  const int top = std::max(0, std::min(y - high / 2, height_ - high));
  fillRectangle(left, top, wide, high, {255, 255, 255});
  drawText(left + scale, top + scale, text, {0, 0, 0}, scale);
}

void
Picture::paste(const Picture& other, int x, int y)
{
  for (int row = 0; row < other.height_; ++row)
    for (int column = 0; column < other.width_; ++column)
      set(x + column, y + row, other.at(column, row));
}

int
Picture::textWidth(const std::string& text, int scale)
{
  return text.empty() ? 0 : (static_cast<int>(text.size()) * advance - 1) * scale;
}

int
Picture::textHeight(int scale)
{
  return dots_high * scale;
}

std::string
pngBytes(const Picture& picture)
{
  png_image image;
  std::memset(&image, 0, sizeof(image));
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width_);
  image.height = static_cast<png_uint_32>(picture.height_);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(
          &image, bytes.data(), &size, 0, picture.pixels_.data(), 0, nullptr) == 0)
    throw std::runtime_error(std::string("PNG: ") + image.message);
  bytes.resize(size);
  return bytes;
}

void
savePng(const std::string& path, const Picture& picture)
{
  saveText(path, pngBytes(picture));
}

} // namespace pcl::indoor::tool
