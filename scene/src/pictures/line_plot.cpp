/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/line_plot.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

constexpr double left = 64.0, top = 40.0, wide = 440.0, high = 240.0, below = 52.0;
constexpr double sample = 28.0; // of a line in the legend
constexpr double line_height = 20.0;

SvgDrawing::Place
placeOf(const PlotAxes& axes, double x, double y)
{
  return {left + wide * x / axes.x_end, top + high * (1.0 - y / axes.y_end)};
}

void
addAxes(SvgDrawing& plot, const PlotAxes& axes)
{
  constexpr double almost = 1.0001; // for sums of steps
  for (double x = 0.0; x <= almost * axes.x_end; x += axes.x_step) {
    const auto foot = placeOf(axes, x, 0.0);
    plot.line({placeOf(axes, x, axes.y_end), foot}, light_grey);
    plot.text({foot.x(), foot.y() + 12.0}, formatted("%g", x), {Anchor::Middle});
  }
  for (double y = 0.0; y <= almost * axes.y_end; y += axes.y_step) {
    const auto foot = placeOf(axes, 0.0, y);
    plot.line({placeOf(axes, axes.x_end, y), foot}, light_grey);
    plot.text({foot.x() - 6.0, foot.y()}, formatted("%g", y), {Anchor::End});
  }
  plot.line({{left, top}, {left, top + high}, {left + wide, top + high}}, ink);
  plot.text({left + 0.5 * wide, top + high + 34.0}, axes.x_name, {Anchor::Middle});
  plot.text({16.0, top + 0.5 * high}, axes.y_name, {Anchor::Middle, 12.0, -90.0});
  plot.text({left, 20.0}, axes.title, {Anchor::Start, 15.0, 0.0, true});
}

void
addCurve(SvgDrawing& plot, const PlotAxes& axes, const Curve& curve)
{
  constexpr std::size_t few = 8; // points that are marked
  std::vector<SvgDrawing::Place> places;
  for (const auto& [x, y] : curve.points)
    places.push_back(placeOf(axes, x, y));
  plot.line(places, curve.color, 2.0, curve.is_dashed);
  if (places.size() <= few)
    for (const auto& place : places)
      plot.circle(place, 3.0, curve.color, curve.color);
}

} // namespace

double
plotStep(double whole)
{
  double step = std::pow(10.0, std::floor(std::log10(whole / 6.0)));
  for (const double factor : {2.0, 2.5, 2.0}) { // 1, 2, 5, 10
    if (step * 6.0 >= whole)
      break;
    step *= factor;
  }
  return step;
}

SvgDrawing
linePlot(const PlotAxes& axes, const std::vector<Curve>& curves)
{
  double name_width = 0.0;
  for (const auto& curve : curves)
    name_width = std::max(name_width, SvgDrawing::textWidth(curve.name));
  const double legend = left + wide + 20.0;
  SvgDrawing plot(
      legend + sample + 8.0 + name_width + 10.0,
      std::max(top + high + below, top + line_height * double(curves.size()) + 10.0));
  addAxes(plot, axes);
  double y = top + 0.5 * line_height;
  for (const auto& curve : curves) {
    addCurve(plot, axes, curve);
    plot.line({{legend, y}, {legend + sample, y}}, curve.color, 2.0, curve.is_dashed);
    plot.text({legend + sample + 8.0, y}, curve.name);
    y += line_height;
  }
  return plot;
}

} // namespace pcl::indoor::tool
