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

// Four legs, of which the rear ones go on as posts of a back of slats.
void
slatChair(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2,
               seat = size.z() * draw.uniform(0.48, 0.52);
  const double r = draw.uniform(0.015, 0.022), lean = draw.uniform(0.03, 0.08);
  for (const double side : {-1.0, 1.0}) {
    make.rod("leg", {side * (x - r), y - r, 0}, {side * (x - r), y - r, seat}, r);
    make.rod(
        "leg", {side * (x - r), -y + lean, 0}, {side * (x - r), -y + lean, seat}, r);
    make.rod("post",
             {side * (x - r), -y + lean, seat},
             {side * (x - r), -y + r, size.z()},
             r);
  }
  make.loft(
      "seat", {-x, -y + lean - r, x, y}, {{1, seat, 0.3}, {1, seat + 0.035, 0.3}});
  const int slats = 2 + draw.pick(3);
  for (int i = 0; i < slats; ++i) {
    const double z = seat + 0.12 + (size.z() - seat - 0.2) * i / std::max(1, slats - 1);
    const double at = -y + lean * (1 - (z - seat) / (size.z() - seat));
    make.box("slat", {-x + 2 * r, at, x - 2 * r, at + 0.015}, z, z + 0.06);
  }
}

// A cantilever of bent tubes.
void
sledChair(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2,
               seat = size.z() * draw.uniform(0.5, 0.54);
  const double r = 0.014, top = draw.uniform(0.02, 0.1);
  for (const double s : {-x + r, x - r}) {
    make.rod("frame", {s, -y + 0.03, r}, {s, y - r, r}, r);
    make.rod("frame", {s, y - r, r}, {s, y - 0.05, seat}, r);
    make.rod("frame", {s, y - 0.05, seat}, {s, -y + 0.08, seat}, r);
    make.rod("frame", {s, -y + 0.08, seat}, {s, -y + r, size.z()}, r);
    if (draw.pick(2) == 0)
      make.rod("frame", {s, y - 0.06, seat + 0.2}, {s, -y + 0.05, seat + 0.2}, r);
  }
  make.rod("frame", {-x + r, -y + 0.03, r}, {x - r, -y + 0.03, r}, r);
  make.box("seat", {-x + r, -y + 0.08, x - r, y - 0.06}, seat, seat + 0.03);
  make.frustum("back",
               {-x + r, -y + 0.06, x - r, -y + 0.08},
               seat + 0.15,
               {-x + r, -y + 0.005, x - r, -y + 0.025},
               size.z() - top);
}

// Upholstered, with armrests and a back that reaches down to the seat.
void
armrestChair(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2,
               seat = size.z() * draw.uniform(0.48, 0.54);
  roundLegs(make, x - 0.02, y - 0.02, 0.018, seat - 0.08, 0.0);
  make.cushion("seat", {-x + 0.03, -y + 0.04, x - 0.03, y}, seat - 0.1, seat);
  make.loft("back",
            {-x + 0.02, -y, x - 0.02, -y + 0.09},
            {{1, seat - 0.08, 0.4}, {1, size.z() - 0.03, 0.4}, {0.8, size.z(), 0.4}});
  const double arm = seat + draw.uniform(0.15, 0.22);
  for (const double s : {-x, x - 0.05}) {
    make.loft("armrest",
              {s, -y + 0.05, s + 0.05, y - draw.uniform(0.04, 0.15)},
              {{1, seat - 0.08, 0.4}, {1, arm, 0.4}});
  }
}

// A shell on a column and a disc.
void
shellChair(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2,
               seat = size.z() * draw.uniform(0.52, 0.58);
  make.loft("foot",
            {-0.9 * x, -0.9 * y, 0.9 * x, 0.9 * y},
            {{1, 0}, {0.9, 0.02}, {0.1, 0.04}});
  make.rod("column", {0, 0, 0.03}, {0, 0, seat - 0.04}, 0.025, 8);
  make.cushion("seat", {-x, -y + 0.02, x, y}, seat - 0.06, seat + 0.02);
  const int pieces = 6; // a back that bends around the seat
  for (int i = 0; i < pieces; ++i) {
    const double a0 = M_PI * (1.1 + 0.8 * i / pieces),
                 a1 = M_PI * (1.1 + 0.8 * (i + 1) / pieces);
    for (int k = 0; k < 4; ++k) {
      const double z = seat + (size.z() - seat) * k / 4, r = 0.9 + 0.03 * k;
      make.rod("back",
               {r * x * std::cos(a0), r * y * std::sin(a0), z + 0.05},
               {r * x * std::cos(a1), r * y * std::sin(a1), z + 0.05},
               (size.z() - seat) / 7);
    }
  }
  make.join(4 * pieces, "back");
}

// A bucket on splayed legs.
void
bucketChair(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2,
               seat = size.z() * draw.uniform(0.5, 0.56);
  roundLegs(make, x, y, 0.015, seat - 0.03, draw.uniform(0.04, 0.09));
  make.cushion(
      "seat", {-x + 0.02, -y + 0.03, x - 0.02, y - 0.02}, seat - 0.05, seat + 0.01);
  make.loft("back",
            {-x + 0.04, -y, x - 0.04, -y + 0.12},
            {{0.9, seat - 0.02, 0.6}, {1, seat + 0.2, 0.6}, {0.8, size.z(), 0.7}});
}

void
highChairBack(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2,
               seat = size.z() * draw.uniform(0.4, 0.46);
  const double r = 0.02;
  roundLegs(make, x, y, r, seat, 0.0);
  make.box("seat", {-x, -y, x, y}, seat, seat + 0.04);
  const int bars = 3 + draw.pick(4);
  for (int i = 0; i < bars; ++i) {
    const double at = -x + r + i * (2 * x - 2 * r) / (bars - 1);
    make.rod("bar", {at, -y + r, seat}, {at, -y + r, size.z() - 0.05}, 0.6 * r);
  }
  make.box("rail", {-x, -y, x, -y + 2 * r}, size.z() - 0.08, size.z());
}

void
castorStar(PartMaker& make, double radius, double height)
{
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * M_PI * i / 5;
    const Eigen::Vector2d tip =
        (radius - 0.03) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    make.rod("spoke", {0, 0, 0.1}, {tip.x(), tip.y(), 0.07}, 0.02);
    make.rod("castor", {tip.x(), tip.y(), 0.0}, {tip.x(), tip.y(), 0.06}, 0.025);
  }
  make.join(10, "star");
  make.rod("column", {0, 0, 0.06}, {0, 0, height}, 0.028, 8);
}

void
executiveChair(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2,
               seat = size.z() * draw.uniform(0.38, 0.42);
  castorStar(make, std::min(x, y), seat);
  make.cushion("seat", {-0.85 * x, -0.75 * y, 0.85 * x, 0.9 * y}, seat, seat + 0.12);
  make.loft("back",
            {-0.8 * x, -y, 0.8 * x, -0.65 * y},
            {{0.8, seat + 0.06, 0.4},
             {1, seat + 0.25, 0.4},
             {0.95, 0.93 * size.z(), 0.4},
             {0.6, size.z(), 0.5}});
  for (const double s : {-x, x - 0.07}) {
    make.box("armrest", {s, -0.6 * y, s + 0.07, 0.4 * y}, seat + 0.22, seat + 0.27);
    make.rod("armrest", {s + 0.035, 0, seat + 0.04}, {s + 0.035, 0, seat + 0.22}, 0.02);
  }
}

void
taskChair(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2,
               seat = size.z() * draw.uniform(0.5, 0.56);
  castorStar(make, std::min(x, y), seat);
  make.loft("seat",
            {-0.8 * x, -0.7 * y, 0.8 * x, 0.85 * y},
            {{0.9, seat, 0.5}, {1, seat + 0.06, 0.5}});
  make.rod("spine", {0, -0.6 * y, seat}, {0, -0.9 * y, size.z() - 0.15}, 0.02);
  make.loft(
      "back",
      {-0.7 * x, -y, 0.7 * x, -y + 0.08},
      {{0.7, size.z() - 0.4, 0.6}, {1, size.z() - 0.25, 0.5}, {0.8, size.z(), 0.6}});
}

void
threeLeggedStool(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, splay = draw.uniform(0.5, 0.8);
  for (int i = 0; i < 3; ++i) {
    const double c = std::cos(2.1 * i), s = std::sin(2.1 * i);
    make.rod("leg",
             {0.9 * x * c, 0.9 * y * s, 0},
             {0.9 * splay * x * c, 0.9 * splay * y * s, size.z() - 0.04},
             0.017);
  }
  make.loft("seat",
            {-x, -y, x, y},
            {{0.9, size.z() - 0.05}, {1, size.z() - 0.02}, {0.95, size.z()}});
}

void
pouf(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double corner = draw.pick(2) == 0 ? 1.0 : 0.3, z = size.z();
  make.loft("pouf",
            {-size.x() / 2, -size.y() / 2, size.x() / 2, size.y() / 2},
            {{0.9, 0, corner},
             {1, 0.2 * z, corner},
             {1, 0.85 * z, corner},
             {0.9, z, corner}});
}

void
barStool(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.loft("foot", {-x, -y, x, y}, {{1, 0}, {0.95, 0.015}, {0.15, 0.04}});
  make.rod("column", {0, 0, 0.02}, {0, 0, z - 0.06}, 0.025, 8);
  const bool back = draw.pick(2) == 0;
  const double seat = back ? 0.8 * z : z;
  make.loft("seat",
            {-0.9 * x, -0.9 * y, 0.9 * x, 0.9 * y},
            {{0.9, seat - 0.07}, {1, seat - 0.03}, {0.9, seat}});
  if (back)
    make.loft("back", {-0.8 * x, -y, 0.8 * x, -0.8 * y}, {{1, seat, 0.5}, {1, z, 0.5}});
}

void
bench(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2,
               back = draw.pick(3) == 0 ? 0.45 : 1.0;
  const double seat = size.z() * back;
  for (const double s : {-x + 0.05, x - 0.11})
    make.box("leg", {s, -y + 0.02, s + 0.06, y - 0.02}, 0, seat - 0.04);
  make.box("seat", {-x, -y, x, y}, seat - 0.04, seat);
  if (back < 1.0)
    make.box("back", {-x, -y, x, -y + 0.03}, seat + 0.1, size.z());
}

} // namespace

std::vector<FurnitureClass>
chairVariants()
{
  return {{"chair", {0.38, 0.4, 0.82}, {0.46, 0.48, 1.0}, slatChair},
          {"chair", {0.45, 0.48, 0.8}, {0.55, 0.58, 0.92}, sledChair},
          {"chair", {0.48, 0.46, 0.8}, {0.6, 0.58, 0.95}, armrestChair},
          {"chair", {0.46, 0.46, 0.72}, {0.6, 0.56, 0.85}, shellChair},
          {"chair", {0.44, 0.46, 0.76}, {0.54, 0.55, 0.88}, bucketChair},
          {"chair", {0.4, 0.4, 1.0}, {0.46, 0.46, 1.25}, highChairBack},
          {"office_chair", {0.62, 0.64, 1.05}, {0.72, 0.74, 1.25}, executiveChair},
          {"office_chair", {0.56, 0.56, 0.85}, {0.64, 0.64, 1.0}, taskChair},
          {"stool", {0.3, 0.3, 0.42}, {0.42, 0.42, 0.7}, threeLeggedStool},
          {"stool", {0.38, 0.38, 0.36}, {0.6, 0.6, 0.48}, pouf},
          {"stool", {0.36, 0.36, 0.65}, {0.44, 0.44, 0.95}, barStool},
          {"bench", {1.0, 0.32, 0.42}, {1.7, 0.45, 0.5}, bench}};
}

} // namespace pcl::indoor
