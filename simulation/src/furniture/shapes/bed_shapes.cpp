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

enum class Headboard { None, Board, Bars, Padded, Curved, Shelf };
enum class Cover { Flat, Puffed, Folded, Rumpled };

/** What a bed is made of. */
struct Bedding {
  Headboard head;
  Legs legs;
  Cover cover;
  bool foot = false; ///< a board at its foot, too
};

// Cloth over a mattress that hangs over its sides.
void
bedCover(PartMaker& make,
         Cover kind,
         const Eigen::AlignedBox3d& mattress,
         RandomDraw& draw)
{
  const Eigen::Vector3d m = mattress.center(), h = mattress.sizes() / 2;
  const double top = mattress.max().z(), drop = draw.uniform(0.12, 0.25),
               phase = draw.uniform(0, 6);
  const double share = kind == Cover::Folded    ? 0.55
                       : kind == Cover::Rumpled ? draw.uniform(0.5, 0.8)
                                                : 0.72;
  const double rough = kind == Cover::Rumpled  ? 0.06
                       : kind == Cover::Puffed ? 0.025
                                               : 0.006;
  const double thick = kind == Cover::Puffed ? 0.07 : 0.025;
  sheet(make, "blanket", {14, 12, thick}, [&](double u, double v) -> Eigen::Vector3d {
    const double along = mattress.max().y() + 0.015 - (v + 1) * share * h.y();
    const double over = std::max(0.0, std::abs(u) - 0.85) / 0.15;
    const double wave =
        rough * (1 + std::sin(7 * u + 3 * v + phase) * std::cos(5 * v - 2 * u));
    return {m.x() +
                std::copysign(std::min(1.0, std::abs(u) / 0.85), u) * (h.x() + 0.01) +
                0.02 * over * std::sin(9 * v + phase) * (u > 0 ? 1 : -1),
            along + 0.5 * wave * std::sin(4 * u),
            top + thick / 2 + wave * (1 - over) - drop * over};
  });
  if (kind == Cover::Folded)
    roundBox(make,
             "fold",
             {mattress.min().x(),
              m.y() - 0.15 * h.y(),
              mattress.max().x(),
              m.y() + 0.1 * h.y()},
             top,
             top + 0.1,
             0.045);
}

void
headboard(PartMaker& make, Headboard kind, const Size& size, double low, double y)
{
  const double x = size.x() / 2, high = size.z();
  switch (kind) {
  case Headboard::None:
    return;
  case Headboard::Board:
    return make.box("headboard", {-x, y, x, y + 0.04}, 0, high);
  case Headboard::Bars:
    row(make,
        "bar",
        {{-x + 0.05, y + 0.01, low}, {-x + 0.07, y + 0.03, high - 0.04}},
        {(2 * x - 0.12) / 8, 0, 0},
        9);
    for (const double s : {-x, x - 0.05})
      make.box("post", {s, y, s + 0.05, y + 0.05}, 0, high);
    return tube(make,
                "rail",
                {{-x + 0.02, y + 0.02, high - 0.04},
                 {0, y + 0.02, high - 0.02},
                 {x - 0.02, y + 0.02, high - 0.04}},
                0.018);
  case Headboard::Padded:
    make.box("headboard", {-x, y, x, y + 0.04}, 0, high - 0.02);
    for (int i = 0; i < 4; ++i)
      pillow(make,
             "pad",
             {{(i - 1.5) * x / 2, y + 0.05, (low + high) / 2},
              {0.245 * x, 0, 0},
              {0, 0, (high - low) / 2}},
             0.09);
    return;
  case Headboard::Curved:
    return sheet(
        make, "headboard", {12, 2, 0.05}, [&](double u, double v) -> Eigen::Vector3d {
          return {x * u, y + 0.03, (v + 1) / 2 * high * (1 - 0.25 * u * u)};
        });
  case Headboard::Shelf:
    make.box("headboard", {-x, y, x, y + 0.02}, 0, high);
    make.box("shelf", {-x, y, x, y + 0.2}, high - 0.03, high);
    return make.box("shelf", {-x, y, x, y + 0.2}, low, low + 0.03);
  }
}

void
buildBed(PartMaker& make, const Size& size, RandomDraw& draw, const Bedding& style)
{
  const double x = size.x() / 2, y = size.y() / 2, top = draw.uniform(0.42, 0.58),
               frame = top - 0.18;
  const double head = style.head == Headboard::Shelf ? 0.2 : 0.05;
  legs(make, style.legs, {x - 0.03, y - 0.06}, frame - 0.06, draw);
  make.box(
      "frame", {-x + 0.01, -y + 0.04, x - 0.01, y - 0.01}, frame - 0.08, frame + 0.02);
  const Eigen::AlignedBox3d mattress(Eigen::Vector3d(-x + 0.04, -y + head, frame),
                                     Eigen::Vector3d(x - 0.04, y - 0.04, top));
  roundBox(
      make, "mattress", {-x + 0.04, -y + head, x - 0.04, y - 0.04}, frame, top, 0.05);
  headboard(make, style.head, size, top - 0.05, -y);
  if (style.foot)
    make.box("footboard", {-x, y - 0.03, x, y}, 0, top + 0.1);
  bedCover(make, style.cover, mattress, draw);
  const int places = size.x() > 1.25 ? 2 : 1;
  for (int i = 0; i < places; ++i) {
    const double at = places == 1 ? 0.0 : (i - 0.5) * x;
    const double tilt = draw.pick(3) == 0 ? 0.22 : 0.03; // some lean on the headboard
    pillow(make,
           "pillow",
           {{at, -y + head + 0.25, top + 0.06 + tilt / 2},
            {0.36, draw.uniform(-0.04, 0.04), 0},
            {0, -0.23, tilt}},
           0.16);
  }
}

FurnitureClass
bed(const Size& smallest, const Size& largest, const Bedding& style)
{
  return styled("bed", smallest, largest, style, buildBed);
}

// A small one with bars around it.
void
cot(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               low = draw.uniform(0.3, 0.45) * z;
  cornerPosts(make, "post", {-x, -y, x - 0.04, y - 0.04}, 0.04, z);
  for (const double s : {-x + 0.01, x - 0.03}) {
    row(make,
        "bar",
        {{s, -y + 0.1, 0.6 * low}, {s + 0.018, -y + 0.118, z - 0.04}},
        {0, (2 * y - 0.2) / 10, 0},
        11);
    make.box("rail", {s, -y + 0.04, s + 0.02, y - 0.04}, z - 0.05, z - 0.01);
    make.box("rail", {s, -y + 0.04, s + 0.02, y - 0.04}, 0.5 * low, 0.6 * low);
  }
  for (const double s : {-y, y - 0.03})
    sheet(make, "end", {8, 1, 0.024}, [&](double u, double v) -> Eigen::Vector3d {
      return {x * u,
              s + 0.015,
              0.5 * low + (v + 1) / 2 * (z - 0.5 * low) * (1 - 0.1 * (1 - u * u))};
    });
  roundBox(make,
           "mattress",
           {-x + 0.04, -y + 0.04, x - 0.04, y - 0.04},
           0.6 * low,
           low,
           0.04);
}

/** How a bed over another is reached and what is below. */
struct Bunk {
  bool desk_below = false, wide_below = false, stairs = false, round = false;
};

void
buildBunk(PartMaker& make, const Size& size, RandomDraw& draw, const Bunk& style)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(), upper = z - 0.45,
               rear = style.wide_below ? -y + 0.9 : y;
  const auto mattress = [&](double y1, double top) {
    make.box("frame", {-x, -y, x, y1}, top - 0.26, top - 0.14);
    roundBox(make,
             "mattress",
             {-x + 0.04, -y + 0.04, x - 0.04, y1 - 0.04},
             top - 0.14,
             top,
             0.04);
    pillow(make,
           "pillow",
           {{-x + 0.3, (y1 - y) / 2, top + 0.06}, {0.2, 0, 0}, {0, 0.3, 0}},
           0.14);
  };
  for (const double sx : {-x + 0.03, x - 0.03})
    for (const double sy : {-y + 0.03, rear - 0.03})
      style.round
          ? tube(make, "post", {{sx, sy, 0}, {sx, sy, z}}, 0.028)
          : make.box("post", {sx - 0.03, sy - 0.03, sx + 0.03, sy + 0.03}, 0, z);
  mattress(rear, upper);
  row(make,
      "rail",
      {{-x, rear - 0.04, upper + 0.08}, {0.55 * x, rear - 0.01, upper + 0.15}},
      {0, 0, 0.18},
      2);
  if (style.desk_below) {
    make.box("desk", {-x + 0.05, -y, x - 0.05, -0.1 * y}, 0.71, 0.74);
    row(make, "shelf", {{-x + 0.05, -y, 1.05}, {0, -y + 0.22, 1.07}}, {0, 0, 0.3}, 2);
  }
  else
    mattress(y, draw.uniform(0.42, 0.5));
  if (style.stairs)
    row(make,
        "step",
        {{x - 0.42, rear - 0.3, 0.0}, {x - 0.02, rear - 0.02, 0.3}},
        {0, -0.25, 0.3},
        4);
  else
    row(make,
        "rung",
        {{x - 0.45, rear - 0.02, 0.3}, {x - 0.08, rear + 0.01, 0.33}},
        {0, 0, 0.28},
        std::max(2, static_cast<int>((upper - 0.3) / 0.28)));
}

FurnitureClass
bunk(const Size& smallest, const Size& largest, const Bunk& style)
{
  return styled("bunk_bed", smallest, largest, style, buildBunk);
}

} // namespace

std::vector<FurnitureClass>
bedShapes()
{
  const Size narrow(0.85, 1.95, 0.7), wide(1.85, 2.15, 1.15);
  return {
      bed(narrow, wide, {Headboard::Board, Legs::Straight, Cover::Puffed}),
      bed(narrow, wide, {Headboard::Bars, Legs::Tapered, Cover::Flat, true}),
      bed(narrow, wide, {Headboard::Padded, Legs::Skirt, Cover::Folded}),
      bed(narrow, wide, {Headboard::Curved, Legs::Tapered, Cover::Rumpled, true}),
      bed(narrow, wide, {Headboard::Shelf, Legs::Plinth, Cover::Rumpled}),
      bed(narrow, {1.6, 2.1, 0.7}, {Headboard::None, Legs::Splayed, Cover::Rumpled}),
      bed(narrow, {1.6, 2.1, 0.7}, {Headboard::None, Legs::Skirt, Cover::Puffed}),
      fitted("bed", {0.65, 1.2, 0.8}, {0.8, 1.45, 1.0}, cot),
      bunk({1.95, 0.95, 1.5}, {2.1, 1.05, 1.8}, {false, false, false, true}),
      bunk({1.95, 0.95, 1.7}, {2.1, 1.15, 1.9}, {true}),
      bunk({2.0, 1.4, 1.55}, {2.1, 1.6, 1.8}, {false, true}),
      bunk({2.0, 1.0, 1.55}, {2.4, 1.2, 1.8}, {false, false, true}),
  };
}

} // namespace pcl::indoor
