/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <cstddef>
#include <cstdint>

namespace pcl::indoor::tool {

struct Color {
  std::uint8_t red = 255;
  std::uint8_t green = 255;
  std::uint8_t blue = 255;
};

constexpr Color paper{255, 255, 255};
constexpr Color ink{30, 30, 30};
constexpr Color light_grey{225, 225, 225}; ///< of lines behind a plot

/** \brief The colour of a label, always the same; near labels get distinct colours. 0,
 * no label, is light grey. */
PCL_INDOOR_EXPORTS Color
labelColor(std::uint32_t label);

/** \brief The colour of the k-th curve or bar of a plot: dark enough for thin lines on
 * white; ten, then again. */
PCL_INDOOR_EXPORTS Color
lineColor(std::size_t k);

/** \brief Black (0 and below) over violet, red and orange to light yellow (1 and
 * above); grey for NaN. */
Color
heatColor(double value);

} // namespace pcl::indoor::tool
