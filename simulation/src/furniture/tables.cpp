/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/part_maker.h"

#include <algorithm>

namespace pcl::indoor {

namespace {

using Size = Eigen::Vector3d;

void
panelTable(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, t = draw.uniform(0.025, 0.05),
               top = size.z() - t;
  const double in = draw.uniform(0.0, 0.15);
  make.box("top", {-x, -y, x, y}, top, size.z());
  for (const double s : {-x + in, x - in - t})
    make.box("panel", {s, -y + 0.03, s + t, y - 0.03}, 0, top);
  make.box("rail", {-x + in + t, -0.01, x - in - t, 0.01}, 0.6 * top, top);
}

void
roundLegTable(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, t = draw.uniform(0.02, 0.04),
               top = size.z() - t;
  const double r = draw.uniform(0.02, 0.045), in = draw.uniform(0.02, 0.12);
  make.loft("top", {-x, -y, x, y}, {{1, top, 0.12}, {1, size.z(), 0.12}}, 32);
  roundLegs(make, x - 0.02, y - 0.02, r, top, in);
  if (draw.pick(2) == 0 && size.z() > 0.5) // an apron below the top
    for (const double s : {-1.0, 1.0}) {
      const double at = s * (y - 0.09 - in);
      make.box("apron",
               {-x + 0.1 + in, at - 0.01, x - 0.1 - in, at + 0.01},
               top - 0.08,
               top);
    }
}

void
columnTable(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, top = size.z() - 0.03;
  make.box("top", {-x, -y, x, y}, top, size.z());
  const int columns = size.x() > 1.3 ? 2 : 1;
  const double r = draw.uniform(0.03, 0.06);
  for (int i = 0; i < columns; ++i) {
    const double at = columns == 1 ? 0.0 : (i == 0 ? -0.6 : 0.6) * x;
    make.rod("column", {at, 0, 0.03}, {at, 0, top}, r, 10);
    make.box("foot", {at - 0.04, -0.8 * y, at + 0.04, 0.8 * y}, 0, 0.04);
  }
}

void
trestleTable(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, top = size.z() - 0.025, r = 0.018;
  make.box("top", {-x, -y, x, y}, top, size.z());
  const double at = draw.uniform(0.6, 0.75) * x;
  for (const double s : {-at, at})
    for (const double side : {-1.0, 1.0}) {
      make.rod("leg", {s - 0.12, side * (0.9 * y), 0}, {s, side * (0.85 * y), top}, r);
      make.rod("leg", {s + 0.12, side * (0.9 * y), 0}, {s, side * (0.85 * y), top}, r);
    }
}

void
roundFourLegs(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, top = size.z() - 0.03;
  make.loft("top", {-x, -y, x, y}, {{1, top}, {1, size.z()}}, 24);
  roundLegs(make, 0.75 * x, 0.75 * y, 0.025, top, draw.uniform(0.0, 0.1));
}

void
ovalTable(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.loft("top", {-x, -y, x, y}, {{0.97, z - 0.04}, {1, z - 0.02}, {1, z}}, 28);
  const double r = std::min(x, y);
  make.loft("column",
            {-0.6 * r, -0.6 * r, 0.6 * r, 0.6 * r},
            {{1, 0},
             {0.9, 0.04},
             {0.2, 0.12},
             {draw.uniform(0.12, 0.25), 0.5 * z},
             {0.3, z - 0.04}});
}

void
metalDesk(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, top = size.z() - 0.025, t = 0.04;
  make.box("top", {-x, -y, x, y}, top, size.z());
  for (const double s : {-x + 0.05, x - 0.05 - t}) {
    make.box("foot", {s, -y + 0.03, s + t, y - 0.03}, 0, 0.03);
    make.box("leg", {s, -0.06, s + t, 0.06}, 0.03, top);
  }
  if (draw.pick(2) == 0)
    make.box("panel", {-x + 0.1, -0.6 * y, x - 0.1, -0.6 * y + 0.015}, 0.4, top);
  if (draw.pick(2) == 0)
    make.box("drawers", {x - 0.5, -0.7 * y, x - 0.1, 0.8 * y}, 0.05, 0.8 * top);
}

// A top on two blocks of drawers, sometimes shelves over its rear.
void
writingDesk(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, top = size.z() - 0.03;
  make.box("top", {-x, -y, x, y}, top, size.z());
  const double width = std::min(draw.uniform(0.32, 0.42), 0.6 * x);
  const bool both = draw.pick(2) == 0;
  make.box("drawers", {-x + 0.02, -y + 0.02, -x + width, y - 0.03}, 0.04, top);
  for (int i = 0; i < 3; ++i)
    make.box("front",
             {-x + 0.03, y - 0.03, -x + width - 0.01, y - 0.01},
             0.06 + i * top / 3.2,
             0.03 + (i + 1) * top / 3.2);
  if (both)
    make.box("drawers", {x - width, -y + 0.02, x - 0.02, y - 0.03}, 0.04, top);
  else
    make.box("side", {x - 0.04, -y + 0.02, x - 0.01, y - 0.02}, 0, top);
}

void
boxCoffeeTable(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               t = draw.uniform(0.03, 0.06);
  make.box("top", {-x, -y, x, y}, z - t, z);
  make.box("shelf", {-x + t, -y + 0.02, x - t, y - 0.02}, 0.25 * z, 0.25 * z + 0.02);
  for (const double s : {-x, x - t})
    make.box("side", {s, -y, s + t, y}, 0, z - t);
}

void
drumTable(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               waist = draw.uniform(0.3, 1.0);
  make.loft(
      "table", {-x, -y, x, y}, {{0.8, 0}, {waist, 0.5 * z}, {1, 0.9 * z}, {1, z}}, 20);
}

void
tieredTable(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               corner = draw.pick(2) == 0 ? 1.0 : 0.1;
  make.loft("top", {-x, -y, x, y}, {{1, z - 0.025, corner}, {1, z, corner}}, 24);
  make.loft("shelf",
            {-0.8 * x, -0.8 * y, 0.8 * x, 0.8 * y},
            {{1, 0.3 * z, corner}, {1, 0.3 * z + 0.02, corner}},
            24);
  roundLegs(make, 0.72 * x, 0.72 * y, 0.02, z - 0.025, 0.0);
}

void
nightstand(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               leg = draw.uniform(0.02, 0.45) * z;
  cornerPosts(make, "leg", {-x, -y, x - 0.03, y - 0.05}, 0.03, leg);
  make.box("body", {-x, -y, x, y - 0.02}, leg, z);
  const int count = leg > 0.25 * z ? 1 : 2;
  const double pitch = (z - leg) / count;
  for (int i = 0; i < count; ++i) {
    make.box("drawer",
             {-x + 0.01, y - 0.02, x - 0.01, y - 0.01},
             leg + i * pitch + 0.01,
             leg + (i + 1) * pitch - 0.01);
    make.box("knob",
             {-0.015, y - 0.01, 0.015, y},
             leg + (i + 0.5) * pitch,
             leg + (i + 0.5) * pitch + 0.02);
  }
}

} // namespace

std::vector<FurnitureClass>
tableVariants()
{
  return {{"table", {1.1, 0.65, 0.72}, {2.2, 1.1, 0.78}, panelTable},
          {"table", {0.7, 0.6, 0.7}, {2.0, 1.1, 0.78}, roundLegTable},
          {"table", {0.7, 0.7, 0.72}, {2.4, 1.2, 0.78}, columnTable},
          {"table", {1.2, 0.6, 0.7}, {1.8, 0.9, 0.76}, trestleTable},
          {"round_table", {0.7, 0.7, 0.68}, {1.3, 1.3, 0.76}, roundFourLegs},
          {"round_table", {0.8, 0.7, 0.7}, {1.7, 1.1, 0.77}, ovalTable},
          {"desk", {1.1, 0.55, 0.7}, {1.9, 0.9, 0.78}, metalDesk},
          {"desk", {1.1, 0.5, 0.72}, {1.7, 0.8, 0.78}, writingDesk},
          {"coffee_table", {0.7, 0.45, 0.35}, {1.4, 0.8, 0.5}, roundLegTable},
          {"coffee_table", {0.8, 0.5, 0.3}, {1.4, 0.8, 0.48}, boxCoffeeTable},
          {"coffee_table", {0.4, 0.4, 0.35}, {0.9, 0.9, 0.5}, drumTable},
          {"coffee_table", {0.45, 0.45, 0.4}, {1.0, 0.8, 0.6}, tieredTable},
          {"bedside_table", {0.36, 0.34, 0.45}, {0.55, 0.45, 0.62}, nightstand},
          {"bedside_table", {0.36, 0.36, 0.45}, {0.48, 0.48, 0.6}, tieredTable}};
}

} // namespace pcl::indoor
