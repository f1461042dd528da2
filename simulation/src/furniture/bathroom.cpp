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
tap(PartMaker& make, double y, double z, double top)
{
  make.rod("tap", {0, y, z}, {0, y, top - 0.015}, 0.014);
  make.rod("tap", {0, y, top - 0.015}, {0, y + 0.12, top - 0.03}, 0.012);
  make.join(2, "tap");
}

// A tub in a case.
void
fittedBath(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, rim = size.z() - 0.12;
  const double corner = draw.uniform(0.35, 0.8);
  make.loft("bath",
            {-x, -y, x, y},
            {{1, 0, 0.02},
             {1, rim, 0.02},
             {0.9, rim, corner},
             {0.8, 0.45 * rim, corner},
             {0.6, 0.25 * rim, corner}},
            32);
  tap(make, -0.9 * y, rim, size.z());
}

// A tub that stands freely.
void
freeBath(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               foot = draw.uniform(0.6, 0.8);
  make.loft(
      "bath",
      {-x, -y, x, y},
      {{foot, 0}, {0.85, 0.4 * z}, {1, z}, {0.93, z}, {0.78, 0.4 * z}, {0.6, 0.2 * z}},
      28);
}

void
cornerBath(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               r = draw.uniform(0.7, 0.85);
  make.loft(
      "bath",
      {-x, -y, x, y},
      {{1, 0, 0.25}, {1, z, 0.25}, {r + 0.08, z}, {r, 0.4 * z}, {0.6 * r, 0.3 * z}},
      32);
}

// A tray, a rail with a head, sometimes screens.
void
shower(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               tray = draw.uniform(0.06, 0.2);
  make.loft("tray",
            {-x, -y, x, y},
            {{1, 0, 0.1}, {1, tray, 0.1}, {0.93, tray, 0.1}, {0.9, 0.4 * tray, 0.15}},
            24);
  const double middle = draw.uniform(-0.5, 0.5) * x;
  make.rod("rail", {middle, -y + 0.05, 0.5 * z}, {middle, -y + 0.05, z - 0.03}, 0.014);
  make.rod("rail", {middle, -y + 0.05, z - 0.03}, {middle, -y + 0.35, z - 0.03}, 0.012);
  make.loft("head",
            {middle - 0.1, -y + 0.25, middle + 0.1, -y + 0.45},
            {{0.9, z - 0.07}, {0.3, z - 0.03}},
            12);
  make.box("mixer", {middle - 0.12, -y, middle + 0.12, -y + 0.07}, 1.0, 1.06);
  const int screens = draw.pick(3);
  if (screens > 0)
    make.box("screen", {x - 0.015, -y, x, y - 0.02}, tray, 0.95 * z);
  if (screens > 1)
    make.box("screen", {-x, y - 0.015, 0.1 * x, y}, tray, 0.95 * z);
}

void
roundToilet(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               seat = std::min(0.95 * z, draw.uniform(0.38, 0.45));
  make.loft("cistern",
            {-x, -y, x, -y + 0.18},
            {{0.9, seat - 0.02, 0.3}, {1, z - 0.03, 0.3}, {0.95, z, 0.3}});
  make.loft("bowl",
            {-0.9 * x, -y + 0.1, 0.9 * x, y},
            {{0.5, 0, 0.8},
             {0.55, 0.4 * seat, 0.8},
             {0.95, 0.85 * seat, 0.8},
             {1, seat, 0.8}});
  make.loft("lid",
            {-0.9 * x, -y + 0.18, 0.9 * x, y},
            {{1, seat, 0.8}, {0.97, seat + 0.03, 0.8}});
}

// Hangs on the wall, the cistern behind it.
void
hungToilet(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const double seat = 0.42, deep = draw.uniform(0.12, 0.2);
  make.box("wall", {-x, -y, x, -y + deep}, 0, z);
  make.loft("bowl",
            {-0.18, -y + deep - 0.02, 0.18, y},
            {{0.5, 0.12, 0.7}, {0.9, 0.3, 0.7}, {1, seat, 0.7}});
  make.box("plate", {-0.12, -y + deep, 0.12, -y + deep + 0.01}, 0.8 * z, 0.95 * z);
}

// A basin in a cabinet.
void
vanity(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, top = size.z() - 0.14,
               low = draw.pick(2) * 0.3;
  make.box("body", {-x + 0.02, -y, x - 0.02, y - 0.06}, low, top - 0.1);
  fronts(make,
         {size.x() - 0.04, size.y() - 0.04, top},
         size.x() > 0.55 ? 2 : 1,
         low + 0.02,
         top - 0.12,
         true);
  make.loft(
      "basin",
      {-x, -y, x, y},
      {{1, top - 0.1, 0.05}, {1, top, 0.05}, {0.85, top, 0.6}, {0.5, top - 0.09, 0.7}},
      28);
  tap(make, -0.85 * y, top, size.z());
}

// Hangs on the wall.
void
wallBasin(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, top = size.z() - 0.12,
               corner = draw.uniform(0.3, 0.9);
  make.loft("basin",
            {-x, -y, x, y},
            {{0.4, 0, corner},
             {0.9, 0.5 * top, corner},
             {1, top, corner},
             {0.9, top, corner},
             {0.5, 0.4 * top, corner}},
            24);
  make.box("bracket", {-0.5 * x, -y, 0.5 * x, -0.8 * y}, 0.1 * top, 0.9 * top);
  tap(make, -0.85 * y, top, size.z());
}

// The sink of a kitchen in its own cabinet, with a draining board.
void
kitchenSink(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, top = size.z() - 0.2,
               low = top - 0.2;
  make.box("plinth", {-x, -y, x, y - 0.07}, 0, 0.1);
  make.box("body", {-x, -y, x, y - 0.05}, 0.1, low);
  fronts(make, {size.x(), size.y() - 0.02, top}, 2, 0.11, top - 0.05, true);
  const double s = draw.pick(2) == 0 ? 0.0 : -x;
  make.loft("basin",
            {s, -y, s + x, y},
            {{1, low, 0.02}, {1, top, 0.02}, {0.85, top, 0.25}, {0.8, low + 0.03, 0.3}},
            24);
  const double d = s < 0 ? 0.0 : -x;
  make.box("board", {d, -y, d + x, y}, low, top);
  tap(make, -0.85 * y, top, size.z());
}

} // namespace

std::vector<FurnitureClass>
bathroomClasses()
{
  return {{"bath", {1.5, 0.7, 0.6}, {1.85, 0.85, 0.75}, fittedBath},
          {"bath", {1.5, 0.7, 0.55}, {1.8, 0.85, 0.65}, freeBath},
          {"bath", {1.3, 1.3, 0.55}, {1.6, 1.6, 0.65}, cornerBath},
          {"shower", {0.78, 0.78, 1.95}, {1.2, 1.0, 2.15}, shower},
          {"toilet", {0.36, 0.65, 0.62}, {0.42, 0.8, 0.85}, roundToilet},
          {"toilet", {0.42, 0.6, 1.0}, {1.0, 0.72, 1.2}, hungToilet},
          {"sink", {0.5, 0.42, 0.92}, {1.1, 0.55, 1.02}, vanity},
          {"sink", {0.4, 0.36, 0.3}, {0.65, 0.52, 0.38}, wallBasin},
          {"sink", {1.0, 0.58, 1.02}, {1.5, 0.65, 1.12}, kitchenSink}};
}

} // namespace pcl::indoor
