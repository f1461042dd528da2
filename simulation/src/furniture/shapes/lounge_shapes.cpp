/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/shapes/solids.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl::indoor {

namespace {

/** How a sofa is put together. */
struct Couch {
  Legs legs = Legs::Plinth;
  int seats = 2;
  bool loose = true;   ///< cushions of its own instead of one body
  double arm = 0.16;   ///< width of an armrest, metres; 0 none
  bool rolled = false; ///< armrests end in rolls
  int corner = 0;      ///< 1 goes on at right angles, 2 has a long seat
  bool pillows = false;
};

// From a seat upwards, before the rear of an extent.
void
backCushions(
    PartMaker& make, const Couch& style, const Rectangle& r, double seat, double top)
{
  const double wide = (r.x1 - r.x0) / style.seats;
  for (int i = 0; i < style.seats; ++i)
    pillow(make,
           "back cushion",
           {{r.x0 + (i + 0.5) * wide, r.y0 + 0.02, (seat + top) / 2 + 0.01},
            {0.49 * wide, 0, 0},
            {0, -0.07, 0.5 * (top - seat)}},
           0.2);
}

// On both sides of an extent.
void
armrests(
    PartMaker& make, const Couch& style, const Rectangle& r, double low, double high)
{
  if (style.arm == 0)
    return;
  const double x = r.x1;
  for (const double s : {-1.0, 1.0}) {
    const double inner = s * (x - style.arm);
    roundBox(make,
             "armrest",
             {std::min(s * x, inner), r.y0, std::max(s * x, inner), r.y1},
             low,
             high,
             style.rolled ? 0.02 : 0.05);
    if (style.rolled)
      tube(make,
           "roll",
           {{s * (x - style.arm / 2), r.y0, high - 0.02},
            {s * (x - style.arm / 2), r.y1 + 0.02, high - 0.02}},
           0.58 * style.arm,
           10);
  }
}

void
buildCouch(PartMaker& make, const Size& size, RandomDraw& draw, const Couch& style)
{
  const double x = size.x() / 2, seat = draw.uniform(0.4, 0.46),
               leg = style.legs == Legs::Skirt ? 0.05 : draw.uniform(0.06, 0.14);
  const double rear = -size.y() / 2,
               depth = style.corner > 0 ? std::min(0.95, 0.6 * size.y()) : size.y();
  const double x0 = -x + style.arm, x1 = x - style.arm, deep = rear + depth,
               arm = draw.uniform(0.55, 0.68);
  legs(make, style.legs, {x - 0.02, depth / 2 - 0.02}, leg, draw);
  make.join(style.legs == Legs::Panels                                ? 3
            : style.legs == Legs::Plinth || style.legs == Legs::Skirt ? 1
            : style.legs == Legs::Sled                                ? 2
                                                                      : 4,
            "legs");
  roundBox(make, "base", {-x, rear, x, deep - 0.02}, leg, seat - 0.12, 0.03);
  roundBox(make,
           "back",
           {-x, rear, x, rear + 0.18},
           leg,
           size.z() - (style.loose ? 0.06 : 0.0),
           0.06);
  const double wide = (x1 - x0) / style.seats;
  for (int i = 0; i < style.seats; ++i)
    roundBox(make,
             "seat",
             {x0 + i * wide + 0.004, rear + 0.16, x0 + (i + 1) * wide - 0.004, deep},
             seat - 0.14,
             seat,
             0.05);
  if (style.loose)
    backCushions(make, style, {x0, rear + 0.26, x1, deep}, seat, size.z());
  armrests(make, style, {-x, rear, x, deep - 0.03}, leg, arm);
  if (style.corner > 0) {
    const double front = size.y() / 2, left = x - std::min(0.95, 0.45 * size.x());
    roundBox(make, "base", {left, deep - 0.03, x, front}, leg, seat - 0.12, 0.03);
    roundBox(make,
             "seat",
             {left, deep, x - (style.corner == 1 ? 0.18 : 0.0), front},
             seat - 0.14,
             seat,
             0.05);
    if (style.corner == 1)
      roundBox(
          make, "back", {x - 0.18, deep - 0.03, x, front}, leg, size.z() - 0.05, 0.06);
  }
  for (int i = style.pillows ? 2 + draw.pick(2) : 0; i > 0; --i) {
    const double at = draw.uniform(0.8 * x0, 0.8 * x1);
    pillow(make,
           "pillow",
           {{at, rear + 0.44, seat + 0.19},
            {0.22, draw.uniform(-0.06, 0.06), 0},
            {0, -0.12, 0.18}},
           0.14);
  }
}

FurnitureClass
couch(const Size& smallest, const Size& largest, const Couch& style)
{
  return styled("sofa", smallest, largest, style, buildCouch);
}

// A mattress on a frame, a back that is a roll: futons and day beds.
void
dayBed(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, seat = draw.uniform(0.38, 0.45);
  legs(make, Legs::Tapered, {x - 0.02, y - 0.02}, seat - 0.16, draw);
  make.box("frame", {-x, -y, x, y}, seat - 0.2, seat - 0.14);
  roundBox(make,
           "mattress",
           {-x + 0.02, -y + 0.02, x - 0.02, y - 0.02},
           seat - 0.14,
           seat,
           0.04);
  for (const double s : {-1.0, 1.0})
    tube(make,
         "bolster",
         {{s * (x - 0.12), -y + 0.05, seat + 0.1},
          {s * (x - 0.12), y - 0.05, seat + 0.1}},
         0.1,
         10);
  sheet(make, "back", {10, 2, 0.04}, [&](double u, double v) -> Eigen::Vector3d {
    return {x * u,
            -y + 0.03,
            seat - 0.1 + (v + 1) / 2 * (size.z() - seat + 0.1) * (1 - 0.25 * u * u)};
  });
}

} // namespace

std::vector<FurnitureClass>
loungeShapes()
{
  const Size two(1.3, 0.8, 0.72), three(2.3, 1.0, 0.95), l_low(1.9, 1.4, 0.72),
      l_high(2.8, 2.0, 0.95);
  return {
      couch(two, three, {Legs::Tapered, 2, true, 0.14}),
      couch(two, three, {Legs::Skirt, 2, true, 0.2, true}),
      couch(two, three, {Legs::Plinth, 3, false, 0.22}),
      couch(two, three, {Legs::Splayed, 3, true, 0.08, false, 0, true}),
      couch(two, three, {Legs::Sled, 2, false, 0.0}),
      couch(l_low, l_high, {Legs::Plinth, 3, true, 0.0, false, 1}),
      couch(l_low, l_high, {Legs::Tapered, 3, true, 0.18, false, 2, true}),
      couch(two, {1.7, 1.0, 0.95}, {Legs::Tapered, 1, true, 0.2, true}),
      fitted("sofa", {1.6, 0.75, 0.75}, {2.1, 0.95, 0.95}, dayBed),
  };
}

} // namespace pcl::indoor
