/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/part_maker.h"

#include <cmath>

namespace pcl::indoor {

namespace {

// Four upright legs of thickness t, set in by the given distance, up to height z.
void
fourLegs(PartMaker& make, double half_x, double half_y, double t, double z)
{
  cornerPosts(make, "leg", {-half_x, -half_y, half_x - t, half_y - t}, t, z);
}

void
chair(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  const double seat = size.z() * draw.uniform(0.48, 0.54);
  const double lean = size.y() * draw.uniform(0.05, 0.15);
  const double t = 0.035;
  fourLegs(make, x, y - lean / 2, t, seat);
  make.box("seat", {-x, -y + lean / 2, x, y}, seat, seat + 0.04);
  make.frustum("back",
               {-x, -y + lean, x, -y + lean + t},
               seat + 0.04,
               {-x, -y, x, -y + t},
               size.z());
}

void
officeChair(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  const double seat = size.z() * draw.uniform(0.44, 0.5);
  const double radius = std::min(x, y);
  for (int i = 0; i < 5; ++i) { // the star: one slanting spoke towards each castor
    const double angle = 2 * M_PI * i / 5;
    const Eigen::Vector2d tip =
        (radius - 0.035) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    for (int k = 1; k <= 3; ++k)
      make.prism("spoke", tip * (k / 3.0), 0.035, 0.02, 0.03, 0.11 - 0.015 * k, 6);
    make.join(3, "spoke");
  }
  make.prism("column", {0, 0}, 0.03, 0.05, 0.03, seat, 8);
  make.box("seat", {-0.8 * x, -0.7 * y, 0.8 * x, 0.8 * y}, seat, seat + 0.07);
  make.frustum("back",
               {-0.75 * x, -0.75 * y, 0.75 * x, -0.65 * y},
               seat + 0.12,
               {-0.6 * x, -y, 0.6 * x, -0.9 * y},
               size.z());
  if (draw.pick(3) > 0)
    for (const double side : {-1.0, 1.0}) {
      const double inner = std::min(0.8 * side * x, side * x);
      make.box("armrest",
               {inner, -0.4 * y, inner + 0.2 * x, 0.4 * y},
               seat + 0.2,
               seat + 0.24);
      make.box("armrest",
               {inner + 0.08 * x, -0.05, inner + 0.12 * x, 0.05},
               seat + 0.03,
               seat + 0.2);
      make.join(2, "armrest");
    }
}

void
upholstered(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw, int seats)
{
  const double x = size.x() / 2, y = size.y() / 2;
  const double arm = draw.uniform(0.12, 0.2), back = draw.uniform(0.16, 0.24);
  const double base = size.z() * 0.3, seat = size.z() * draw.uniform(0.48, 0.54);
  make.box("base", {-x + arm, -y + back, x - arm, y}, 0.04, base);
  for (int i = 0; i < seats; ++i) {
    const double width = (2 * x - 2 * arm) / seats, left = -x + arm + i * width;
    make.box("cushion", {left, -y + back, left + width - 0.01, y}, base, seat);
  }
  make.frustum("back",
               {-x + arm, -y, x - arm, -y + back},
               0.04,
               {-x + arm, -y, x - arm, -y + 0.6 * back},
               size.z());
  const double armrest = size.z() * draw.uniform(0.66, 0.78);
  make.box("armrest", {-x, -y, -x + arm, y}, 0.04, armrest);
  make.box("armrest", {x - arm, -y, x, y}, 0.04, armrest);
}

void
armchair(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  upholstered(make, size, draw, 1);
}

void
sofa(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  upholstered(make, size, draw, size.x() > 1.9 ? 3 : 2);
}

void
stool(PartMaker& make, const Eigen::Vector3d& size, RandomDraw&)
{
  const double radius = std::min(size.x(), size.y()) / 2;
  make.prism("seat", {0, 0}, radius, size.z() - 0.05, radius, size.z());
  fourLegs(make, 0.7 * radius, 0.7 * radius, 0.03, size.z() - 0.05);
}

void
bed(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  const double top = size.z() * draw.uniform(0.5, 0.6);
  make.box("headboard", {-x, -y, x, -y + 0.05}, 0.0, size.z());
  make.box("frame", {-x, -y + 0.05, x, y}, 0.08, 0.5 * top);
  make.box("mattress", {-x + 0.03, -y + 0.06, x - 0.03, y - 0.03}, 0.5 * top, top);
  const int pillows = size.x() > 1.3 ? 2 : 1;
  for (int i = 0; i < pillows; ++i) {
    const double width = 2 * (x - 0.1) / pillows, left = -x + 0.1 + i * width;
    make.frustum("pillow",
                 {left, -y + 0.1, left + width - 0.08, -y + 0.5},
                 top,
                 {left + 0.08, -y + 0.16, left + width - 0.16, -y + 0.42},
                 top + 0.1);
  }
  cornerPosts(make, "foot", {-x, -y + 0.05, x - 0.06, y - 0.06}, 0.06, 0.08);
}

void
table(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, top = size.z() - 0.03;
  const double t = draw.uniform(0.05, 0.08);
  make.box("top", {-x, -y, x, y}, top, size.z());
  fourLegs(make, x - 0.03, y - 0.03, t, top);
}

void
roundTable(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  const double radius = std::min(size.x(), size.y()) / 2, top = size.z() - 0.03;
  make.prism("top", {0, 0}, radius, top, radius, size.z(), 24);
  make.prism("column", {0, 0}, 0.05, 0.03, 0.05, top, 12);
  const double foot = radius * draw.uniform(0.5, 0.7);
  make.prism("foot", {0, 0}, foot, 0.0, 0.8 * foot, 0.03, 24);
}

void
desk(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, top = size.z() - 0.03;
  make.box("top", {-x, -y, x, y}, top, size.z());
  const bool left = draw.pick(2) == 0;
  const double drawers = draw.uniform(0.38, 0.46);
  const double d0 = left ? -x + 0.02 : x - 0.02 - drawers;
  make.box("drawers", {d0, -y + 0.05, d0 + drawers, y - 0.05}, 0.05, top);
  const double side = left ? x - 0.05 : -x + 0.02;
  make.box("side", {side, -y + 0.02, side + 0.03, y - 0.02}, 0.0, top);
  const double p0 = left ? d0 + drawers : side + 0.03;
  const double p1 = left ? side : d0;
  make.box("panel", {p0, -y + 0.04, p1, -y + 0.06}, 0.35, top); // hides the knees
}

} // namespace

std::vector<FurnitureClass>
seatingClasses()
{
  return {{"chair", {0.42, 0.46, 0.8}, {0.5, 0.54, 0.95}, chair},
          {"office_chair", {0.58, 0.58, 0.92}, {0.68, 0.68, 1.15}, officeChair},
          {"armchair", {0.75, 0.75, 0.75}, {0.95, 0.9, 0.95}, armchair},
          {"sofa", {1.5, 0.8, 0.75}, {2.3, 0.95, 0.9}, sofa},
          {"stool", {0.32, 0.32, 0.44}, {0.4, 0.4, 0.7}, stool},
          {"bed", {0.95, 2.0, 0.8}, {1.85, 2.1, 1.1}, bed}};
}

std::vector<FurnitureClass>
tableClasses()
{
  return {{"table", {1.2, 0.75, 0.72}, {2.0, 1.0, 0.76}, table},
          {"round_table", {0.8, 0.8, 0.7}, {1.2, 1.2, 0.76}, roundTable},
          {"desk", {1.4, 0.7, 0.72}, {1.8, 0.8, 0.76}, desk}};
}

} // namespace pcl::indoor
