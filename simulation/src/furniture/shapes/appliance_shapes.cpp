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

/** A white box with a door, drum or panes. */
struct Appliance {
  int leaves = 1;      ///< doors above each other, 1 or 2
  bool side = false;   ///< doors beside each other
  bool panel = false;  ///< controls along its upper edge
  bool drum = false;   ///< a round window
  bool window = false; ///< a framed pane
  bool rounded = false;
  bool knobs = false;
  bool hob = false;
  bool feet = true;
  bool raised = false;  ///< its rear rises over its top
  bool bulging = false; ///< its doors are bent
};

// A round window about a height.
void
addDrumWindow(PartMaker& make, const Size& size, double middle)
{
  const double y = size.y() / 2;
  const auto ring = arc({0, y - 0.03, middle},
                        {0.32 * size.x(), 0, 0},
                        {0, 0, 0.32 * size.x()},
                        0,
                        1.98 * M_PI,
                        18);
  tube(make, "rim", ring, 0.022, 6);
  sheet(make, "glass", {14, 2, 0.01}, [&](double u, double v) -> P {
    const double r = 0.3 * size.x() * (v + 1) / 2, a = M_PI * u * 0.995;
    return {r * std::cos(a), y - 0.035 + 0.02 * (1 - v) / 2, middle + r * std::sin(a)};
  });
}

// A pane with a handle above it.
void
addPane(PartMaker& make, const Size& size, double low, double high)
{
  const double x = size.x() / 2, y = size.y() / 2;
  make.box("pane",
           {-0.75 * x, y - 0.035, 0.75 * x, y - 0.025},
           low + 0.15 * (high - low),
           high - 0.25 * (high - low));
  tube(make,
       "handle",
       {{-0.8 * x, y - 0.03, high - 0.06},
        {-0.8 * x, y - 0.006, high - 0.06},
        {0.8 * x, y - 0.006, high - 0.06},
        {0.8 * x, y - 0.03, high - 0.06}},
       0.008,
       5);
}

void
frontOf(
    PartMaker& make, const Size& size, const Appliance& style, double low, double high)
{
  const double x = size.x() / 2, y = size.y() / 2;
  const int columns = style.side ? 2 : 1;
  for (int i = 0; i < style.leaves; ++i) {
    const double share = style.leaves == 1 ? 1.0 : 0.35;
    const double z0 = low + (i == 0 ? 0.0 : share) * (high - low),
                 z1 = style.leaves > 1 && i == 0 ? low + share * (high - low) : high;
    for (int k = 0; k < columns; ++k) {
      const double left = -x + k * size.x() / columns,
                   right = left + size.x() / columns;
      const Rectangle r{left + 0.004, y - 0.06, right - 0.004, y - 0.03};
      const double d0 = z0 + 0.004, d1 = z1 - 0.004;
      if (style.bulging)
        sheet(make, "door", {8, 1, 0.02}, [&](double u, double v) -> P {
          return {(r.x0 + r.x1) / 2 + (r.x1 - r.x0) / 2 * u,
                  y - 0.08 + 0.05 * (1 - u * u),
                  d0 + (v + 1) / 2 * (d1 - d0)};
        });
      else if (style.rounded)
        roundBox(make, "door", r, d0, d1, 0.014);
      else
        make.box("door", r, d0, d1);
      const double at = k == 0 && columns == 2 ? right - 0.04 : left + 0.04;
      if (!style.drum && !style.window)
        tube(make,
             "handle",
             {{at, y - 0.03, z0 + 0.06},
              {at, y - 0.007, z0 + 0.08},
              {at, y - 0.007, std::min(z1 - 0.06, z0 + 0.5)},
              {at, y - 0.03, std::min(z1 - 0.04, z0 + 0.52)}},
             0.008,
             5);
    }
  }
  if (style.drum)
    addDrumWindow(make, size, (low + high) / 2);
  if (style.window)
    addPane(make, size, low, high);
}

void
buildAppliance(PartMaker& make,
               const Size& size,
               RandomDraw& draw,
               const Appliance& style)
{
  const double x = size.x() / 2, y = size.y() / 2, low = style.feet ? 0.05 : 0.0,
               top = size.z() - (style.raised ? 0.15
                                 : style.hob  ? 0.02
                                              : 0.0);
  const Rectangle body{-x, -y, x, y - 0.06};
  style.rounded ? roundBox(make, "body", body, low, top, 0.04)
                : make.box("body", body, low, top);
  if (style.raised)
    make.box("rear", {-x, -y, x, -y + 0.05}, top, size.z());
  if (style.feet)
    make.box("plinth", {-x + 0.02, -y, x - 0.02, y - 0.08}, 0, low);
  const double panel = style.panel ? std::min(0.14, 0.2 * top) : 0.0;
  frontOf(make, size, style, low, top - panel);
  if (style.panel) {
    make.frustum("panel",
                 {-x, y - 0.06, x, y - 0.01},
                 top - panel,
                 {-x, y - 0.06, x, y - 0.03},
                 top);
    for (int i = 0; i < (style.knobs ? 5 : 2); ++i)
      ellipsoid(make,
                "knob",
                {(i - 2) * 0.38 * x, y - 0.015, top - panel / 2},
                {0.018, 0.015, 0.018});
    make.join(style.knobs ? 5 : 2, "knobs");
  }
  if (style.hob)
    rings(make, 0, -0.05 * y, top, 0.45 * std::min(x, y) * draw.uniform(0.9, 1.05));
}

FurnitureClass
appliance(const char* name,
          const Size& smallest,
          const Size& largest,
          const Appliance& style)
{
  return styled(name, smallest, largest, style, buildAppliance);
}

} // namespace

std::vector<FurnitureClass>
applianceShapes()
{
  const Size stove_low(0.5, 0.58, 0.84), stove_high(0.7, 0.65, 0.93);
  const Size wash_low(0.58, 0.5, 0.82), wash_high(0.62, 0.65, 0.88),
      dish_low(0.45, 0.58, 0.82), dish_high(0.6, 0.65, 0.87);
  const Size cold_low(0.54, 0.56, 1.2), cold_high(0.75, 0.72, 2.0),
      micro_low(0.42, 0.32, 0.25), micro_high(0.56, 0.44, 0.34);
  const auto drawn = [](int leaves, bool side, bool panel) {
    Appliance a;
    a.leaves = leaves, a.side = side, a.panel = panel;
    return a;
  };
  Appliance drum = drawn(1, false, true), stove = drawn(1, false, true), oven = stove,
            old = drawn(2, false, false), micro;
  drum.drum = true;
  stove.window = stove.knobs = stove.hob = true;
  oven.window = true;
  Appliance wide_stove = stove;
  wide_stove.side = wide_stove.raised = true;
  old.rounded = true;
  micro.feet = false, micro.window = true;
  Appliance round_micro = micro, top_loader = drawn(1, false, true),
            tower = drawn(2, false, true), slim = drawn(1, false, true);
  round_micro.rounded = true;
  micro.panel = true;
  top_loader.rounded = true, top_loader.knobs = true;
  tower.drum = true;
  slim.rounded = true;
  Appliance single = drawn(1, false, false), small_old = single;
  small_old.rounded = true;
  Appliance bent = drawn(2, false, false);
  bent.bulging = true;
  return {
      appliance("cooker", stove_low, stove_high, stove),
      appliance("cooker", {0.55, 0.55, 1.8}, {0.62, 0.62, 2.2}, oven),
      appliance("cooker", {0.9, 0.6, 0.86}, {1.1, 0.68, 0.95}, wide_stove),
      appliance("dishwasher", dish_low, dish_high, drawn(1, false, true)),
      appliance("dishwasher", dish_low, dish_high, slim),
      appliance("fridge", cold_low, cold_high, bent),
      appliance("fridge", cold_low, cold_high, old),
      appliance("fridge", {0.85, 0.65, 1.7}, {0.95, 0.75, 1.9}, drawn(2, true, false)),
      appliance("fridge", {0.5, 0.52, 0.6}, {0.6, 0.6, 0.9}, small_old),
      appliance("microwave", micro_low, micro_high, micro),
      appliance("microwave", micro_low, micro_high, round_micro),
      appliance("washing_machine", wash_low, wash_high, drum),
      appliance("washing_machine", {0.4, 0.55, 0.85}, {0.46, 0.62, 0.92}, top_loader),
      appliance("washing_machine", {0.58, 0.55, 1.6}, {0.64, 0.65, 1.8}, tower),
  };
}

} // namespace pcl::indoor
