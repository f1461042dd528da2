/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/part_maker.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

using Size = Eigen::Vector3d;

// One or two doors or drawers below a worktop.
void
baseCabinet(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.box("plinth", {-x, -y, x, y - 0.07}, 0, 0.1);
  make.box("body", {-x, -y, x, y - 0.05}, 0.1, z - 0.04);
  make.box("worktop", {-x, -y, x, y}, z - 0.04, z);
  const Size front(size.x(), size.y() - 0.02, z);
  if (draw.pick(2) == 0)
    return fronts(make, front, size.x() > 0.65 ? 2 : 1, 0.11, z - 0.05, true);
  for (int i = 0; i < 3; ++i) {
    const double low = 0.11 + i * (z - 0.16) / 3;
    make.box("drawer",
             {-x + 0.004, y - 0.05, x - 0.004, y - 0.03},
             low,
             low + (z - 0.16) / 3 - 0.006);
    make.rod("handle",
             {-0.3 * x, y - 0.02, low + 0.2},
             {0.3 * x, y - 0.02, low + 0.2},
             0.008);
  }
}

// A row of base cabinets with a sink and a hob in its worktop.
void
kitchenRow(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(), tap = 0.22,
               top = z - tap;
  make.box("plinth", {-x, -y, x, y - 0.07}, 0, 0.1);
  make.box("body", {-x, -y, x, y - 0.06}, 0.1, top - 0.2);
  fronts(make,
         {size.x(), size.y() - 0.04, z},
         partsIn(size.x(), 0.55, 2),
         0.11,
         top - 0.05,
         true);
  const double s0 = draw.uniform(-0.8 * x, 0.8 * x - 0.5), s1 = s0 + 0.48;
  make.box("worktop", {-x, -y, s0, y}, top - 0.2, top); // around the sink
  make.box("worktop", {s1, -y, x, y}, top - 0.2, top);
  make.box("worktop", {s0, -y, s1, -0.65 * y}, top - 0.2, top);
  make.box("worktop", {s0, 0.7 * y, s1, y}, top - 0.2, top);
  make.join(4, "worktop");
  make.rod("tap", {s0 + 0.24, -0.8 * y, top}, {s0 + 0.24, -0.8 * y, z - 0.02}, 0.015);
  make.rod(
      "tap", {s0 + 0.24, -0.8 * y, z - 0.02}, {s0 + 0.24, -0.2 * y, z - 0.05}, 0.013);
  make.join(2, "tap");
}

void
upperCabinet(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.box("body", {-x, -y, x, y - 0.04}, 0, z);
  fronts(make, size, partsIn(size.x(), 0.5), 0.005, z - 0.005, draw.pick(2) == 0);
}

void
cooker(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.box("body", {-x, -y, x, y - 0.04}, 0.03, z - 0.03);
  make.box("top", {-x, -y, x, y - 0.02}, z - 0.03, z - 0.01);
  make.box("door", {-x + 0.02, y - 0.04, x - 0.02, y - 0.02}, 0.22, 0.8 * z);
  make.box("drawer", {-x + 0.02, y - 0.04, x - 0.02, y - 0.025}, 0.06, 0.2);
  make.rod(
      "handle", {-0.8 * x, y - 0.01, 0.76 * z}, {0.8 * x, y - 0.01, 0.76 * z}, 0.01);
  for (int i = 0; i < 4; ++i) {
    make.rod("knob",
             {(-0.6 + 0.4 * i) * x, y - 0.05, 0.9 * z},
             {(-0.6 + 0.4 * i) * x, y - 0.01, 0.9 * z},
             0.018);
    const double r = draw.uniform(0.07, 0.1), cx = i % 2 == 0 ? -0.45 * x : 0.45 * x,
                 cy = i < 2 ? -0.45 * y : 0.35 * y;
    make.loft("plate", {cx - r, cy - r, cx + r, cy + r}, {{1, z - 0.01}, {1, z}}, 12);
  }
}

void
dishwasher(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.box("body", {-x, -y, x, y - 0.04}, 0.08, z - 0.03);
  make.box("top", {-x, -y, x, y - 0.02}, z - 0.03, z);
  make.box("door", {-x + 0.01, y - 0.04, x - 0.01, y - 0.02}, 0.12, z - 0.15);
  make.box("panel", {-x + 0.01, y - 0.04, x - 0.01, y - 0.01}, z - 0.14, z - 0.035);
  if (draw.pick(2) == 0)
    make.rod(
        "handle", {-0.6 * x, y - 0.01, z - 0.2}, {0.6 * x, y - 0.01, z - 0.2}, 0.01);
  make.box("plinth", {-x + 0.02, -y, x - 0.02, y - 0.07}, 0, 0.08);
}

// The round door is hollow.
void
washingMachine(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.box("body", {-x, -y, x, y - 0.04}, 0.02, z - 0.02);
  make.box("top", {-x, -y, x, y - 0.03}, z - 0.02, z);
  make.box("panel", {-x + 0.01, y - 0.04, x - 0.01, y - 0.025}, z - 0.15, z - 0.03);
  const double r = draw.uniform(0.16, 0.2), middle = 0.5 * z;
  const int pieces = 14;
  for (int i = 0; i < pieces; ++i) {
    const double a = 2 * M_PI * i / pieces, b = 2 * M_PI * (i + 1) / pieces;
    make.rod("door",
             {r * std::cos(a), y - 0.03, middle + r * std::sin(a)},
             {r * std::cos(b), y - 0.03, middle + r * std::sin(b)},
             0.025);
  }
  make.join(pieces, "door");
  make.rod(
      "knob", {0.6 * x, y - 0.04, z - 0.09}, {0.6 * x, y - 0.005, z - 0.09}, 0.025, 10);
}

void
fridge(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               freezer = draw.uniform(0.3, 0.7) * z;
  make.box("body", {-x, -y, x, y - 0.08}, 0.03, z);
  const bool doors = z > 1.1;
  const double split = doors ? freezer : z;
  const double side = draw.pick(2) == 0 ? 0.8 * x : -0.8 * x;
  make.box("door", {-x, y - 0.08, x, y - 0.03}, 0.05, split - 0.01);
  make.rod(
      "handle", {side, y - 0.015, 0.7 * split}, {side, y - 0.015, 0.93 * split}, 0.012);
  if (doors) {
    make.box("door", {-x, y - 0.08, x, y - 0.03}, split, z);
    make.rod("handle",
             {side, y - 0.015, split + 0.05},
             {side, y - 0.015, split + 0.3},
             0.012);
  }
}

// Two doors side by side.
void
wideFridge(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               split = draw.uniform(-0.2, 0.2) * x;
  make.box("body", {-x, -y, x, y - 0.09}, 0.04, z);
  make.loft("door",
            {-x, y - 0.12, split - 0.003, y - 0.03},
            {{1, 0.05, 0.15}, {1, z - 0.01, 0.15}});
  make.loft("door",
            {split + 0.003, y - 0.12, x, y - 0.03},
            {{1, 0.05, 0.15}, {1, z - 0.01, 0.15}});
  for (const double at : {split - 0.05, split + 0.05})
    make.rod("handle", {at, y - 0.015, 0.35 * z}, {at, y - 0.015, 0.75 * z}, 0.014);
}

// A hood below a chimney.
void
rangeHood(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               low = draw.uniform(0.04, 0.1);
  make.box("rim", {-x, -y, x, y}, 0, low);
  make.frustum("hood",
               {-x, -y, x, y},
               low,
               {-0.15, -y, 0.15, -y + 0.26},
               low + draw.uniform(0.1, 0.25));
  make.box("chimney", {-0.14, -y, 0.14, -y + 0.25}, low + 0.25, z);
}

void
microwave(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.box("body", {-x, -y, x, y - 0.03}, 0.01, z);
  make.box("door", {-x + 0.005, y - 0.03, 0.5 * x, y - 0.015}, 0.02, z - 0.01);
  make.rod(
      "handle", {0.45 * x, y - 0.01, 0.2 * z}, {0.45 * x, y - 0.01, 0.8 * z}, 0.008);
  make.rod("knob",
           {0.75 * x, y - 0.03, draw.uniform(0.2, 0.4) * z},
           {0.75 * x, y - 0.01, 0.3 * z},
           0.02);
}

void
islandCabinet(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               over = draw.uniform(0.0, 0.25);
  make.box("plinth", {-x + 0.05, -y + 0.05 + over, x - 0.05, y - 0.08}, 0, 0.1);
  make.box("body", {-x + 0.02, -y + over, x - 0.02, y - 0.06}, 0.1, z - 0.04);
  make.box("worktop", {-x, -y, x, y}, z - 0.04, z);
  fronts(make,
         {size.x() - 0.04, size.y() - 0.04, z},
         std::max(2, static_cast<int>(size.x() / 0.5)),
         0.11,
         z - 0.05,
         true);
}

} // namespace

std::vector<FurnitureClass>
kitchenClasses()
{
  return {{"kitchen_unit", {0.35, 0.58, 0.82}, {1.0, 0.65, 0.92}, baseCabinet},
          {"kitchen_unit", {1.6, 0.58, 1.04}, {3.2, 0.66, 1.14}, kitchenRow},
          {"kitchen_unit", {1.2, 0.7, 0.85}, {2.0, 1.0, 0.95}, islandCabinet},
          {"upper_cabinet", {0.4, 0.28, 0.55}, {2.2, 0.4, 0.9}, upperCabinet},
          {"cooker", {0.5, 0.58, 0.84}, {0.7, 0.65, 0.92}, cooker},
          {"dishwasher", {0.45, 0.58, 0.82}, {0.6, 0.65, 0.87}, dishwasher},
          {"washing_machine", {0.58, 0.5, 0.82}, {0.62, 0.65, 0.87}, washingMachine},
          {"fridge", {0.54, 0.56, 0.85}, {0.72, 0.7, 2.0}, fridge},
          {"fridge", {0.85, 0.65, 1.7}, {0.95, 0.75, 1.9}, wideFridge},
          {"range_hood", {0.6, 0.45, 0.6}, {0.9, 0.52, 1.0}, rangeHood},
          {"microwave", {0.45, 0.34, 0.26}, {0.55, 0.42, 0.32}, microwave}};
}

} // namespace pcl::indoor
