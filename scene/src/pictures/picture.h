/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

struct Color {
  std::uint8_t red = 255;
  std::uint8_t green = 255;
  std::uint8_t blue = 255;
};

/** \brief The colour of a label, always the same; near labels get distinct colours. 0,
 * no label, is light grey. */
Color
labelColor(std::uint32_t label);

/** \brief Black (0 and below) over violet, red and orange to light yellow (1 and
 * above); grey for NaN. */
Color
heatColor(double value);

/** \brief An image of 8-bit RGB pixels; (0, 0) is its upper left corner. */
class Picture {
public:
  Picture(int width, int height, Color background = {});

  int
  width() const
  {
    return width_;
  }

  int
  height() const
  {
    return height_;
  }

  /** \brief Set a pixel; outside the image nothing happens. */
  void
  set(int x, int y, Color color);

  Color
  at(int x, int y) const;

  void
  fillRectangle(int x, int y, int width, int height, Color color);

  /** \brief Write digits, letters (as capitals) and .,:-+/()% of 5 x 7 dots from the
   * upper left corner (x, y).
   * \param[in] scale pixels per dot
   */
  void
  drawText(int x, int y, const std::string& text, Color color, int scale = 1);

  /** \brief Write text around (x, y), black on a white plate, moved to lie within the
   * image where it fits. */
  void
  drawLabel(int x, int y, const std::string& text, int scale = 1);

  /** \brief Put another image into this one, its upper left corner at (x, y). */
  void
  paste(const Picture& other, int x, int y);

  static int
  textWidth(const std::string& text, int scale = 1);

  static int
  textHeight(int scale = 1);

private:
  int width_;
  int height_;
  std::vector<std::uint8_t> pixels_; ///< red, green, blue; row after row
  friend std::string
  pngBytes(const Picture& picture);
};

/** \brief What a PNG file of the picture holds. */
std::string
pngBytes(const Picture& picture);

/** \brief Write a PNG file, whole or not at all.
 * \throws ToolError if it cannot be written
 */
void
savePng(const std::string& path, const Picture& picture);

} // namespace pcl::indoor::tool
