/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/color.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pcl::indoor::tool {
namespace {

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
    return light_grey;
  // steps of the golden section never come back to a hue and keep successive hues far
  // apart
  constexpr double golden_step = 0.6180339887498949;
  const double hue = std::fmod(golden_step * static_cast<double>(label), 1.0);
  constexpr double saturations[] = {0.62, 0.85, 0.45};
  constexpr double values[] = {0.95, 0.75, 0.85, 0.6};
  return colorOfHsv(hue, saturations[label % 3], values[(label / 3) % 4]);
}

Color
lineColor(std::size_t k)
{
  constexpr Color colors[] = {{31, 119, 180},
                              {214, 39, 40},
                              {44, 160, 44},
                              {148, 103, 189},
                              {230, 126, 0},
                              {140, 86, 75},
                              {227, 119, 194},
                              {110, 110, 110},
                              {152, 152, 20},
                              {23, 165, 180}};
  return colors[k % std::size(colors)];
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

} // namespace pcl::indoor::tool
