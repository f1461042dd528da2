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

// A bowl on a pole that lights the ceiling.
void
uplight(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               bowl = draw.uniform(0.06, 0.14);
  make.loft("foot",
            {-0.85 * x, -0.85 * y, 0.85 * x, 0.85 * y},
            {{1, 0}, {0.9, 0.02}, {0.15, 0.04}});
  make.rod("pole", {0, 0, 0.03}, {0, 0, z - bowl}, draw.uniform(0.01, 0.02), 8);
  make.vessel("bowl", {-x, -y, x, y}, z - bowl, z, 0.3, 1.0);
}

void
tripodLamp(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               low = z - draw.uniform(0.25, 0.4);
  for (int i = 0; i < 3; ++i)
    make.rod("leg",
             {0.9 * x * std::cos(2.1 * i), 0.9 * y * std::sin(2.1 * i), 0},
             {0.02 * std::cos(2.1 * i), 0.02 * std::sin(2.1 * i), low},
             0.015);
  make.shade(
      {-0.8 * x, -0.8 * y, 0.8 * x, 0.8 * y}, low - 0.02, z, draw.uniform(0.7, 1.0));
}

// An arc from a heavy foot.
void
arcLamp(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               foot = std::min(0.15, y);
  make.loft("foot", {-x, -foot, -x + 2 * foot, foot}, {{1, 0}, {1, 0.05}});
  Eigen::Vector3d last(-x + foot, 0, 0.04);
  const int pieces = 8;
  for (int i = 1; i <= pieces; ++i) {
    const double t = 0.75 * M_PI * i / pieces;
    const Eigen::Vector3d next(-x + foot +
                                   (2 * x - 2 * foot) * 0.58 * (1 - std::cos(t)),
                               0,
                               (z - 0.02) * std::sin(std::min(t, M_PI / 2)) -
                                   (t > M_PI / 2 ? 0.2 * (t - M_PI / 2) : 0));
    make.rod("arc", last, next, 0.014);
    last = next;
  }
  make.join(pieces, "arc");
  const double r = draw.uniform(0.12, 0.2);
  make.shade({last.x() - r, -r, last.x() + r, r}, last.z() - 0.2, last.z(), 0.3);
}

// A shade on a foot, for tables.
void
tableLamp(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               low = z * draw.uniform(0.45, 0.65);
  const double belly = draw.uniform(0.15, 0.55);
  make.loft("foot",
            {-0.6 * x, -0.6 * y, 0.6 * x, 0.6 * y},
            {{0.9, 0},
             {0.8, 0.03 * z},
             {belly, 0.1 * z},
             {1.3 * belly, 0.25 * z},
             {0.1, low}});
  make.rod("stem", {0, 0, 0.9 * low}, {0, 0, low + 0.2 * z}, 0.008);
  make.shade({-x, -y, x, y}, low, z, draw.uniform(0.5, 0.95));
}

// An arm with a joint and a small shade.
void
workLamp(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               elbow = draw.uniform(0.5, 0.75) * z;
  const double r = std::min(x, 0.09);
  make.loft("foot", {-r, -y, r, -y + 2 * r}, {{1, 0}, {0.9, 0.025}});
  make.rod("arm", {0, -y + r, 0.02}, {0, -0.9 * y, elbow}, 0.01);
  make.rod("arm", {0, -0.9 * y, elbow}, {0, 0.4 * y, z - 0.04}, 0.01);
  make.shade({-r, y - 2 * r, r, y}, z - 0.14, z, 0.3);
}

// On a cord.
void
pendantLamp(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               high = std::min(0.8 * z, draw.uniform(0.8, 1.4) * x);
  make.shade({-x, -y, x, y}, 0, high, draw.uniform(0.15, 0.9));
  make.rod("cord", {0, 0, 0.9 * high}, {0, 0, z - 0.04}, 0.008);
  make.loft("rose", {-0.06, -0.06, 0.06, 0.06}, {{0.4, z - 0.05}, {1, z}}, 10);
}

void
globeLamp(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               d = std::min(2 * std::min(x, y), 0.9 * z) * draw.uniform(0.95, 1.0);
  make.loft("globe", {-d / 2, -d / 2, d / 2, d / 2}, ballSections(d));
  make.rod("cord", {0, 0, 0.97 * d}, {0, 0, z}, 0.008);
}

// Flat below the ceiling.
void
flushLamp(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               corner = draw.pick(2) == 0 ? 1.0 : 0.2;
  make.loft(
      "lamp",
      {-x, -y, x, y},
      {{0.5, 0, corner}, {0.85, 0.3 * z, corner}, {1, 0.7 * z, corner}, {1, z, corner}},
      20);
}

// Arms in a ring.
void
chandelier(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const int arms = 5 + draw.pick(4);
  const double ring = 0.15 * z;
  make.rod("cord", {0, 0, ring}, {0, 0, z}, 0.015);
  for (int i = 0; i < arms; ++i) {
    const double a = 2 * M_PI * i / arms, b = 2 * M_PI * (i + 1) / arms;
    const Eigen::Vector3d p(0.88 * x * std::cos(a), 0.88 * y * std::sin(a), ring),
        q(0.88 * x * std::cos(b), 0.88 * y * std::sin(b), ring);
    make.rod("arm", {0, 0, 0.8 * ring}, p, 0.012);
    make.rod("ring", p, q, 0.012);
    make.loft("candle",
              {p.x() - 0.04, p.y() - 0.04, p.x() + 0.04, p.y() + 0.04},
              {{0.9, ring}, {0.7, ring + 0.15 * z}, {0.4, ring + 0.25 * z}},
              8);
  }
}

// Heads on a rail.
void
railLamp(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.box("rail", {-x, -0.3 * y, x, 0.3 * y}, 0.8 * z, z);
  const int heads = 2 + draw.pick(3);
  for (int i = 0; i < heads; ++i) {
    const double at = -0.8 * x + 1.6 * x * i / (heads - 1),
                 tilt = draw.uniform(-0.5, 0.5) * y;
    make.rod("head", {at, tilt, 0.02}, {at, 0, 0.6 * z}, std::min(0.04, 0.5 * y), 8);
    make.rod("joint", {at, 0, 0.6 * z}, {at, 0, 0.8 * z}, 0.01);
  }
}

// A half bowl on the wall.
void
wallUplight(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               low = draw.uniform(0.2, 0.6);
  make.loft("bowl",
            {-x, -y, x, y},
            {{low, 0, 0.7},
             {1, 0.8 * z, 0.7},
             {1, z, 0.7},
             {0.85, z, 0.7},
             {0.7 * low, 0.2 * z, 0.7}});
  make.box("plate", {-0.3 * x, -y, 0.3 * x, -0.8 * y}, 0.1 * z, 0.9 * z);
}

void
spotlight(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.loft(
      "plate", {-0.8 * x, -y, 0.8 * x, -0.6 * y}, {{1, 0.2 * z}, {1, 0.8 * z}}, 12);
  make.rod("arm", {0, -0.7 * y, 0.5 * z}, {0, -0.1 * y, 0.6 * z}, 0.01);
  make.rod("head",
           {0, -0.2 * y, 0.8 * z},
           {0, 0.6 * y, draw.uniform(0.3, 0.6) * z},
           0.7 * x,
           10);
}

} // namespace

std::vector<FurnitureClass>
lampClasses()
{
  return {{"floor_lamp", {0.25, 0.25, 1.6}, {0.4, 0.4, 1.9}, uplight},
          {"floor_lamp", {0.4, 0.4, 1.4}, {0.6, 0.6, 1.75}, tripodLamp},
          {"floor_lamp", {1.0, 0.4, 1.7}, {1.5, 0.45, 2.1}, arcLamp},
          {"table_lamp", {0.2, 0.2, 0.3}, {0.45, 0.45, 0.75}, tableLamp},
          {"table_lamp", {0.12, 0.28, 0.35}, {0.2, 0.45, 0.55}, workLamp},
          {"ceiling_lamp", {0.25, 0.25, 0.4}, {0.65, 0.65, 0.9}, pendantLamp},
          {"ceiling_lamp", {0.25, 0.25, 0.35}, {0.5, 0.5, 0.8}, globeLamp},
          {"ceiling_lamp", {0.25, 0.25, 0.08}, {0.55, 0.55, 0.16}, flushLamp},
          {"ceiling_lamp", {0.6, 0.6, 0.5}, {0.95, 0.95, 0.9}, chandelier},
          {"ceiling_lamp", {0.6, 0.12, 0.15}, {1.2, 0.16, 0.25}, railLamp},
          {"wall_lamp", {0.2, 0.1, 0.15}, {0.35, 0.16, 0.3}, wallUplight},
          {"wall_lamp", {0.08, 0.12, 0.12}, {0.13, 0.2, 0.22}, spotlight}};
}

} // namespace pcl::indoor
