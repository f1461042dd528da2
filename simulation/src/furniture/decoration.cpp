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

// Leaves that hang over from one stem.
void
palm(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               pot = draw.uniform(0.2, 0.35) * std::min(z, 1.0);
  const double p = std::min({0.45 * x, 0.45 * y, 0.22});
  make.vessel("pot", {-p, -p, p, p}, 0, pot, 0.7, 1.0);
  const double crown = draw.uniform(0.3, 0.7) * z;
  make.rod("stem", {0, 0, 0.2 * pot}, {0, 0, crown}, 0.018);
  const int leaves = 7 + draw.pick(8);
  for (int i = 0; i < leaves; ++i) {
    const double a = draw.uniform(0, 2 * M_PI), reach = draw.uniform(0.5, 0.95),
                 top = draw.uniform(crown, z);
    Eigen::Vector3d last(0, 0, crown);
    for (int k = 1; k <= 3; ++k) {
      const double t = k / 3.0, high = crown + (top - crown) * std::sin(2.0 * t);
      const Eigen::Vector3d next(t * reach * x * std::cos(a),
                                 t * reach * y * std::sin(a),
                                 std::min(high, z - 0.01));
      make.rod("leaf", last, next, 0.035 * (1.3 - t), 5);
      last = next;
    }
  }
  make.join(3 * leaves, "leaves");
}

// A ball of small leaves in a pot.
void
bush(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               pot = draw.uniform(0.25, 0.45) * z, p = draw.uniform(0.45, 0.7);
  make.vessel("pot", {-p * x, -p * y, p * x, p * y}, 0, pot, 0.7, 1.0);
  const int leaves = 16 + draw.pick(10);
  const double middle = (pot + z) / 2, high = (z - pot) / 2;
  for (int i = 0; i < leaves; ++i) {
    const double a = draw.uniform(0, 2 * M_PI), h = draw.uniform(-1.0, 1.0),
                 r = 0.75 * std::sqrt(1 - h * h) * std::sqrt(draw.uniform());
    const double s = draw.uniform(0.12, 0.25), cx = r * x * std::cos(a),
                 cy = r * y * std::sin(a), cz = middle + 0.75 * h * high;
    make.loft("leaf",
              {cx - s * x, cy - s * y, cx + s * x, cy + s * y},
              {{0, cz - s * high}, {1, cz}, {0, std::min(z, cz + s * high)}},
              6);
  }
  make.rod("stem", {0, 0, 0.5 * pot}, {0, 0, middle}, 0.012);
  make.join(leaves + 1, "leaves");
}

void
vase(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               neck = draw.uniform(0.3, 0.7), belly = draw.uniform(0.3, 0.6);
  make.loft("vase",
            {-x, -y, x, y},
            {{draw.uniform(0.4, 0.7), 0},
             {1, belly * z},
             {neck, 0.85 * z},
             {neck + 0.1, z},
             {neck, z},
             {0.6 * neck, 0.8 * z}});
}

void
flowers(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               low = draw.uniform(0.4, 0.6) * z;
  make.vessel("vase",
              {-0.45 * x, -0.45 * y, 0.45 * x, 0.45 * y},
              0,
              low,
              draw.uniform(0.6, 1.0),
              1.0);
  const int stems = 6 + draw.pick(6);
  for (int i = 0; i < stems; ++i) {
    const double a = draw.uniform(0, 2 * M_PI), r = draw.uniform(0.2, 0.8),
                 top = draw.uniform(0.75, 0.95) * z;
    const Eigen::Vector3d p(r * x * std::cos(a), r * y * std::sin(a), top);
    make.rod("stem", {0, 0, 0.5 * low}, p, 0.004, 4);
    make.loft("flower",
              {p.x() - 0.2 * x, p.y() - 0.2 * y, p.x() + 0.2 * x, p.y() + 0.2 * y},
              {{0.3, top - 0.05 * z}, {1, top}, {0.5, std::min(z, top + 0.05 * z)}},
              7);
  }
  make.join(2 * stems, "flowers");
}

void
picture(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               f = draw.uniform(0.01, 0.05);
  make.box("picture", {-x + f, -y, x - f, 0.2 * y}, f, z - f);
  make.box("frame", {-x, -y, x, y}, 0, f);
  make.box("frame", {-x, -y, x, y}, z - f, z);
  make.box("frame", {-x, -y, -x + f, y}, f, z - f);
  make.box("frame", {x - f, -y, x, y}, f, z - f);
  make.join(4, "frame");
}

// Two sides of cloth in folds below a rail.
void
curtain(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               closed = draw.uniform(0.2, 0.95);
  make.rod("rail", {-x, 0, z - 0.02}, {x, 0, z - 0.02}, 0.015);
  for (const double side : {-1.0, 1.0}) {
    const int folds = std::max(2, static_cast<int>(closed * x / 0.09));
    for (int i = 0; i < folds; ++i) {
      const double p = side * (x - closed * x * (i + 0.5) / folds),
                   w = 0.5 * closed * x / folds;
      const double bend = i % 2 == 0 ? 0.4 * y : -0.4 * y;
      make.box("cloth", {p - w, bend - 0.4 * y, p + w, bend + 0.4 * y}, 0, z - 0.03);
    }
    make.join(folds, "cloth");
  }
}

void
closedBox(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               in = draw.uniform(0.0, 0.02);
  make.box("box", {-x + in, -y + in, x - in, y - in}, 0, 0.9 * z);
  make.box("lid", {-x, -y, x, y}, 0.8 * z, z);
  make.join(2, "box");
}

void
openBox(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  make.vessel("box", {-x, -y, x, y}, 0, size.z(), draw.uniform(0.85, 1.0), 1.0, 0.02);
}

void
pedalBin(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.loft("bin",
            {-x, -y, x, y},
            {{0.95, 0},
             {1, 0.85 * z},
             {0.95, 0.9 * z},
             {draw.uniform(0.5, 0.8), 0.97 * z},
             {0, z}});
}

void
books(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const int count = 2 + draw.pick(4);
  for (int i = 0; i < count; ++i) {
    const double sx = x * draw.uniform(0.7, 0.95), sy = y * draw.uniform(0.7, 0.95);
    make.box("book", {-sx, -sy, sx, sy}, z * i / count, z * (i + 1) / count);
  }
}

void
bookRow(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  for (double left = -x; left < x - 0.015;) {
    const double wide = std::min(draw.uniform(0.02, 0.05), x - left);
    const double high = size.z() * draw.uniform(0.75, 1.0),
                 front = draw.uniform(0.4, 1.0) * y;
    make.box("book", {left, -y, left + wide, front}, 0, high);
    left += wide;
  }
}

void
bottle(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               shoulder = draw.uniform(0.5, 0.75);
  make.loft("bottle",
            {-x, -y, x, y},
            {{1, 0}, {1, shoulder * z}, {0.35, (shoulder + 0.15) * z}, {0.35, z}},
            12);
}

void
cup(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  make.vessel("cup", {-x, -y, x, y}, 0, size.z(), draw.uniform(0.5, 1.0), 1.0);
}

void
fireplace(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               open = draw.uniform(0.4, 0.6) * x,
               high = draw.uniform(0.55, 0.75) * std::min(z, 1.2);
  make.box("side", {-x, -y, -open, 0.8 * y}, 0, high);
  make.box("side", {open, -y, x, 0.8 * y}, 0, high);
  make.box("back", {-open, -y, open, -0.8 * y}, 0, high);
  make.box("hearth", {-x, -0.8 * y, x, y}, 0, 0.06);
  make.box("mantel", {-x, -y, x, y}, high, high + 0.12);
  make.frustum("hood",
               {-0.85 * x, -y, 0.85 * x, 0.5 * y},
               high + 0.12,
               {-0.4 * x, -y, 0.4 * x, 0.0},
               z);
}

void
stove(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               body = draw.uniform(0.4, 0.5) * z;
  make.loft("stove",
            {-x, -y, x, y},
            {{1, 0.08, 0.4}, {1, body, 0.4}, {0.9, body + 0.04, 0.4}},
            20);
  make.rod("pipe", {0, -0.3 * y, body}, {0, -0.3 * y, z}, 0.07, 12);
  make.loft("foot", {-0.8 * x, -0.8 * y, 0.8 * x, 0.8 * y}, {{1, 0}, {1, 0.1}});
}

void
person(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               step = draw.uniform(0.0, 0.6) * y;
  for (const double s : {-1.0, 1.0}) {
    make.rod(
        "leg", {s * 0.35 * x, s * step, 0.03}, {s * 0.35 * x, 0, 0.5 * z}, 0.07, 8);
    make.rod("arm",
             {s * 0.7 * x, 0, 0.8 * z},
             {s * 0.85 * x, draw.uniform(-0.3, 0.5) * y, 0.45 * z},
             0.05,
             8);
    make.loft(
        "shoe",
        {s * 0.35 * x - 0.05, s * step - 0.1, s * 0.35 * x + 0.05, s * step + 0.14},
        {{1, 0, 0.6}, {0.8, 0.08, 0.6}},
        10);
  }
  make.loft("trunk",
            {-0.75 * x, -0.5 * y, 0.75 * x, 0.5 * y},
            {{0.7, 0.47 * z}, {0.75, 0.6 * z}, {1, 0.78 * z}, {0.3, 0.85 * z}});
  make.loft("head",
            {-0.09, -0.1, 0.09, 0.1},
            {{0.5, 0.84 * z}, {1, 0.92 * z}, {0.9, 0.96 * z}, {0, z}});
}

void
ball(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double r = std::min(size.x(), size.y()) / 2,
               z = size.z() * draw.uniform(0.95, 1.0);
  make.loft("ball", {-r, -r, r, r}, ballSections(z));
}

} // namespace

std::vector<FurnitureClass>
decorationClasses()
{
  return {{"plant", {0.45, 0.45, 0.6}, {0.9, 0.9, 1.8}, palm},
          {"plant", {0.25, 0.25, 0.35}, {0.55, 0.55, 1.2}, bush},
          {"vase", {0.1, 0.1, 0.15}, {0.25, 0.25, 0.6}, vase},
          {"vase", {0.18, 0.18, 0.3}, {0.35, 0.35, 0.6}, flowers},
          {"picture", {0.25, 0.03, 0.3}, {1.2, 0.06, 0.9}, picture},
          {"curtain", {1.2, 0.1, 2.2}, {2.6, 0.16, 2.5}, curtain},
          {"box", {0.25, 0.2, 0.15}, {0.7, 0.55, 0.5}, closedBox},
          {"box", {0.3, 0.25, 0.15}, {0.6, 0.45, 0.4}, openBox},
          {"bin", {0.25, 0.25, 0.35}, {0.36, 0.36, 0.7}, pedalBin},
          {"bin", {0.25, 0.2, 0.28}, {0.42, 0.42, 0.5}, openBox},
          {"books", {0.2, 0.16, 0.06}, {0.3, 0.24, 0.18}, books},
          {"books", {0.2, 0.16, 0.2}, {0.5, 0.24, 0.3}, bookRow},
          {"bottle", {0.06, 0.06, 0.2}, {0.1, 0.1, 0.34}, bottle},
          {"cup", {0.07, 0.07, 0.08}, {0.25, 0.25, 0.13}, cup},
          {"fireplace", {1.2, 0.5, 1.4}, {1.8, 0.8, 2.3}, fireplace},
          {"fireplace", {0.45, 0.42, 2.0}, {0.6, 0.55, 2.4}, stove},
          {"person", {0.5, 0.35, 1.55}, {0.6, 0.5, 1.9}, person},
          {"ball", {0.25, 0.25, 0.25}, {0.45, 0.45, 0.45}, ball}};
}

} // namespace pcl::indoor
