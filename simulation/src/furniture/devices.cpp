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
standingTv(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               low = draw.uniform(0.05, 0.1);
  make.box("screen", {-x, -0.2 * y, x, 0.2 * y}, low, z);
  if (draw.pick(2) == 0) {
    make.loft("foot", {-0.35 * x, -y, 0.35 * x, y}, {{1, 0, 0.6}, {0.9, 0.015, 0.6}});
    make.box("stand", {-0.05, -0.15 * y, 0.05, 0.15 * y}, 0.01, low);
  }
  else
    for (const double s : {-0.7 * x, 0.7 * x}) {
      make.rod("leg", {s, -0.9 * y, 0.01}, {s, 0, low + 0.02}, 0.01);
      make.rod("leg", {s, 0.9 * y, 0.01}, {s, 0, low + 0.02}, 0.01);
    }
}

void
wallTv(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               arm = draw.uniform(0.2, 0.5);
  make.box("screen", {-x, 0.0, x, y}, 0, z);
  make.box("arm", {-arm * x, -y, arm * x, 0.0}, 0.3 * z, 0.7 * z);
}

// A deep box, as there were before flat ones.
void
tubeTv(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               r = draw.uniform(0.4, 0.7);
  make.box("case", {-x, 0.3 * y, x, y}, 0, z);
  for (int k = 0; k < 2; ++k)
    make.box("tube",
             {-(r + 0.2 * k) * x,
              -y + 1.3 * y * 0.5 * k,
              (r + 0.2 * k) * x,
              -y + 1.3 * y * 0.5 * (k + 1)},
             0,
             (r + 0.2 * k) * z);
}

void
laptop(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               lean = draw.uniform(0.1, 0.5);
  make.box("base", {-x, -0.6 * y, x, y}, 0, 0.018);
  for (int k = 0; k < 6; ++k) { // the screen leans back
    const double z0 = 0.018 + (z - 0.018) * k / 6,
                 z1 = 0.018 + (z - 0.018) * (k + 1) / 6;
    const double a = -0.6 * y - lean * 0.4 * y * k / 6,
                 b = -0.6 * y - lean * 0.4 * y * (k + 1) / 6;
    make.frustum("screen", {-x, a, x, a + 0.012}, z0, {-x, b, x, b + 0.012}, z1);
  }
  make.join(6, "screen");
}

void
keyboard(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.frustum("keyboard",
               {-x, -y, x, y},
               0,
               {-x + 0.005, -y + 0.005, x - draw.uniform(0.0, 0.02), y - 0.01},
               z);
}

void
computer(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.box("case", {-x, -y, x, y - 0.02}, 0.015, z);
  make.box("front", {-x, y - 0.02, x, y}, 0.03, z * draw.uniform(0.9, 1.0));
  make.box("feet", {-0.9 * x, -0.9 * y, 0.9 * x, -0.7 * y}, 0, 0.015);
  make.box("feet", {-0.9 * x, 0.7 * y, 0.9 * x, 0.9 * y}, 0, 0.015);
}

void
printer(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               out = draw.uniform(0.4, 0.7);
  make.box("case", {-x, -y, x, 0.6 * y}, 0, 0.75 * z);
  make.box("lid", {-x, -y, x, 0.5 * y}, 0.75 * z, z * draw.uniform(0.85, 1.0));
  make.box("tray", {-out * x, 0.6 * y, out * x, y}, 0.25 * z, 0.32 * z);
}

void
wallAirConditioner(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               in = draw.uniform(0.1, 0.5);
  make.frustum("case", {-x, -y, x, in * y}, 0, {-x, -y, x, y}, 0.4 * z);
  make.frustum("case", {-x, -y, x, y}, 0.4 * z, {-x, -y, x, 0.8 * y}, z);
  make.join(2, "case");
}

void
standingAirConditioner(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.loft("case",
            {-x, -y, x, y},
            {{1, 0, 0.2}, {1, 0.08 * z, 0.2}, {0.95, 0.1 * z, 0.2}, {0.95, z, 0.2}},
            20);
  make.box(
      "grille", {-0.7 * x, 0.8 * y, 0.7 * x, y}, draw.uniform(0.6, 0.7) * z, 0.92 * z);
}

void
treadmill(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               deck = draw.uniform(0.12, 0.22);
  make.box("deck", {-0.8 * x, -y, 0.8 * x, y}, 0.04, deck);
  make.box("motor", {-x, -y, x, -0.6 * y}, 0, deck + 0.08);
  for (const double s : {-0.9 * x, 0.9 * x}) {
    make.rod("post", {s, -0.7 * y, deck}, {s, -0.85 * y, z - 0.1}, 0.03);
    make.rod("rail", {s, -0.82 * y, 0.75 * z}, {s, -0.1 * y, 0.7 * z}, 0.022);
  }
  make.box("console", {-x, -y, x, -0.75 * y}, z - 0.15, z);
}

void
wheel(PartMaker& make, double y, double radius)
{
  const int pieces = 16;
  for (int i = 0; i < pieces; ++i) {
    const double a = 2 * M_PI * i / pieces, b = 2 * M_PI * (i + 1) / pieces;
    make.rod("wheel",
             {0, y + radius * std::cos(a), radius + 0.02 + radius * std::sin(a)},
             {0, y + radius * std::cos(b), radius + 0.02 + radius * std::sin(b)},
             0.018,
             5);
  }
  make.join(pieces, "wheel");
}

void
bicycle(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               r = std::min(0.33, 0.38 * y) * draw.uniform(0.9, 1.0), axle = r + 0.02;
  const Eigen::Vector3d rear(0, -y + r + 0.02, axle), front(0, y - r - 0.02, axle),
      pedal(0, -0.1 * y, 0.28), saddle(0, -0.3 * y, 0.85 * z),
      head(0, 0.45 * y, 0.85 * z);
  wheel(make, rear.y(), r);
  wheel(make, front.y(), r);
  make.rod("frame", rear, pedal, 0.018);
  make.rod("frame", rear, saddle, 0.015);
  make.rod("frame", pedal, saddle, 0.02);
  make.rod("frame", pedal, head, 0.025);
  make.rod("frame", saddle, head, 0.02);
  make.rod("frame", head, front, 0.018);
  make.join(6, "frame");
  make.rod("bar", {-x, 0.4 * y, z - 0.03}, {x, 0.4 * y, z - 0.03}, 0.015);
  make.rod("bar", head, {0, 0.4 * y, z - 0.03}, 0.015);
  make.join(2, "bar");
  make.loft("saddle",
            {-0.08, -0.3 * y - 0.13, 0.08, -0.3 * y + 0.13},
            {{0.7, 0.85 * z, 0.6}, {1, 0.9 * z, 0.6}},
            10);
}

// An upright one.
void
piano(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(), keys = 0.62 * z;
  make.box("case", {-x, -y, x, draw.uniform(-0.2, 0.1) * y}, 0, z);
  make.box("keys", {-x, -0.2 * y, x, y}, keys - 0.12, keys);
  for (const double s : {-x, x - 0.06}) {
    make.box("cheek", {s, -0.2 * y, s + 0.06, y}, keys - 0.14, keys + 0.08);
    make.box("leg", {s, 0.7 * y, s + 0.06, y - 0.02}, 0, keys - 0.12);
  }
}

void
grandPiano(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(), low = 0.62,
               corner = draw.uniform(0.5, 0.7);
  make.loft("body", {-x, -y, x, y}, {{1, low, corner}, {1, z, corner}}, 32);
  make.box("keys", {-x, 0.6 * y, x, y}, low, 0.8 * z);
  for (int i = 0; i < 3; ++i) {
    const double px = i == 2 ? 0.0 : (i == 0 ? -0.8 : 0.8) * x,
                 py = i == 2 ? -0.7 * y : 0.7 * y;
    make.rod("leg", {px, py, 0}, {px, py, low}, 0.05, 8);
  }
}

} // namespace

std::vector<FurnitureClass>
deviceClasses()
{
  return {
      {"tv", {0.7, 0.18, 0.48}, {1.45, 0.3, 0.9}, standingTv},
      {"tv", {0.7, 0.06, 0.42}, {1.5, 0.14, 0.88}, wallTv},
      {"tv", {0.55, 0.45, 0.45}, {0.8, 0.55, 0.62}, tubeTv},
      {"laptop", {0.3, 0.26, 0.2}, {0.4, 0.34, 0.26}, laptop},
      {"keyboard", {0.36, 0.13, 0.02}, {0.47, 0.17, 0.035}, keyboard},
      {"computer", {0.17, 0.38, 0.36}, {0.22, 0.5, 0.5}, computer},
      {"printer", {0.4, 0.38, 0.2}, {0.55, 0.5, 0.4}, printer},
      {"air_conditioner", {0.75, 0.18, 0.25}, {1.1, 0.26, 0.4}, wallAirConditioner},
      {"air_conditioner", {0.4, 0.3, 1.6}, {0.55, 0.42, 2.0}, standingAirConditioner},
      {"treadmill", {0.7, 1.5, 1.2}, {0.9, 1.9, 1.45}, treadmill},
      {"bicycle", {0.5, 1.6, 0.95}, {0.62, 1.8, 1.1}, bicycle},
      {"piano", {1.35, 0.55, 1.05}, {1.55, 0.65, 1.3}, piano},
      {"piano", {1.4, 1.5, 0.95}, {1.5, 2.0, 1.05}, grandPiano}};
}

} // namespace pcl::indoor
