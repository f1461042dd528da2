/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/color.h"

#include <pcl/indoor/exports.h>

#include <cstddef>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What really is a grid of colours: a map, a cloud seen by a camera. All else
 * is drawn, see SvgDrawing. (0, 0) is the upper left corner. */
class PCL_INDOOR_EXPORTS PixelImage {
public:
  PixelImage(int width, int height, Color background = paper);

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

  /** \brief Set a pixel of the image. */
  void
  set(int x, int y, Color color)
  {
    pixels_[index(x, y)] = color;
  }

  Color
  at(int x, int y) const
  {
    return pixels_.at(index(x, y));
  }

  /** \brief Each pixel as a square with sides of \a scale. */
  PixelImage
  enlarged(int scale) const;

  const Color*
  row(int y) const
  {
    return &pixels_[index(0, y)];
  }

private:
  std::size_t
  index(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_;
  int height_;
  std::vector<Color> pixels_; ///< row after row
};

} // namespace pcl::indoor::tool
