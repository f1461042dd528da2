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

/** A random rectangle within the extent of a piece. */
Rectangle
within(const Size& size, double least, RandomDraw& draw)
{
  const double w = draw.uniform(least, 1.0) * size.x(),
               d = draw.uniform(least, 1.0) * size.y();
  const double x = draw.uniform(-0.5, 0.5) * (size.x() - w),
               y = draw.uniform(-0.5, 0.5) * (size.y() - d);
  return {x - w / 2, y - d / 2, x + w / 2, y + d / 2};
}

// A filled bag that sinks into itself.
void
bag(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const double corner = draw.uniform(0.4, 1.0), neck = draw.uniform(0.15, 0.6);
  make.loft("bag",
            {-x, -y, x, y},
            {{draw.uniform(0.7, 0.95), 0, corner},
             {1, draw.uniform(0.2, 0.45) * z, corner},
             {draw.uniform(0.6, 0.95), draw.uniform(0.55, 0.75) * z, corner},
             {neck, 0.9 * z, 1},
             {draw.uniform(0.1, 1.2) * neck, z, 1}});
}

// Clothes or papers thrown on each other.
void
heap(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const int layers = 3 + draw.pick(4);
  for (int i = 0; i < layers; ++i) {
    const double low = 0.8 * size.z() * i / layers,
                 high = std::min(size.z(), low + draw.uniform(0.15, 0.5) * size.z());
    make.cushion("layer", within(size, 0.5, draw), low, high);
  }
  make.join(layers, "heap");
}

// Flat objects that do not lie straight: papers, folders, trays.
void
pile(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const int layers = 2 + draw.pick(5);
  for (int i = 0; i < layers; ++i) {
    const auto r = within(size, 0.75, draw);
    const Eigen::Vector2d middle((r.x0 + r.x1) / 2, (r.y0 + r.y1) / 2);
    const double angle = draw.uniform(-0.3, 0.3),
                 half = std::min(r.x1 - r.x0, r.y1 - r.y0) / 2 * 0.75;
    const Eigen::Vector2d along =
                              half * Eigen::Vector2d(std::cos(angle), std::sin(angle)),
                          across(-along.y(), along.x());
    make.slab("sheet",
              {middle - along - across,
               middle + along - across,
               middle + along + across,
               middle - along + across},
              size.z() * i / layers,
              size.z() * (i + 1) / layers);
  }
  make.join(layers, "pile");
}

// A slanted case with a bar on it: telephones, tills, small devices.
void
device(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               front = draw.uniform(-0.9, 0.6) * y, high = draw.uniform(0.5, 0.9) * z;
  make.frustum("case", {-x, -y, x, y}, 0, {-0.95 * x, -y, 0.95 * x, front}, high);
  if (draw.uniform() < 0.6) {
    const double at = draw.uniform(-0.7, 0.7) * x;
    make.rod("handset", {at, -0.8 * y, 0.9 * z}, {at, 0.5 * front, 0.9 * z}, 0.1 * z);
  }
}

// Cups, pens and boxes that stand close together.
void
cluster(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const int count = 2 + draw.pick(4);
  for (int i = 0; i < count; ++i) {
    const auto r = within(size, 0.35, draw);
    const double high = draw.uniform(0.4, 1.0) * size.z();
    if (draw.uniform() < 0.5)
      make.box("thing", r, 0, high);
    else
      make.vessel("thing", r, 0, high, draw.uniform(0.6, 1.0), 1.0);
  }
  make.join(count, "things");
}

} // namespace

std::vector<FurnitureClass>
clutterClasses()
{
  return {{"clutter", {0.2, 0.15, 0.15}, {0.55, 0.4, 0.5}, bag},
          {"clutter", {0.25, 0.2, 0.06}, {0.6, 0.5, 0.25}, heap},
          {"clutter", {0.2, 0.2, 0.03}, {0.4, 0.35, 0.2}, pile},
          {"clutter", {0.15, 0.15, 0.06}, {0.35, 0.3, 0.25}, device},
          {"clutter", {0.12, 0.12, 0.1}, {0.3, 0.3, 0.25}, cluster}};
}

} // namespace pcl::indoor
