/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/part_maker.h"

#include <algorithm>

namespace pcl::indoor {

namespace {

// Two sides, a bottom, a top and a back wall of thickness t around the given box.
void
carcass(PartMaker& make, const Eigen::Vector3d& size, double t)
{
  const double x = size.x() / 2, y = size.y() / 2;
  make.box("side", {-x, -y, -x + t, y}, 0.0, size.z());
  make.box("side", {x - t, -y, x, y}, 0.0, size.z());
  make.box("back", {-x + t, -y, x - t, -y + 0.01}, 0.0, size.z());
  make.box("top", {-x + t, -y + 0.01, x - t, y}, size.z() - t, size.z());
}

void
bookcase(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, t = 0.022;
  carcass(make, size, t);
  const int shelves = partsIn(size.z(), 0.36);
  const double pitch = (size.z() - t) / shelves;
  for (int i = 0; i < shelves; ++i) {
    const double z = 0.02 + i * pitch;
    make.box("shelf", {-x + t, -y + 0.01, x - t, y}, z, z + t);
    double left = -x + t + draw.uniform(0.0, 0.2);
    int books = 0;
    while (left < x - t - 0.06 && draw.uniform() < 0.93) {
      const double width = std::min(draw.uniform(0.03, 0.09), x - t - left);
      const double front = y - draw.uniform(0.02, 0.3 * size.y());
      const double height = pitch * draw.uniform(0.55, 0.82);
      make.box("book", {left, -y + 0.012, left + width, front}, z + t, z + t + height);
      left += width;
      ++books;
    }
    if (books > 0)
      make.join(books, "books");
  }
}

void
cabinet(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  make.box("plinth", {-x + 0.02, -y, x - 0.02, y - 0.06}, 0.0, 0.08);
  make.box("body", {-x, -y, x, y - 0.04}, 0.08, size.z());
  const int doors = partsIn(size.x(), 0.5);
  const double width = size.x() / doors;
  const double gap = draw.uniform(0.003, 0.008);
  for (int i = 0; i < doors; ++i) {
    const double left = -x + i * width;
    make.box("door",
             {left + gap, y - 0.04, left + width - gap, y - 0.02},
             0.1,
             size.z() - 0.02);
    const double handle = i % 2 == 0 ? left + width - 0.07 : left + 0.05;
    make.box("handle",
             {handle, y - 0.02, handle + 0.02, y},
             0.5 * size.z(),
             0.5 * size.z() + 0.14);
  }
}

void
drawers(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  make.box("body", {-x, -y, x, y - 0.04}, 0.0, size.z());
  const int count = 2 + draw.pick(3);
  const double pitch = (size.z() - 0.06) / count;
  for (int i = 0; i < count; ++i) {
    const double z = 0.04 + i * pitch;
    make.box("drawer", {-x + 0.01, y - 0.04, x - 0.01, y - 0.02}, z, z + pitch - 0.02);
    make.box("handle", {-0.08, y - 0.02, 0.08, y}, z + pitch / 2, z + pitch / 2 + 0.02);
  }
}

void
kitchenUnit(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, top = size.z() - 0.04;
  make.box("plinth", {-x, -y, x, y - 0.08}, 0.0, 0.1);
  make.box("body", {-x, -y, x, y - 0.05}, 0.1, top);
  const int doors = partsIn(size.x(), 0.6);
  const double width = size.x() / doors;
  for (int i = 0; i < doors; ++i)
    make.box("door",
             {-x + i * width + 0.005, y - 0.05, -x + (i + 1) * width - 0.005, y - 0.03},
             0.12,
             top - 0.02);
  make.box("worktop", {-x, -y, x, y}, top, size.z() - 0.004);
  if (draw.pick(2) == 0)
    make.box("hob", {-x + 0.05, -0.2, -x + 0.55, 0.2}, size.z() - 0.004, size.z());
}

void
wardrobeRack(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  const int boards = 4 + draw.pick(2);
  cornerPosts(make, "post", {-x, -y, x - 0.04, y - 0.04}, 0.04, size.z());
  for (int i = 0; i < boards; ++i) {
    const double z = 0.1 + i * (size.z() - 0.16) / boards;
    make.box("shelf", {-x + 0.002, -y + 0.002, x - 0.002, y - 0.002}, z, z + 0.03);
    if (draw.pick(3) == 0)
      continue;
    const double left = draw.uniform(-x + 0.06, -0.1), width = draw.uniform(0.25, 0.4);
    const double height = (size.z() - 0.16) / boards * draw.uniform(0.4, 0.8);
    make.box("crate",
             {left, -y + 0.05, std::min(left + width, x - 0.05), y - 0.05},
             z + 0.03,
             z + 0.03 + height);
  }
}

} // namespace

std::vector<FurnitureClass>
storageClasses()
{
  return {{"bookcase", {0.8, 0.28, 1.7}, {1.2, 0.36, 2.1}, bookcase},
          {"cabinet", {0.8, 0.42, 1.0}, {1.2, 0.5, 1.9}, cabinet},
          {"drawers", {0.4, 0.5, 0.55}, {0.8, 0.6, 0.9}, drawers},
          {"kitchen_unit", {1.8, 0.6, 0.9}, {2.4, 0.65, 0.92}, kitchenUnit},
          {"rack", {0.9, 0.4, 1.8}, {1.3, 0.6, 2.1}, wardrobeRack}};
}

} // namespace pcl::indoor
