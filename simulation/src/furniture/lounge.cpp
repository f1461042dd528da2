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

void
feet(PartMaker& make, double x, double y, double z)
{
  cornerPosts(make, "foot", {-x, -y, x - 0.05, y - 0.05}, 0.05, z);
}

// Soft cushions between soft arms.
void
softSofa(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const double arm = draw.uniform(0.12, 0.24), back = draw.uniform(0.16, 0.25);
  const double base = draw.uniform(0.05, 0.14), seat = z * draw.uniform(0.46, 0.54);
  const int seats = partsIn(2 * x - 2 * arm, 0.65);
  feet(make, x - 0.03, y - 0.03, base);
  make.loft("base", {-x, -y, x, y - 0.02}, {{1, base, 0.2}, {1, 0.6 * seat, 0.2}}, 24);
  make.loft("back",
            {-x + 0.5 * arm, -y, x - 0.5 * arm, -y + back},
            {{1, 0.5 * seat, 0.25}, {1, 0.94 * z, 0.25}, {0.85, z, 0.3}},
            24);
  for (const double s : {-x, x - arm})
    make.loft("armrest",
              {s, -y, s + arm, y},
              {{1, base, 0.3}, {1, 0.66 * z, 0.3}, {0.6, 0.72 * z, 0.4}});
  const double width = (2 * x - 2 * arm) / seats;
  for (int i = 0; i < seats; ++i) {
    const double left = -x + arm + i * width;
    make.cushion("cushion", {left, -y + back, left + width, y}, 0.58 * seat, seat);
    if (draw.pick(3) > 0)
      make.cushion(
          "pillow",
          {left + 0.05, -y + 0.7 * back, left + width - 0.05, -y + back + 0.14},
          seat - 0.02,
          0.95 * z);
  }
}

// No arms, on legs.
void
benchSofa(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const double seat = z * draw.uniform(0.48, 0.55), leg = draw.uniform(0.08, 0.2);
  roundLegs(make, x - 0.08, y - 0.08, 0.02, leg, 0.0);
  make.loft("seat",
            {-x, -y, x, y},
            {{0.98, leg, 0.2}, {1, seat - 0.03, 0.2}, {0.97, seat, 0.2}},
            24);
  make.frustum("back", {-x, -y + 0.06, x, -y + 0.24}, seat, {-x, -y, x, -y + 0.14}, z);
  for (int i = draw.pick(4); i > 0; --i) {
    const double left = draw.uniform(-x, x - 0.45);
    make.cushion("pillow",
                 {left, -y + 0.2, left + 0.42, -y + 0.36},
                 seat,
                 std::min(z, seat + 0.38));
  }
}

// An L: the long seat at the rear, another to the front on one side.
void
cornerSofa(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const double deep = std::min(draw.uniform(0.8, 0.95), 0.6 * size.y());
  const double wide = std::min(draw.uniform(0.75, 0.95), 0.45 * size.x());
  const double seat = z * draw.uniform(0.46, 0.54), back = draw.uniform(0.15, 0.24);
  const double side = draw.pick(2) == 0 ? 1.0 : -1.0;
  const auto mirrored = [&](double x0, double y0, double x1, double y1) {
    return side > 0 ? Rectangle{x0, y0, x1, y1} : Rectangle{-x1, y0, -x0, y1};
  };
  make.box("base", mirrored(-x, -y, x, -y + deep), 0.04, 0.6 * seat);
  make.box("base", mirrored(x - wide, -y + deep, x, y), 0.04, 0.6 * seat);
  make.cushion(
      "cushion", mirrored(-x + 0.15, -y + back, x - wide, -y + deep), 0.6 * seat, seat);
  make.cushion("cushion", mirrored(x - wide, -y + back, x - back, y), 0.6 * seat, seat);
  make.loft("back",
            mirrored(-x, -y, x, -y + back),
            {{1, 0.04, 0.2}, {1, 0.95 * z, 0.2}, {0.9, z, 0.2}},
            24);
  if (draw.pick(2) == 0) // a back along the other wall too
    make.loft("back",
              mirrored(x - back, -y + back, x, y),
              {{1, 0.04, 0.2}, {1, 0.95 * z, 0.2}, {0.9, z, 0.2}},
              24);
  make.loft("armrest",
            mirrored(-x, -y + back, -x + 0.17, -y + deep),
            {{1, 0.04, 0.3}, {1, 0.68 * z, 0.3}});
}

// A round tub.
void
tubChair(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const double seat = z * draw.uniform(0.48, 0.56);
  roundLegs(make, 0.75 * x, 0.75 * y, 0.02, 0.12, 0.0);
  make.cushion("seat", {-0.85 * x, -0.8 * y, 0.85 * x, y}, 0.1, seat);
  const int pieces = 10;
  for (int i = 0; i < pieces; ++i) {
    const double a = M_PI * (0.95 + 1.1 * i / pieces),
                 b = M_PI * (0.95 + 1.1 * (i + 1) / pieces);
    const double top = std::sin(a) < -0.4 ? z : 0.78 * z;
    const double mx = 0.5 * (std::cos(a) + std::cos(b)),
                 my = 0.5 * (std::sin(a) + std::sin(b));
    make.loft("back",
              {0.86 * x * mx - 0.17 * x,
               0.86 * y * my - 0.17 * y,
               0.86 * x * mx + 0.17 * x,
               0.86 * y * my + 0.17 * y},
              {{1, 0.1}, {1, top - 0.03}, {0.6, top}},
              8);
  }
  make.join(pieces, "back");
}

// Cushions in an open frame of wood.
void
easyChair(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(), r = 0.022;
  const double seat = z * draw.uniform(0.46, 0.52), arm = z * draw.uniform(0.62, 0.7);
  for (const double s : {-x + r, x - r}) {
    make.rod("leg", {s, y - r, 0}, {s, y - 2 * r, arm}, r);
    make.rod("leg", {s, -y + r, 0}, {s, -y + 5 * r, arm}, r);
    make.box("armrest", {s - r, -y + 0.05, s + r, y}, arm - 0.03, arm);
  }
  make.join(6, "frame");
  make.cushion("seat", {-x + 2 * r, -y + 0.16, x - 2 * r, y - 0.03}, seat - 0.14, seat);
  for (int k = 0; k < 3; ++k) { // a back that leans
    const double z0 = seat - 0.05 + (z - seat) * k / 3, at = -y + 0.16 - 0.05 * k;
    make.cushion("back",
                 {-x + 2 * r, at, x - 2 * r, at + 0.14},
                 z0,
                 std::min(z, z0 + (z - seat) / 2.6));
  }
  make.join(3, "back");
}

void
addPillows(
    PartMaker& make, double x, double y, double top, double most, RandomDraw& draw)
{
  const int pillows = x > 0.62 ? 2 : 1;
  for (int i = 0; i < pillows; ++i) {
    const double width = 2 * (x - 0.08) / pillows, left = -x + 0.08 + i * width;
    make.cushion("pillow",
                 {left, -y + 0.08, left + width - 0.06, -y + draw.uniform(0.4, 0.55)},
                 top - 0.02,
                 std::min(most, top + 0.14));
  }
}

// A mattress on a box, a quilt over it, no headboard.
void
boxBed(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, top = 0.8 * size.z();
  make.box("frame", {-x, -y, x, y}, draw.pick(2) * 0.1, 0.5 * top);
  make.loft("mattress",
            {-x + 0.01, -y, x - 0.01, y},
            {{0.99, 0.5 * top, 0.15}, {1, 0.94 * top, 0.15}, {0.97, top, 0.15}},
            24);
  feet(make, x - 0.05, y - 0.05, 0.1);
  addPillows(make, x, y, top, size.z(), draw);
  if (draw.pick(2) == 0)
    make.cushion("quilt",
                 {-x, draw.uniform(-0.5, 0.2) * y, x, y},
                 0.7 * top,
                 std::min(size.z(), top + 0.08));
}

// Boards at head and foot.
void
frameBed(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               top = draw.uniform(0.42, 0.5);
  const double mattress = std::min(top, 0.75 * z), foot = z * draw.uniform(0.7, 0.95);
  make.box("headboard", {-x, -y, x, -y + 0.04}, 0.15, 0.95 * z);
  make.box("footboard", {-x, y - 0.04, x, y}, 0.15, std::max(foot, 0.2));
  for (const double s : {-x, x - 0.06}) {
    make.box("post", {s, -y, s + 0.06, -y + 0.06}, 0, z);
    make.box("post", {s, y - 0.06, s + 0.06, y}, 0, std::max(foot, 0.2));
    make.box(
        "side", {s, -y + 0.06, s + 0.03, y - 0.06}, 0.5 * mattress, 0.8 * mattress);
  }
  make.box(
      "mattress", {-x + 0.04, -y + 0.05, x - 0.04, y - 0.05}, 0.6 * mattress, mattress);
  addPillows(make, x - 0.04, y - 0.05, mattress, z, draw);
}

// A padded head and a thick quilt.
void
paddedBed(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               top = z * draw.uniform(0.42, 0.5);
  make.loft("headboard",
            {-x, -y, x, -y + 0.12},
            {{1, 0, 0.3}, {1, 0.95 * z, 0.3}, {0.93, z, 0.3}},
            24);
  make.box("frame", {-x, -y + 0.12, x, y}, 0.06, 0.55 * top);
  make.cushion("mattress", {-x + 0.02, -y + 0.1, x - 0.02, y}, 0.5 * top, top);
  make.cushion("quilt", {-x, -0.3 * y, x, y - 0.02}, 0.6 * top, 1.1 * top);
  addPillows(make, x, y - 0.1, top, z, draw);
}

// Two beds above each other, a ladder, sometimes the lower one across.
void
bunkBed(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const double width = std::min(1.0, size.y()), low = 0.4, high = z - 0.4;
  cornerPosts(make, "post", {-x, -y, x - 0.07, -y + width - 0.07}, 0.07, z);
  make.box("mattress",
           {-x + 0.05, -y + 0.05, x - 0.05, -y + width - 0.05},
           high - 0.15,
           high + 0.02);
  make.box("rail",
           {-x + 0.07, -y + width - 0.05, x - 0.5, -y + width - 0.02},
           high + 0.12,
           high + 0.24);
  make.box(
      "rail", {-x + 0.07, -y + 0.02, x - 0.07, -y + 0.05}, high + 0.12, high + 0.24);
  if (size.y() > 1.6) { // across, along the left side
    make.box("frame", {-x, -y, -x + 1.0, y}, 0.2, low - 0.1);
    make.box(
        "mattress", {-x + 0.03, -y + 0.03, -x + 0.97, y - 0.03}, low - 0.1, low + 0.06);
  }
  else {
    make.box("frame", {-x, -y, x, -y + width}, 0.2, low - 0.1);
    make.box("mattress",
             {-x + 0.05, -y + 0.05, x - 0.05, -y + width - 0.05},
             low - 0.1,
             low + 0.06);
  }
  for (const double s : {x - 0.45, x - 0.1})
    make.rod(
        "ladder", {s, -y + width - 0.03, 0}, {s, -y + width - 0.03, high + 0.2}, 0.02);
  for (int i = 1; i < 6; ++i)
    make.rod("ladder",
             {x - 0.45, -y + width - 0.03, i * high / 6},
             {x - 0.1, -y + width - 0.03, i * high / 6},
             0.015);
  make.join(7, "ladder");
  addPillows(make, 0.4, y - 0.05, low + 0.06, z, draw);
}

} // namespace

std::vector<FurnitureClass>
loungeVariants()
{
  return {{"sofa", {1.4, 0.8, 0.75}, {2.4, 1.05, 0.95}, softSofa},
          {"sofa", {1.2, 0.7, 0.7}, {2.2, 0.95, 0.9}, benchSofa},
          {"sofa", {2.0, 1.5, 0.72}, {2.8, 2.0, 0.95}, cornerSofa},
          {"armchair", {0.75, 0.75, 0.75}, {1.1, 1.05, 1.0}, softSofa},
          {"armchair", {0.7, 0.7, 0.7}, {0.95, 0.9, 0.9}, tubChair},
          {"armchair", {0.65, 0.75, 0.8}, {0.8, 0.95, 1.05}, easyChair},
          {"bed", {0.9, 1.9, 0.45}, {2.0, 2.1, 0.65}, boxBed},
          {"bed", {0.95, 2.0, 0.65}, {1.9, 2.2, 1.05}, frameBed},
          {"bed", {1.3, 2.0, 0.8}, {2.05, 2.25, 1.3}, paddedBed},
          {"bunk_bed", {1.95, 0.95, 1.5}, {2.1, 1.0, 1.8}, bunkBed},
          {"bunk_bed", {2.0, 2.0, 1.5}, {2.1, 2.1, 1.75}, bunkBed}};
}

} // namespace pcl::indoor
