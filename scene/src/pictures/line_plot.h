/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/svg_drawing.h"

#include <pcl/indoor/exports.h>

#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

/** \brief One curve of a plot. */
struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points; ///< ascending x
  Color color;
  bool is_dashed = false;
};

/** \brief Axes from 0 to an end, with a line of the grid at each step. */
struct PlotAxes {
  std::string title, x_name, y_name;
  double x_end = 1.0, y_end = 1.0;
  double x_step = 1.0, y_step = 1.0;
};

/** \brief A step of 1, 2 or 5 times a power of ten, of which at most six make the
 * whole. */
PCL_INDOOR_EXPORTS double
plotStep(double whole);

/** \brief Draw curves over common axes, with a legend; the points of short ones are
 * marked. */
PCL_INDOOR_EXPORTS SvgDrawing
linePlot(const PlotAxes& axes, const std::vector<Curve>& curves);

} // namespace pcl::indoor::tool
