/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/shapes/solids.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl::indoor {

namespace {

using P = Eigen::Vector3d;

FurnitureClass
column(int kind)
{
  return fitted(
      "column",
      {0.3, 0.3, 2.8},
      {0.5, 0.5, 2.8},
      [kind](PartMaker& make, const Size& size, RandomDraw&) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z(), foot = 0.12 * z;
        if (kind == 0) { // an angular shaft between a base and a capital
          make.prism("shaft", {0, 0}, 0.8 * x, 0.05 * z, 0.8 * x, 0.95 * z, 8);
          make.box("base", {-x, -y, x, y}, 0, 0.06 * z);
          return make.frustum("capital",
                              {-0.75 * x, -0.75 * y, 0.75 * x, 0.75 * y},
                              0.9 * z,
                              {-x, -y, x, y},
                              z);
        }
        if (kind == 1) // swells towards its middle
          return lathe(make,
                       "shaft",
                       {0, 0},
                       {{x, 0},
                        {x, 0.02 * z},
                        {0.75 * x, foot},
                        {0.8 * x, 0.4 * z},
                        {0.65 * x, 0.9 * z},
                        {x, 0.97 * z},
                        {x, z}},
                       20);
        make.box("web", {-0.08 * x, -y, 0.08 * x, y}, 0, z); // a steel section
        for (const double s : {-y, 0.85 * y})
          make.box("flange", {-x, s, x, s + 0.15 * y}, 0, z);
      });
}

FurnitureClass
beam(int kind)
{
  return fitted(
      "beam",
      {3.0, 0.2, 0.2},
      {5.0, 0.35, 0.4},
      [kind](PartMaker& make, const Size& size, RandomDraw&) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z();
        if (kind == 0)
          return tube(make, "beam", {{-x, 0, z / 2}, {x, 0, z / 2}}, z / 2, 14);
        make.box("web", {-x, -0.1 * y, x, 0.1 * y}, 0, z);
        for (const double s : {0.0, 0.88 * z})
          make.box("flange", {-x, -y, x, y}, s, s + 0.12 * z);
      });
}

FurnitureClass
railing(int kind)
{
  return fitted("railing",
                {2.0, 0.05, 0.95},
                {4.0, 0.1, 1.1},
                [kind](PartMaker& make, const Size& size, RandomDraw&) {
                  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
                  const int posts = partsIn(size.x(), 1.0) + 1;
                  tube(make, "rail", {{-x, 0, z - y}, {x, 0, z - y}}, y, 10);
                  if (kind == 1) // a parapet
                    return make.box("parapet", {-x, -0.8 * y, x, 0.8 * y}, 0, z - y);
                  row(make,
                      "post",
                      {{-x, -0.6 * y, 0}, {-x + 0.04, 0.6 * y, z - y}},
                      {(2 * x - 0.04) / (posts - 1), 0, 0},
                      posts);
                  if (kind == 2)
                    return row(make,
                               "panel",
                               {{-x + 0.06, -0.1 * y, 0.08},
                                {-x + (2 * x) / (posts - 1) - 0.04, 0.1 * y, 0.85 * z}},
                               {2 * x / (posts - 1), 0, 0},
                               posts - 1);
                  row(make,
                      "bar",
                      {{-x + 0.1, -0.2 * y, 0.1}, {-x + 0.115, 0.2 * y, z - y}},
                      {(2 * x - 0.2) / (10 * (posts - 1)), 0, 0},
                      10 * (posts - 1));
                  make.join(10 * (posts - 1), "bars");
                });
}

/** A straight flight. */
struct FlightStyle {
  bool open = false;   ///< treads on two strings, seen through
  bool filled = false; ///< a block down to the floor
  int sides = 0;       ///< 0 no railing, 1 on the right, 2 parapets on both
};

// Climbs towards +y; the handrail ends a metre above the last step.
FurnitureClass
flight(const FlightStyle& style)
{
  return fitted(
      "stairs",
      {0.9, 4.2, 4.1},
      {1.3, 4.8, 4.1},
      [style](PartMaker& make, const Size& size, RandomDraw&) {
        const double x = size.x() / 2, y = size.y() / 2, high = size.z() - 1.0;
        const int steps = partsIn(high, 0.175);
        const double rise = high / steps, run = size.y() / steps;
        for (int i = 0; i < steps; ++i) {
          const double top = (i + 1) * rise, low = style.open ? top - 0.05
                                                   : style.filled
                                                       ? 0.0
                                                       : std::max(0.0, top - 2 * rise);
          make.box("step",
                   {-x + 0.05,
                    -y + i * run,
                    x - 0.05,
                    -y + (i + 1) * run + (style.open ? 0.02 : 0.0)},
                   low,
                   top);
        }
        const auto along = [&](double side, double low, double upper, double thick) {
          sheet(make,
                upper > 0.5 ? "parapet" : "string",
                {8, 1, thick},
                [&](double u, double v) -> P {
                  const double t = (u + 1) / 2;
                  return {side,
                          -y + t * 2 * y,
                          std::max(0.0, t * high + low) + (v + 1) / 2 * (upper - low)};
                });
        };
        for (const double s : {-x + 0.03, x - 0.03}) {
          if (style.open)
            along(s, -0.25, 0.1, 0.04);
          if (style.sides == 2)
            along(s, 0.0, 1.0, 0.05);
          if (style.sides == 1 && s > 0) {
            tube(make, "rail", {{s, -y, 0.97}, {s, y, high + 0.97}}, 0.025);
            for (int i = 0; i < steps; i += 2)
              tube(make,
                   "post",
                   {{s, -y + (i + 0.5) * run, i * rise},
                    {s, -y + (i + 0.5) * run, (i + 0.5) * rise + 0.97}},
                   0.012);
          }
        }
        if (style.sides == 0)
          tube(
              make, "rail", {{-x + 0.02, -y, 0.98}, {-x + 0.02, y, high + 0.98}}, 0.02);
      });
}

} // namespace

std::vector<FurnitureClass>
structureShapes()
{
  return {
      column(0),
      column(1),
      column(2),
      beam(0),
      beam(1),
      railing(0),
      railing(1),
      railing(2),
      flight({true, false, 1}),
      flight({false, true, 2}),
      flight({false, true, 0}),
      flight({true, false, 2}),
  };
}

} // namespace pcl::indoor
