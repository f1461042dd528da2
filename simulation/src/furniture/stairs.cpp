/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/part_maker.h"

#include <algorithm>

namespace pcl::indoor {

namespace {

// Steps between x0 and x1, from y0 to y1 on either way, open below.
struct Flight {
  double x0, x1, y0, y1, z0;
  int steps;
  double rise;
};

void
addFlight(PartMaker& make, const Flight& f)
{
  constexpr double thickness = 0.04; // metres, of the rail
  const double run = (f.y1 - f.y0) / f.steps;
  const auto ends = [&](int i) {
    return std::minmax({f.y0 + i * run, f.y0 + (i + 1) * run});
  };
  for (int i = 0; i < f.steps; ++i) {
    const auto [low, high] = ends(i);
    make.box("step",
             {f.x0 + 0.05, low, f.x1 - 0.05, high},
             std::max(0.0, f.z0 + (i - 1) * f.rise),
             f.z0 + (i + 1) * f.rise);
  }
  for (const double side : {f.x0, f.x1 - thickness}) {
    for (int i = 0; i < f.steps; ++i) { // short pieces follow the steps
      const auto [low, high] = ends(i);
      make.box("rail",
               {side, low, side + thickness, high},
               f.z0 + i * f.rise + 0.94,
               f.z0 + (i + 1) * f.rise + 1.0);
    }
    make.join(f.steps, "rail");
  }
}

} // namespace

FurnitureModel
makeHalfTurnStairs(const Eigen::Vector3d& size)
{
  constexpr double slab = 0.18; // metres, of the landing
  const double x = size.x() / 2, y = size.y() / 2;
  const double height = size.z() - 1.0; // the handrail ends a metre above the last step
  const int steps = partsIn(height, 0.175, 4);
  const double rise = height / steps;
  // The landing is one step of the first flight, and as deep as a flight is wide.
  const int first = steps / 2, second = steps - first;
  const double landing = -y + x, landing_height = first * rise;
  PartMaker make(size);
  addFlight(make, {0.02, x, y, landing, 0.0, first - 1, rise});
  make.box("landing", {-x, -y, x, landing}, landing_height - slab, landing_height);
  addFlight(make, {-x, -0.02, landing, y, landing_height, second, rise});
  return make.take();
}

} // namespace pcl::indoor
