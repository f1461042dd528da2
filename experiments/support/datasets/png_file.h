/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The pixels of a PNG file as numbers, row after row, from the upper left. */
struct PngImage {
  std::uint32_t width = 0, height = 0;
  std::uint32_t channels = 1;        ///< 1 or 3
  std::uint32_t bits = 8;            ///< of a value in the file: 1, 2, 4, 8 or 16
  std::vector<std::uint16_t> values; ///< width * height * channels

  std::size_t
  pixelCount() const
  {
    return std::size_t{width} * height;
  }
};

/** \brief Read an image of numbers, such as depths or labels: the values of a grey
 * image, the indices of one with a palette.
 * \throws ToolError if the file is missing, damaged, no PNG, in colour or has an alpha
 * channel
 */
PngImage
readNumberPng(const std::string& path);

/** \brief Read an image as red, green and blue of 8 bits; alpha is left out.
 * \throws ToolError if the file is missing, damaged or no PNG
 */
PngImage
readColorPng(const std::string& path);

} // namespace pcl::indoor::tool
