/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/pixel_image.h"

#include <algorithm>

namespace pcl::indoor::tool {

PixelImage::PixelImage(int width, int height, Color background)
: width_(std::max(width, 1))
, height_(std::max(height, 1))
, pixels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
          background)
{}

PixelImage
PixelImage::enlarged(int scale) const
{
  PixelImage large(scale * width_, scale * height_);
  auto pixel = large.pixels_.begin();
  for (int y = 0; y < large.height_; ++y)
    for (int x = 0; x < width_; ++x)
      pixel = std::fill_n(pixel, scale, at(x, y / scale));
  return large;
}

} // namespace pcl::indoor::tool
