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

void
tap(PartMaker& make, const P& at, double high, double reach)
{
  tube(make,
       "tap",
       {at,
        at + P(0, 0, 0.8 * high),
        at + P(0, 0.3 * reach, high),
        at + P(0, reach, 0.85 * high)},
       0.013);
  for (const double s : {-1.0, 1.0})
    tube(make,
         "grip",
         {at + P(0, 0, 0.3 * high), at + P(s * 0.05, 0, 0.4 * high)},
         0.01,
         5);
}

/** A tub: its outline, its feet and what is around it. */
struct TubStyle {
  double corner = 0.3, foot = 1.0; ///< of its outline; share of its bottom
  int stands = 0;                  ///< 0 to the floor, 1 on claws, 2 on a step
  double slope = 0.0;              ///< how much higher its head end is, share
  bool screen = false;
};

void
buildTub(PartMaker& make, const Size& size, RandomDraw& draw, const TubStyle& style)
{
  const double x = size.x() / 2, y = size.y() / 2,
               rim = style.screen ? 0.58 : size.z() / (1 + style.slope);
  const double low = style.stands == 1 ? 0.12 : 0.0, wall = draw.uniform(0.05, 0.09),
               c = style.corner;
  std::vector<Path> sections;
  const auto section = [&](double scale, double z, double rise) {
    Path ring;
    for (int i = 0; i < 28; ++i) {
      const double a = 2 * M_PI * (i + 0.5) / 28, ca = std::cos(a), sa = std::sin(a);
      const double px = scale * std::copysign(std::pow(std::abs(ca), c), ca),
                   py = scale * std::copysign(std::pow(std::abs(sa), c), sa);
      ring.push_back({px * x,
                      py * y,
                      z + rise * style.slope * rim * std::pow(std::max(0.0, px), 2)});
    }
    sections.push_back(ring);
  };
  section(style.foot, low, 0);
  section(0.5 * (1 + style.foot), 0.6 * rim, 0.4);
  section(1, rim - 0.03, 1);
  section(1, rim, 1);
  section(1 - 1.2 * wall / y, rim, 1);
  section(0.85 * (1 - wall / y), 0.45 * rim, 0.3);
  section(0.6, low + 0.1, 0);
  skin(make, "tub", sections);
  if (style.stands == 1)
    for (const double sx : {-0.6, 0.6})
      for (const double sy : {-0.5, 0.5})
        ellipsoid(make, "foot", {sx * x, sy * y, 0.08}, {0.05, 0.04, 0.08});
  if (style.stands == 2)
    make.box("step", {-x, y - 0.05, x, y + 0.25}, 0, 0.18);
  tap(make, {-0.9 * x, 0, rim}, 0.15, 0.1);
  if (style.screen)
    make.box("screen", {-x, y - 0.02, -0.1 * x, y - 0.01}, rim, size.z());
}

FurnitureClass
tub(const Size& smallest, const Size& largest, const TubStyle& style)
{
  return styled("bath", smallest, largest, style, buildTub);
}

void
showerHead(PartMaker& make, double y, double z)
{
  tube(make,
       "riser",
       {{0, y + 0.05, 0.9},
        {0, y + 0.05, z - 0.1},
        {0, y + 0.12, z - 0.03},
        {0, y + 0.4, z - 0.03}},
       0.012);
  lathe(make,
        "head",
        {0, y + 0.4},
        {{0.03, z}, {0.1, z - 0.03}, {0.1, z - 0.05}, {0.02, z - 0.05}});
  make.box("mixer", {-0.12, y, 0.12, y + 0.07}, 1.0, 1.06);
}

// A quarter of a circle with bent panes.
void
roundShower(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  Polygon tray{{-x, -y}, {x, -y}};
  for (int i = 0; i <= 6; ++i)
    tray.push_back(
        {-x + 2 * x * std::cos(i * M_PI / 12), -y + 2 * y * std::sin(i * M_PI / 12)});
  tray.erase(tray.begin() + 1);
  make.slab("tray", tray, 0, 0.1);
  sheet(make, "screen", {8, 1, 0.012}, [&](double u, double v) -> P {
    const double a = (u + 1) * M_PI / 4;
    return {-x + 1.95 * x * std::cos(a),
            -y + 1.95 * y * std::sin(a),
            0.1 + (v + 1) / 2 * (z - 0.2)};
  });
  showerHead(make, -y, z);
}

void
curtainShower(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               open = draw.uniform(0.1, 0.6);
  make.loft("tray",
            {-x, -y, x, y},
            {{1, 0, 0.1}, {1, 0.08, 0.1}, {0.9, 0.08, 0.1}, {0.86, 0.03, 0.15}},
            20);
  tube(make, "rail", {{-x, y - 0.02, z - 0.05}, {x, y - 0.02, z - 0.05}}, 0.012);
  sheet(make, "curtain", {30, 3, 0.006}, [&](double u, double v) -> P {
    const double t = (v + 1) / 2;
    return {-x + (u + 1) / 2 * 2 * x * (1 - open),
            y - 0.06 + 0.035 * t * std::sin(26 * u),
            z - 0.05 - t * (z - 0.2)};
  });
  showerHead(make, -y, z);
}

/** A toilet. */
struct ToiletStyle {
  double corner = 0.8; ///< of the bowl's outline
  int cistern = 1;     ///< 0 none, 1 on the bowl, 2 high on the wall
  bool hung = false, lid_up = false, skirt = false;
};

void
buildToilet(PartMaker& make,
            const Size& size,
            RandomDraw& draw,
            const ToiletStyle& style)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               seat = style.cistern == 0 ? z - 0.03 : draw.uniform(0.39, 0.45);
  const double deep = style.cistern == 1 ? 0.18 : 0.02, bowl = std::min(x, 0.2),
               foot = style.skirt ? 0.85 : 0.5, low = style.hung ? 0.13 : 0.0;
  const Rectangle r{-bowl, -y + deep - 0.05, bowl, y};
  make.loft("bowl",
            r,
            {{foot, low, style.corner},
             {foot + 0.08, 0.4 * seat, style.corner},
             {0.95, 0.85 * seat, style.corner},
             {1, seat, style.corner},
             {0.75, seat, style.corner},
             {0.5, 0.7 * seat, style.corner}},
            24);
  if (style.hung)
    make.box("mount", {-0.18, -y, 0.18, -y + deep}, 0.15, 0.4);
  if (style.lid_up)
    sheet(make, "lid", {6, 3, 0.02}, [&](double u, double v) -> P {
      return {bowl * u * (1 - 0.2 * (v + 1) * (v + 1) / 4),
              -y + deep + 0.02 - 0.03 * v,
              seat + 0.02 + (v + 1) * 0.2};
    });
  else
    make.loft("lid",
              {-bowl, -y + deep, bowl, y},
              {{1, seat, style.corner},
               {0.97, seat + 0.025, style.corner},
               {0.7, seat + 0.035, style.corner}},
              24);
  if (style.cistern == 1)
    roundBox(make, "cistern", {-x, -y, x, -y + 0.19}, seat - 0.04, z, 0.03);
  if (style.cistern == 2) {
    roundBox(make, "cistern", {-x, -y, x, -y + 0.2}, z - 0.35, z, 0.03);
    tube(make, "pipe", {{0, -y + 0.05, seat - 0.05}, {0, -y + 0.05, z - 0.34}}, 0.025);
  }
}

FurnitureClass
toilet(const Size& smallest, const Size& largest, const ToiletStyle& style)
{
  return styled("toilet", smallest, largest, style, buildToilet);
}

/** A basin and what carries it. */
struct BasinStyle {
  double corner = 0.8;
  int stand = 0;     ///< 0 a column, 1 a cabinet, 2 a shelf on legs, 3 the wall
  bool bowl = false; ///< stands on the top
  int count = 1;
};

void
buildBasin(PartMaker& make, const Size& size, RandomDraw& draw, const BasinStyle& style)
{
  const double x = size.x() / 2, y = size.y() / 2, top = size.z() - 0.13,
               low = style.stand == 3 ? 0.0 : top - 0.16, c = style.corner;
  const double wide = 2 * x / style.count, rest = style.bowl ? top - 0.13 : top;
  if (style.stand == 1) {
    const double z0 = draw.pick(2) == 0 ? 0.0 : 0.3;
    make.box("body",
             {-x + 0.02, -y, x - 0.02, y - 0.05},
             z0,
             rest - (style.bowl ? 0.03 : 0.14));
    front(
        make,
        {size.x() - 0.04, size.y() - 0.02, size.z()},
        {std::max(1, style.count), 2, true, 1 + draw.pick(3), z0 + 0.02, rest - 0.16});
  }
  if (style.stand == 2)
    legs(make, Legs::Straight, {x - 0.02, y - 0.03}, rest - 0.03, draw);
  if (style.stand == 0)
    lathe(make,
          "column",
          {0, -0.2 * y},
          {{0.11, 0}, {0.1, 0.05}, {0.07, 0.5 * low}, {0.1, low + 0.03}});
  if (style.stand == 1 || style.stand == 2)
    if (style.bowl)
      make.box("top", {-x, -y, x, y}, rest - 0.03, rest);
  for (int i = 0; i < style.count; ++i) {
    const double left = -x + i * wide, middle = left + wide / 2;
    const Rectangle r = style.bowl
                            ? Rectangle{middle - 0.2, -0.5 * y, middle + 0.2, 0.8 * y}
                            : Rectangle{left, -y, left + wide, y};
    const double z0 = style.bowl ? rest : low;
    make.loft("basin",
              r,
              {{style.bowl ? 0.6 : 0.75, z0, c},
               {0.95, z0 + 0.6 * (top - z0), c},
               {1, top, c},
               {0.88, top, c},
               {0.5, z0 + 0.03, c}},
              24);
    tap(make,
        {middle, style.bowl ? -0.7 * y : -0.85 * y, style.bowl ? rest : top},
        size.z() - (style.bowl ? rest : top),
        0.12);
  }
}

FurnitureClass
basin(const Size& smallest, const Size& largest, const BasinStyle& style, int like)
{
  return styled("sink", smallest, largest, style, buildBasin, like);
}

// Of a kitchen: one or two deep basins in a top.
FurnitureClass
deepSink(int basins)
{
  return fitted(
      "sink",
      {0.9, 0.58, 1.02},
      {1.5, 0.65, 1.14},
      [basins](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2, top = size.z() - 0.22,
                     wide = 0.5;
        make.box("plinth", {-x, -y, x, y - 0.07}, 0, 0.1);
        make.box("body", {-x, -y, x, y - 0.04}, 0.1, top - 0.2);
        front(make, size, {2, 1, false, 1 + draw.pick(3), 0.11, top - 0.21});
        for (int i = 0; i < basins; ++i) {
          const double left = -x + i * 2 * wide * x;
          make.loft("basin",
                    {left, -y, left + 2 * wide * x, y},
                    {{1, top - 0.2, 0.02},
                     {1, top, 0.02},
                     {0.84, top, 0.2},
                     {0.8, top - 0.18, 0.25}},
                    24);
        }
        if (basins == 1)
          for (int i = 0; i < 6; ++i)
            make.box("board",
                     {0.02 + i * 0.16 * x,
                      -y,
                      0.02 + (i + 1) * 0.16 * x - (i % 2) * 0.01,
                      y},
                     top - 0.2,
                     top - (i % 2) * 0.01);
        tap(make, {basins == 1 ? -0.5 * x : 0, -0.85 * y, top}, 0.22, 0.18);
      },
      3);
}

} // namespace

std::vector<FurnitureClass>
bathroomShapes()
{
  const Size long_low(1.5, 0.7, 0.55), long_high(1.85, 0.85, 0.68),
      seat_low(0.36, 0.62, 0.75), seat_high(0.42, 0.75, 0.88),
      stand_low(0.45, 0.4, 0.92), stand_high(0.65, 0.52, 1.02);
  return {
      tub(long_low, long_high, {0.9, 0.75, 1}),
      tub(long_low, long_high, {0.8, 0.7, 0, 0.25}),
      tub(long_low, long_high, {0.12, 0.98, 0}),
      tub({1.5, 0.7, 1.9}, {1.8, 0.85, 2.05}, {0.15, 1.0, 0, 0.0, true}),
      tub({1.6, 1.1, 0.55}, {1.9, 1.3, 0.68}, {0.5, 0.95, 2}),
      tub({1.1, 1.1, 0.6}, {1.4, 1.4, 0.8}, {1.0, 0.9, 0}),
      fitted("shower", {0.8, 0.8, 2.0}, {1.0, 1.0, 2.15}, roundShower),
      fitted("shower", {0.8, 0.8, 2.0}, {1.4, 0.95, 2.15}, curtainShower),
      toilet(seat_low, seat_high, {0.8, 1, false, false, true}),
      toilet(seat_low, seat_high, {0.5, 1, false, true, false}),
      toilet({0.36, 0.5, 0.4}, {0.4, 0.58, 0.47}, {0.8, 0, true}),
      toilet({0.36, 0.5, 0.4}, {0.4, 0.58, 0.47}, {0.3, 0, false, false, true}),
      toilet({0.4, 0.6, 1.9}, {0.48, 0.7, 2.1}, {0.8, 2}),
      toilet(seat_low, {0.45, 0.75, 0.95}, {0.3, 1, false, true, true}),
      basin(stand_low, stand_high, {0.9, 0}, 0),
      basin(stand_low, stand_high, {0.3, 0}, 0),
      basin({0.6, 0.45, 0.95}, {1.0, 0.55, 1.05}, {0.9, 1, true}, 1),
      basin({1.1, 0.45, 0.95}, {1.5, 0.55, 1.05}, {0.2, 1, false, 2}, 1),
      basin({0.6, 0.45, 0.95}, {1.0, 0.55, 1.05}, {0.6, 2, true}, 1),
      basin({0.4, 0.36, 0.3}, {0.65, 0.52, 0.4}, {0.2, 3}, 2),
      deepSink(1),
      deepSink(2),
  };
}

} // namespace pcl::indoor
