/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief One curve of a plot. */
struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points; ///< ascending x
  Color color;
  bool dashed = false;
};

/** \brief Draws curves over common axes that begin at 0. */
class LinePlot {
public:
  LinePlot(double x_end, double y_end)
  : x_end_(x_end)
  , y_end_(y_end)
  {}

  Picture
  draw(const std::string& title,
       const std::string& x_name,
       const std::string& y_name,
       const std::vector<Curve>& curves,
       double x_step,
       double y_step)
  {
    picture_ = Picture(width, height);
    const Color grid{222, 222, 222}, black{0, 0, 0};
    for (double x = 0; x <= x_end_ * 1.0001; x += x_step) {
      line(x, 0, x, y_end_, grid, false, 1);
      text(column(x), height - bottom + 8, number(x));
    }
    for (double y = 0; y <= y_end_ * 1.0001; y += y_step) {
      line(0, y, x_end_, y, grid, false, 1);
      text(left - 30, row(y) - 6, number(y));
    }
    line(0, 0, x_end_, 0, black, false, 2);
    line(0, 0, 0, y_end_, black, false, 2);
    picture_.drawText(left, 10, title, black, 2);
    picture_.drawText(left, 32, y_name, black, 2);
    picture_.drawText(
        width - right - Picture::textWidth(x_name, 2), height - 26, x_name, black, 2);
    int legend = top + 6;
    for (const auto& curve : curves) {
      for (std::size_t i = 1; i < curve.points.size(); ++i)
        line(curve.points[i - 1].first,
             curve.points[i - 1].second,
             curve.points[i].first,
             curve.points[i].second,
             curve.color,
             curve.dashed,
             3);
      for (int x = 0; x < 44; ++x)
        if (!curve.dashed || x % 12 < 7)
          picture_.fillRectangle(legend_left + x, legend + 5, 1, 3, curve.color);
      picture_.drawText(legend_left + 54, legend, curve.name, black, 2);
      legend += 22;
    }
    return picture_;
  }

private:
  static constexpr int width = 980, height = 520;
  static constexpr int left = 70, bottom = 56, top = 56, right = 330;
  static constexpr int legend_left = width - right + 20;

  int
  column(double x) const
  {
    return left + static_cast<int>(std::lround((width - left - right) * x / x_end_));
  }

  int
  row(double y) const
  {
    return height - bottom -
           static_cast<int>(std::lround((height - bottom - top) * y / y_end_));
  }

  static std::string
  number(double value)
  {
    char digits[32];
    std::snprintf(digits, sizeof(digits), "%g", value);
    return digits;
  }

  /** Centred. */
  void
  text(int x, int y, const std::string& words)
  {
    picture_.drawText(x - Picture::textWidth(words, 2) / 2, y, words, {0, 0, 0}, 2);
  }

  void
  line(double x0,
       double y0,
       double x1,
       double y1,
       Color color,
       bool dashed,
       int thickness)
  {
    const int c0 = column(x0), r0 = row(y0), c1 = column(x1), r1 = row(y1);
    const int steps = std::max({std::abs(c1 - c0), std::abs(r1 - r0), 1});
    for (int i = 0; i <= steps; ++i) {
      const int c = c0 + (c1 - c0) * i / steps, r = r0 + (r1 - r0) * i / steps;
      if (!dashed || c % 12 < 7)
        picture_.fillRectangle(
            c - thickness / 2, r - thickness / 2, thickness, thickness, color);
    }
  }

  double x_end_, y_end_;
  Picture picture_{1, 1};
};

} // namespace pcl::indoor::tool
