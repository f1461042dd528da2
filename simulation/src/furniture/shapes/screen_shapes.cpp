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

enum class Foot { Plate, Vee, Ring, Arm, Feet, Pole };

/** A flat screen: how it stands and whether it is bent. */
struct ScreenStyle {
  Foot foot;
  double bend = 0.0;
  bool thick = false;
};

void
buildScreen(PartMaker& make,
            const Size& size,
            RandomDraw& draw,
            const ScreenStyle& style)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               low = style.foot == Foot::Feet ? 0.06 : draw.uniform(0.12, 0.3) * z;
  const double t = style.thick ? 0.05 : 0.022, at = style.bend > 0 ? 0.0 : 0.1 * y;
  sheet(make, "screen", {style.bend > 0 ? 8 : 1, 1, t}, [&](double u, double v) -> P {
    return {x * u, at - style.bend * y * (1 - u * u), low + (v + 1) / 2 * (z - low)};
  });
  roundBox(make,
           "back",
           {-0.4 * x,
            at - t / 2 - 0.04 - style.bend * y,
            0.4 * x,
            at - t / 2 - style.bend * 0.8 * y},
           low + 0.1 * (z - low),
           low + 0.7 * (z - low),
           0.015);
  const double neck = at - t - style.bend * y;
  switch (style.foot) {
  case Foot::Plate:
    roundBox(make, "foot", {-0.35 * x, -y, 0.35 * x, y}, 0, 0.012, 0.005);
    return make.box(
        "neck", {-0.04, neck - 0.04, 0.04, neck}, 0.01, low + 0.3 * (z - low));
  case Foot::Vee:
    for (const double s : {-1.0, 1.0})
      tube(make, "foot", {{0, -y + 0.03, 0.02}, {s * 0.4 * x, y, 0.008}}, 0.012, 4);
    return tube(make,
                "neck",
                {{0, -y + 0.03, 0.01}, {0, neck - 0.02, low + 0.3 * (z - low)}},
                0.02);
  case Foot::Ring:
    tube(make,
         "foot",
         arc({0, 0, 0.01}, {0.3 * x, 0, 0}, {0, 0.95 * y, 0}, 0, 1.98 * M_PI, 14),
         0.01,
         5);
    return tube(make,
                "neck",
                {{0, -0.95 * y, 0.01}, {0, neck - 0.02, low + 0.3 * (z - low)}},
                0.018);
  case Foot::Arm:
    lathe(make,
          "clamp",
          {0.3 * x, -y + 0.03},
          {{0.03, 0}, {0.03, 0.05}, {0.018, 0.05}, {0.018, 0.75 * z}});
    return tube(make,
                "arm",
                {{0.3 * x, -y + 0.03, 0.7 * z},
                 {-0.15 * x, -0.8 * y, 0.7 * z},
                 {0, neck - 0.02, 0.6 * z}},
                0.016);
  case Foot::Feet:
    for (const double s : {-0.7, 0.7})
      make.frustum("foot",
                   {s * x - 0.015, -y, s * x + 0.015, y},
                   0,
                   {s * x - 0.01, at - 0.02, s * x + 0.01, at + 0.02},
                   low + 0.01);
    return;
  case Foot::Pole:
    roundBox(make, "foot", {-0.4 * x, -y, 0.4 * x, y}, 0, 0.04, 0.015);
    return make.box("pole", {-0.05, neck - 0.05, 0.05, neck}, 0.03, 0.9 * z);
  }
}

FurnitureClass
screen(const char* name,
       const Size& smallest,
       const Size& largest,
       const ScreenStyle& style,
       int like = 0)
{
  return styled(name, smallest, largest, style, buildScreen, like);
}

// On a wall: flat or tilted from an arm, with a bar for sound below.
FurnitureClass
wallScreen(double tilt, bool bar)
{
  return fitted(
      "tv",
      {0.7, 0.08, 0.45},
      {1.5, 0.16, 0.95},
      [=](PartMaker& make, const Size& size, RandomDraw&) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
                     low = bar ? 0.12 : 0.0;
        sheet(make, "screen", {1, 1, 0.03}, [&](double u, double v) -> P {
          return {
              x * u, 0.6 * y - tilt * y * (1 - v) / 2, low + (v + 1) / 2 * (z - low)};
        });
        make.box("mount", {-0.2, -y, 0.2, -y + 0.02}, low + 0.3 * z, low + 0.6 * z);
        tube(make,
             "arm",
             {{0, -y + 0.02, low + 0.45 * z},
              {0, 0.6 * y - 0.5 * tilt * y, low + 0.45 * z}},
             0.02);
        if (bar)
          roundBox(make, "bar", {-0.8 * x, -y, 0.8 * x, 0.5 * y}, 0, 0.08, 0.03);
      },
      1);
}

FurnitureClass
laptop(double opening, bool stand)
{
  return fitted(
      "laptop",
      {0.3, 0.24, stand ? 0.28 : 0.1},
      {0.4, 0.34, stand ? 0.4 : 0.26},
      [=](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2, lift = stand ? 0.12 : 0.0,
                     deep =
                         0.9 * size.y() / (1 + std::max(0.0, std::cos(opening) * -1));
        const double wide = deep * draw.uniform(0.95, 1.05);
        roundBox(make, "base", {-x, y - deep, x, y}, lift, lift + 0.018, 0.007);
        sheet(make, "lid", {1, 1, 0.01}, [&](double u, double v) -> P {
          const double t = (v + 1) / 2 * wide;
          return {x * u,
                  y - deep + t * std::cos(opening),
                  lift + 0.02 + t * std::sin(opening)};
        });
        if (stand)
          for (const double s : {-0.6, 0.6})
            tube(make,
                 "stand",
                 {{s * x, y, 0.01}, {s * x, y - deep, 0.01}, {s * x, y, lift}},
                 0.008,
                 4);
      });
}

FurnitureClass
keyboard(bool split)
{
  return fitted(
      "keyboard",
      {0.28, 0.12, 0.02},
      {0.46, split ? 0.24 : 0.16, split ? 0.05 : 0.035},
      [=](PartMaker& make, const Size& size, RandomDraw&) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z();
        if (split)
          return sheet(make, "board", {8, 2, 0.4 * z}, [&](double u, double v) -> P {
            return {x * u,
                    0.6 * y * v - 0.4 * y * (1 - u * u),
                    0.3 * z + 0.5 * z * (1 - std::abs(u))};
          });
        roundBox(make, "board", {-x, -y, x, y}, 0, 0.5 * z, 0.25 * z);
        for (int i = 0; i < 5; ++i)
          make.box(
              "keys",
              {-0.95 * x, y - 0.03 - i * 0.35 * y, 0.95 * x, y - 0.01 - i * 0.35 * y},
              0.5 * z,
              z);
        make.join(5, "keys");
      });
}

// Cases of computers, printers and the like: bodies with slots, trays and lids.
FurnitureClass
machine(const char* name,
        const Size& smallest,
        const Size& largest,
        int trays,
        double slope,
        bool lid)
{
  return fitted(
      name,
      smallest,
      largest,
      [=](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
                     top = lid ? 0.82 * z : z, low = trays > 1 ? 0.03 : 0.0;
        make.frustum(
            "body", {-x, -y, x, y - 0.03}, low, {-x, -y, x, y - 0.03 - slope}, top);
        for (int i = 0; i < trays; ++i)
          roundBox(make,
                   "tray",
                   {-0.85 * x, y - 0.06, 0.85 * x, y},
                   low + 0.02 + i * 0.5 * top / trays,
                   low + (i + 0.8) * 0.5 * top / trays,
                   0.008);
        if (lid) {
          roundBox(make,
                   "lid",
                   {-x, -y, 0.9 * x, y - 0.05 - slope},
                   top,
                   draw.uniform(0.9, 0.95) * z,
                   0.01);
          sheet(make, "feeder", {1, 2, 0.01}, [&](double u, double v) -> P {
            return {0.6 * x * u - 0.2 * x,
                    -0.3 * y - 0.3 * y * v,
                    0.9 * z + 0.05 * z * (v + 1)};
          });
        }
        for (int i = 0; i < 3; ++i)
          make.box("vent",
                   {x - 0.004, -0.7 * y + i * 0.3 * y, x, -0.55 * y + i * 0.3 * y},
                   0.4 * top,
                   0.8 * top);
        make.join(3, "vents");
      });
}

} // namespace

std::vector<FurnitureClass>
screenShapes()
{
  const Size low(0.48, 0.16, 0.38), high(0.7, 0.26, 0.52), wide_low(0.75, 0.2, 0.4),
      wide_high(1.1, 0.3, 0.52), tv_low(0.7, 0.18, 0.45), tv_high(1.5, 0.32, 0.92);
  return {
      screen("monitor", low, high, {Foot::Plate}),
      screen("monitor", low, high, {Foot::Vee}),
      screen("monitor", low, high, {Foot::Arm}),
      screen("monitor", wide_low, wide_high, {Foot::Ring, 0.25}),
      screen("monitor", {0.3, 0.18, 0.5}, {0.36, 0.24, 0.65}, {Foot::Ring}),
      screen("tv", tv_low, tv_high, {Foot::Feet}, 0),
      screen("tv", tv_low, tv_high, {Foot::Plate, 0.2}, 0),
      screen("tv", tv_low, tv_high, {Foot::Pole, 0.0, true}, 0),
      screen("tv", tv_low, tv_high, {Foot::Vee}, 2),
      wallScreen(0.0, true),
      wallScreen(0.8, false),
      laptop(1.95, false),
      laptop(0.35, false),
      laptop(1.8, true),
      keyboard(false),
      keyboard(true),
      machine("computer", {0.16, 0.36, 0.32}, {0.24, 0.5, 0.52}, 2, 0.0, false),
      machine("computer", {0.2, 0.2, 0.05}, {0.36, 0.36, 0.12}, 1, 0.0, false),
      machine("computer", {0.3, 0.42, 0.4}, {0.36, 0.52, 0.5}, 3, 0.04, false),
      machine("printer", {0.42, 0.4, 0.26}, {0.55, 0.5, 0.42}, 2, 0.03, true),
      machine("printer", {0.36, 0.32, 0.15}, {0.48, 0.42, 0.24}, 1, 0.06, false),
      machine("printer", {0.55, 0.55, 0.95}, {0.7, 0.65, 1.2}, 4, 0.02, true),
  };
}

} // namespace pcl::indoor
