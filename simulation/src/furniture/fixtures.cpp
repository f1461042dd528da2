/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/part_maker.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

// Hangs on a wall behind it, towards -y.
void
board(PartMaker& make, const Eigen::Vector3d& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2;
  make.box("panel", {-x, -y, x, -0.2 * y}, 0.0, size.z());
  make.box("tray", {-0.6 * x, -0.2 * y, 0.6 * x, y}, 0.0, 0.03);
}

void
floorLamp(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  const double radius = std::min(size.x(), size.y()) / 2;
  const double shade = size.z() - draw.uniform(0.25, 0.35);
  make.prism("foot", {0, 0}, 0.8 * radius, 0.0, 0.75 * radius, 0.03);
  make.prism("pole", {0, 0}, 0.018, 0.03, 0.018, shade + 0.05, 8);
  make.prism("shade", {0, 0}, radius, shade, 0.6 * radius, size.z());
}

void
ceilingLamp(PartMaker& make, const Eigen::Vector3d& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, box = std::min(0.08, 0.5 * size.z());
  make.box("lamp", {-x, -y, x, y}, 0.0, box);
  for (const double side : {-0.7 * x, 0.7 * x})
    make.prism("rod", {side, 0}, 0.012, box, 0.012, size.z(), 6);
}

void
monitor(PartMaker& make, const Eigen::Vector3d& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2;
  make.box("foot", {-0.4 * x, -y, 0.4 * x, y}, 0.0, 0.015);
  make.box("stand", {-0.03, -0.3 * y, 0.03, 0.05 * y}, 0.015, 0.5 * size.z());
  make.box("screen", {-x, 0.05 * y, x, 0.45 * y}, 0.25 * size.z(), size.z());
}

void
radiator(PartMaker& make, const Eigen::Vector3d& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2;
  make.box("plate", {-x, -y, x, 0.4 * y}, 0.12, size.z());
  const int ribs = std::max(2, static_cast<int>(size.x() / 0.1));
  for (int i = 0; i < ribs; ++i) {
    const double left = -x + i * 2 * x / ribs + 0.02;
    make.box("rib", {left, 0.4 * y, left + 0.05, y}, 0.14, size.z() - 0.02);
  }
  make.join(ribs, "ribs");
  make.box("pipe", {x - 0.06, -0.2 * y, x - 0.03, 0.2 * y}, 0.0, 0.12);
}

void
bin(PartMaker& make, const Eigen::Vector3d& size, RandomDraw&)
{
  const double radius = std::min(size.x(), size.y()) / 2;
  make.prism("bin", {0, 0}, 0.8 * radius, 0.0, radius, size.z());
}

void
plant(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  const double radius = std::min(size.x(), size.y()) / 2, pot = 0.25 * size.z();
  make.prism("pot", {0, 0}, 0.45 * radius, 0.0, 0.6 * radius, pot, 12);
  make.prism("stem", {0, 0}, 0.02, pot, 0.015, 0.6 * size.z(), 6);
  const int leaves = 7 + draw.pick(4);
  for (int i = 0; i < leaves; ++i) {
    const double angle = draw.uniform(0.0, 2 * M_PI),
                 r = draw.uniform(0.1, 0.6) * radius;
    const double size_r = draw.uniform(0.2, 0.4) * radius;
    const double z = draw.uniform(0.4, 0.85) * size.z();
    make.prism("leaves",
               r * Eigen::Vector2d(std::cos(angle), std::sin(angle)),
               0.3 * size_r,
               z,
               size_r,
               z + 0.12 * size.z(),
               7);
  }
  make.join(leaves, "leaves");
}

void
toilet(PartMaker& make, const Eigen::Vector3d& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, seat = 0.52 * size.z();
  make.box("cistern", {-x, -y, x, -0.5 * y}, 0.45 * size.z(), size.z());
  make.box("foot", {-0.45 * x, -y, 0.45 * x, 0.4 * y}, 0.0, 0.6 * seat);
  make.prism("bowl", {0, 0.3 * y}, 0.6 * x, 0.5 * seat, 0.9 * x, seat, 16);
}

void
sink(PartMaker& make, const Eigen::Vector3d& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, rim = size.z() - 0.15;
  make.prism("pedestal", {0, -0.3 * y}, 0.4 * y, 0.0, 0.3 * y, rim - 0.15, 12);
  make.frustum(
      "bowl", {-0.6 * x, -y, 0.6 * x, 0.6 * y}, rim - 0.15, {-x, -y, x, y}, rim);
  make.box("tap", {-0.02, -0.85 * y, 0.02, -0.3 * y}, rim + 0.12, size.z());
  make.box("tap", {-0.02, -0.85 * y, 0.02, -0.7 * y}, rim, rim + 0.12);
  make.join(2, "tap");
}

} // namespace

std::vector<FurnitureClass>
fixtureClasses()
{
  return {{"board", {1.5, 0.1, 1.0}, {2.4, 0.1, 1.2}, board},
          {"floor_lamp", {0.35, 0.35, 1.5}, {0.45, 0.45, 1.75}, floorLamp},
          {"ceiling_lamp", {1.1, 0.18, 0.25}, {1.5, 0.25, 0.4}, ceilingLamp},
          {"monitor", {0.5, 0.2, 0.42}, {0.65, 0.24, 0.5}, monitor},
          {"radiator", {0.8, 0.1, 0.6}, {1.4, 0.14, 0.7}, radiator},
          {"bin", {0.26, 0.26, 0.3}, {0.34, 0.34, 0.6}, bin},
          {"plant", {0.5, 0.5, 0.9}, {0.8, 0.8, 1.6}, plant},
          {"toilet", {0.38, 0.64, 0.8}, {0.4, 0.7, 0.85}, toilet},
          {"sink", {0.5, 0.42, 1.05}, {0.6, 0.48, 1.1}, sink}};
}

} // namespace pcl::indoor
