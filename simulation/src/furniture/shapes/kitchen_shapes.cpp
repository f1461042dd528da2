/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/shapes/solids.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

using P = Eigen::Vector3d;

constexpr double plate = 0.04; // metres, of a worktop

/** What a kitchen unit has on and below its top. */
struct UnitStyle {
  int columns = 1, rows = 1;
  bool drawers = false;
  int handle = 1;
  bool open = false;     ///< shelves without doors
  bool hob = false;      ///< a plate with rings
  bool overhang = false; ///< the top reaches over the rear: an island with seats
  bool round = false;
  bool basin = false;
};

void
tap(PartMaker& make, double x, double y, double z, double high)
{
  tube(make,
       "tap",
       {{x, y, z},
        {x, y, z + high - 0.05},
        {x, y + 0.04, z + high},
        {x, y + 0.13, z + high},
        {x, y + 0.15, z + high - 0.05}},
       0.012);
  tube(make, "lever", {{x, y, z + 0.06}, {x + 0.06, y, z + 0.09}}, 0.008, 5);
}

void
buildUnit(PartMaker& make, const Size& size, RandomDraw& draw, const UnitStyle& style)
{
  const double x = size.x() / 2, y = size.y() / 2,
               rise = style.basin ? 0.2
                      : style.hob ? 0.03
                                  : 0.0,
               top = size.z() - rise;
  const double rear = style.overhang ? -0.3 * y : -y,
               body = style.basin ? top - 0.2 : top - plate;
  make.box("plinth", {-x, rear, x, y - 0.08}, 0, 0.1);
  if (style.open) {
    row(make,
        "side",
        {{-x, rear, 0.1}, {-x + 0.02, y - 0.04, body}},
        {2 * x - 0.02, 0, 0},
        2);
    row(make,
        "shelf",
        {{-x + 0.02, rear, 0.1}, {x - 0.02, y - 0.04, 0.12}},
        {0, 0, (body - 0.12) / 2},
        2);
  }
  else {
    make.box("body", {-x, rear, x, y - 0.04}, 0.1, body);
    front(make,
          size,
          {style.columns,
           style.rows,
           style.drawers,
           style.handle,
           0.11,
           top - plate - 0.005});
  }
  const double wide = style.basin ? std::min(0.5, 0.9 * x) : 0.0;
  if (style.basin) {
    make.loft(
        "basin",
        {-x, -y, -x + 2 * wide, y},
        {{1, body, 0.02}, {1, top, 0.02}, {0.85, top, 0.25}, {0.78, body + 0.02, 0.3}},
        24);
    if (wide < x)
      make.box("board", {-x + 2 * wide, -y, x, y}, body, top);
    tap(make, -x + wide, -0.85 * y, top, rise);
  }
  else
    style.round ? roundBox(make, "worktop", {-x, -y, x, y}, top - plate, top, 0.019)
                : make.box("worktop", {-x, -y, x, y}, top - plate, top);
  if (style.hob)
    rings(make, draw.uniform(-0.4, 0.4) * (x - 0.2), 0, top, std::min(0.13, 0.45 * x));
}

FurnitureClass
unit(const Size& smallest, const Size& largest, const UnitStyle& style, int like)
{
  return styled("kitchen_unit", smallest, largest, style, buildUnit, like);
}

// On the wall: two doors with rounded corners, an open shelf below them.
void
roundedCabinet(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2,
               low = draw.uniform(0.25, 0.4) * size.z();
  roundBox(make, "body", {-x, -y, x, y - 0.02}, low, size.z(), 0.05);
  for (const double s : {-1.0, 1.0})
    ellipsoid(make, "knob", {s * 0.05, y - 0.015, low + 0.06}, {0.015, 0.015, 0.015});
  make.box("shelf", {-x, -y, x, 0.6 * y}, 0, 0.02);
  for (const double s : {-x, x - 0.02})
    make.box("side", {s, -y, s + 0.02, 0.6 * y}, 0.02, low + 0.05);
}

void
openCabinet(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  const bool back = draw.pick(2) == 0;
  openCase(make, {{-x, -y, 0}, {x, y, size.z()}}, 1 + draw.pick(2), 2, back);
}

void
chimneyHood(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               low = draw.uniform(0.2, 0.4) * z;
  std::vector<Path> sections;
  for (int i = 0; i <= 6; ++i) {
    const double t = i / 6.0, s = 0.25 + 0.75 * std::pow(1 - t, 2), k = low * t + 0.03;
    sections.push_back({{-s * x, -y, k},
                        {s * x, -y, k},
                        {s * x, -y + 2 * s * y, k},
                        {-s * x, -y + 2 * s * y, k}});
  }
  skin(make, "hood", sections);
  make.box("rim", {-x, -y, x, y}, 0, 0.03);
  make.box("chimney", {-0.25 * x, -y, 0.25 * x, -0.5 * y}, low, z);
}

void
slantedHood(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               high = draw.uniform(0.5, 0.65) * z;
  sheet(make, "pane", {2, 2, 0.04}, [&](double u, double v) -> P {
    return {x * u, 0.2 * y + 0.7 * y * v * -1, 0.05 + (v + 1) / 2 * high};
  });
  make.box("body", {-0.6 * x, -y, 0.6 * x, -0.3 * y}, 0.1, high);
  make.box("chimney", {-0.25 * x, -y, 0.25 * x, -0.4 * y}, high, z);
}

/** A counter: to stand at, to be received at, to eat at. */
struct CounterStyle {
  bool corner = false, raised = false, legs = false, round = false;
};

void
buildCounter(PartMaker& make,
             const Size& size,
             RandomDraw& draw,
             const CounterStyle& style)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               work = style.raised ? 0.72 * z : z;
  const double depth = style.corner ? 0.45 * size.y() : size.y();
  if (style.round) {
    sheet(make, "body", {12, 1, 0.1}, [&](double u, double v) -> P {
      return {0.95 * x * u,
              y - 0.3 - 0.8 * size.y() * u * u * 0.5,
              0.05 + (v + 1) / 2 * (z - 0.1)};
    });
    return sheet(make, "top", {12, 2, 0.05}, [&](double u, double v) -> P {
      return {x * u, y - 0.3 - 0.8 * size.y() * u * u * 0.5 + 0.25 * v, z - 0.025};
    });
  }
  if (style.legs)
    legs(make, Legs::Panels, {x - 0.05, depth / 2 - 0.05}, work - 0.05, draw);
  else
    make.box(
        "body", {-x + 0.03, -y + 0.12, x - 0.03, -y + depth - 0.03}, 0, work - plate);
  make.box("top", {-x, -y, x, -y + depth}, work - plate, work);
  if (style.raised) {
    make.box("front", {-x, -y + depth - 0.06, x, -y + depth}, work, z - 0.03);
    make.box("ledge", {-x, -y + depth - 0.28, x, -y + depth}, z - 0.03, z);
  }
  if (style.corner) {
    make.box("body", {x - 0.55, -y + depth, x - 0.03, y - 0.03}, 0, work - plate);
    make.box("top", {x - 0.6, -y + depth, x, y}, work - plate, work);
  }
}

FurnitureClass
counter(const Size& smallest, const Size& largest, const CounterStyle& style)
{
  return styled("counter", smallest, largest, style, buildCounter);
}

} // namespace

std::vector<FurnitureClass>
kitchenShapes()
{
  const Size base_low(0.4, 0.58, 0.82), base_high(1.2, 0.65, 0.92),
      row_low(1.6, 0.58, 1.04), row_high(3.0, 0.66, 1.14);
  const Size long_low(1.6, 0.6, 0.85), long_high(2.4, 0.65, 0.93),
      isle_low(1.2, 0.75, 0.85), isle_high(2.2, 1.1, 0.95);
  const Size upper_low(0.4, 0.28, 0.4), upper_high(1.6, 0.4, 0.9);
  return {
      unit(long_low, long_high, {4, 1, false, 2, false, true}, 0),
      unit(long_low, long_high, {3, 3, true, 3, false, true, false, true}, 0),
      unit(base_low, base_high, {1, 3, true, 1}, 1),
      unit(base_low, base_high, {2, 1, false, 3, false, false, false, true}, 1),
      unit(base_low, base_high, {1, 1, false, 0, true}, 1),
      unit(row_low, row_high, {4, 1, false, 1, false, false, false, false, true}, 2),
      unit(row_low, row_high, {3, 2, true, 3, false, false, false, false, true}, 2),
      unit(isle_low, isle_high, {3, 1, false, 1, false, false, true}, 3),
      unit(isle_low, isle_high, {2, 3, true, 2, false, true, true, true}, 3),
      fitted("upper_cabinet", upper_low, upper_high, roundedCabinet),
      fitted("upper_cabinet", upper_low, upper_high, openCabinet),
      fitted("range_hood", {0.6, 0.45, 0.6}, {0.9, 0.52, 1.0}, chimneyHood),
      fitted("range_hood", {0.6, 0.4, 0.6}, {0.9, 0.5, 0.95}, slantedHood),
      counter({1.2, 0.5, 0.9}, {2.6, 0.8, 1.12}, {}),
      counter({1.6, 1.4, 0.9}, {2.6, 2.0, 1.1}, {true}),
      counter({1.4, 0.7, 1.05}, {2.6, 0.9, 1.2}, {false, true}),
      counter({1.2, 0.45, 0.95}, {2.2, 0.65, 1.1}, {false, false, true}),
      counter({1.6, 0.9, 1.0}, {2.6, 1.3, 1.15}, {false, false, false, true}),
  };
}

} // namespace pcl::indoor
