/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/shapes/solids.h"
#include "plan/turned_rectangle.h"

#include <Eigen/Geometry>

#include <cmath>

namespace pcl::indoor {

namespace {

using P = Eigen::Vector3d;

void
cookingPot(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  lathe(make,
        "pot",
        {0, 0},
        {{0.95 * y, 0}, {y, 0.05 * z}, {y, 0.7 * z}, {1.04 * y, 0.72 * z}});
  lathe(
      make,
      "lid",
      {0, 0},
      {{1.02 * y, 0.72 * z}, {0.7 * y, 0.82 * z}, {0.12 * y, 0.86 * z}, {0.15 * y, z}});
  for (const double s : {-1.0, 1.0})
    tube(make,
         "handle",
         arc({s * 0.97 * y, 0, 0.6 * z},
             {s * (x - y), 0, 0},
             {0, 0.3 * y, 0},
             -M_PI / 2,
             M_PI / 2,
             6),
         0.008,
         5);
}

void
pan(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.vessel("pan", {-x, -y, -x + 2 * y, y}, 0, 0.8 * z, 0.85, 1.0);
  tube(make,
       "handle",
       {{-x + 1.95 * y, 0, 0.6 * z}, {0.6 * x, 0, 0.85 * z}, {x, 0, z}},
       0.012);
}

void
kettle(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  lathe(make,
        "kettle",
        {-0.15 * x, 0},
        {{0.8 * y, 0},
         {y, 0.1 * z},
         {0.75 * y, 0.65 * z},
         {0.5 * y, 0.75 * z},
         {0.1 * y, 0.8 * z}});
  tube(make,
       "spout",
       {{-0.15 * x + 0.6 * y, 0, 0.4 * z}, {0.7 * x, 0, 0.55 * z}, {x, 0, 0.75 * z}},
       0.015);
  tube(make,
       "handle",
       arc({-0.15 * x, 0, 0.7 * z}, {0.6 * y, 0, 0}, {0, 0, 0.3 * z}, 0, M_PI, 8),
       0.01);
}

// With plates on edge.
void
rack(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  for (const double s : {-0.95, 0.95})
    tube(make,
         "rail",
         {{-x, s * y, 0.01},
          {-x, s * y, 0.35 * z},
          {x, s * y, 0.35 * z},
          {x, s * y, 0.01}},
         0.008,
         5);
  make.box("tray", {-x, -y, x, y}, 0, 0.012);
  for (int i = 0; i < 4 + draw.pick(5); ++i) {
    const double at = -0.9 * x + i * 0.2 * x;
    auto rim =
             arc({at, 0, 0.5 * z}, {0, 0.85 * y, 0}, {0, 0, 0.48 * z}, 0, 2 * M_PI, 12),
         inner = rim;
    rim.pop_back(), inner.pop_back();
    for (auto& p : inner)
      p.x() += 0.012;
    skin(make, "plate", {rim, inner});
  }
}

void
toaster(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  roundBox(make, "toaster", {-x, -y, x, y}, 0, z, 0.04);
  return make.box("lever", {x, -0.01, x + 0.03, 0.03}, 0.5 * z, 0.6 * z);
}

void
coffee(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  roundBox(make, "base", {-x, -y, x, y}, 0, 0.12 * z, 0.015);
  roundBox(make, "tank", {-x, -y, x, -0.2 * y}, 0.1 * z, z, 0.03);
  roundBox(make, "head", {-x, -0.3 * y, x, 0.8 * y}, 0.7 * z, z, 0.03);
  lathe(make,
        "jug",
        {0, 0.3 * y},
        {{0.6 * y, 0.12 * z}, {0.65 * y, 0.35 * z}, {0.4 * y, 0.6 * z}});
}

void
knives(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.frustum("block", {-x, -y, x, 0.6 * y}, 0, {-x, -0.2 * y, x, y}, 0.7 * z);
  row(make,
      "knife",
      {{-0.8 * x, 0.1 * y, 0.7 * z}, {-0.55 * x, 0.3 * y, z}},
      {0.45 * x, 0.1 * y, -0.05 * z},
      4);
}

void
mixer(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  roundBox(make, "foot", {-0.8 * x, -y, 0.8 * x, y}, 0, 0.12 * z, 0.02);
  roundBox(make, "neck", {-0.4 * x, -y, 0.4 * x, -0.5 * y}, 0.1 * z, 0.8 * z, 0.03);
  roundBox(make, "arm", {-0.5 * x, -y, 0.5 * x, 0.9 * y}, 0.7 * z, z, 0.05);
  return make.vessel("bowl", {-x, -0.2 * y, x, y}, 0.12 * z, 0.55 * z, 0.6, 1.0);
}

void
paper(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  for (int i = 0; i < 5; ++i) {
    const double px = draw.uniform(-0.25, 0.25) * x, py = draw.uniform(-0.25, 0.25) * y,
                 angle = draw.uniform(-0.5, 0.5);
    make.slab("sheet",
              turnedRectangle({px, py}, {1.2 * x, 1.4 * y}, angle),
              z * i / 5,
              z * (i + 1) / 5);
  }
  return make.join(5, "papers");
}

void
tissues(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  roundBox(make, "box", {-x, -y, x, y}, 0, 0.75 * z, 0.01);
  sheet(make, "tissue", {6, 2, 0.004}, [&](double u, double v) -> P {
    return {0.4 * x * u * (1 - 0.3 * v),
            0.15 * y * std::sin(4 * u) * (v + 1),
            0.75 * z + 0.125 * z * (v + 1) * (1.4 - 0.4 * u * u)};
  });
}

void
pens(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.vessel("cup", {-0.6 * x, -0.6 * y, 0.6 * x, 0.6 * y}, 0, 0.6 * z, 0.9, 1.0);
  for (int i = 0; i < 5; ++i)
    tube(make,
         "pen",
         {{0, 0, 0.1 * z},
          {x * std::cos(1.3 * i), y * std::sin(1.3 * i), z * draw.uniform(0.8, 1.0)}},
         0.005,
         5);
}

// Of laundry.
void
laundryBasket(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.vessel("basket", {-x, -y, x, y}, 0, 0.75 * z, 0.8, 1.0, 0.5);
  for (int i = 0; i < 4; ++i)
    pillow(make,
           "cloth",
           {{draw.uniform(-0.3, 0.3) * x,
             draw.uniform(-0.3, 0.3) * y,
             z * (0.6 + 0.09 * i)},
            {0.5 * x, 0.1 * y, 0.05 * z},
            {-0.1 * x, 0.5 * y, 0}},
           0.3 * z);
}

void
tray(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.vessel("tray", {-x, -y, x, y}, 0, 0.2 * z, 0.95, 1.0, 0.1);
  for (int i = 0; i < 3; ++i) {
    const double top = z * draw.uniform(0.5, 1.0), at = draw.uniform(-0.3, 0.3) * y;
    lathe(
        make, "cup", {(i - 1) * 0.55 * x, at}, {{0.15 * x, 0.05 * z}, {0.2 * x, top}});
  }
}

void
speaker(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  roundBox(make, "case", {-x, -y, x, 0.9 * y}, 0, z, 0.015);
  for (const double s : {0.32, 0.72})
    ellipsoid(
        make, "cone", {0, 0.9 * y, s * z}, {0.6 * x * (1.2 - s), 0.1 * y, 0.16 * z});
}

void
umbrella(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  lathe(make,
        "umbrella",
        {0, 0},
        {{0.01, 0}, {0.3 * x, 0.2 * z}, {0.5 * x, 0.65 * z}, {0.15 * x, 0.72 * z}},
        8);
  tube(make,
       "handle",
       {{0, 0, 0.7 * z},
        {0, 0, 0.93 * z},
        {0.4 * x, 0, z},
        {0.9 * x, 0, 0.93 * z},
        {x, 0.5 * y, 0.88 * z}},
       0.012);
}

void
hat(PartMaker& make, const Size& size, RandomDraw&)
{
  const double y = size.y() / 2, z = size.z();
  lathe(
      make,
      "hat",
      {0, 0},
      {{y, 0}, {y, 0.05 * z}, {0.55 * y, 0.12 * z}, {0.5 * y, 0.8 * z}, {0.3 * y, z}});
}

void
tools(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  roundBox(make, "case", {-x, -y, x, y}, 0, 0.75 * z, 0.02);
  make.box("clips", {-0.5 * x, y, 0.5 * x, y + 0.01}, 0.4 * z, 0.6 * z);
  tube(make,
       "handle",
       {{-0.5 * x, 0, 0.74 * z},
        {-0.5 * x, 0, z},
        {0.5 * x, 0, z},
        {0.5 * x, 0, 0.74 * z}},
       0.012);
}

void
globe(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  lathe(make, "foot", {0, 0}, {{0.6 * x, 0}, {0.6 * x, 0.03 * z}, {0.1 * x, 0.15 * z}});
  tube(make,
       "arch",
       arc({0, 0, 0.58 * z}, {0.97 * x, 0, 0}, {0, 0, 0.42 * z}, -1.7, 1.4, 10),
       0.008,
       5);
  ellipsoid(make, "globe", {0, 0, 0.58 * z}, {0.85 * x, 0.85 * y, 0.37 * z});
}

} // namespace

std::vector<FurnitureClass>
wareShapes()
{
  return {
      fitted("kitchenware", {0.24, 0.18, 0.12}, {0.38, 0.28, 0.26}, cookingPot),
      fitted("kitchenware", {0.4, 0.22, 0.06}, {0.55, 0.32, 0.12}, pan),
      fitted("kitchenware", {0.2, 0.15, 0.18}, {0.28, 0.2, 0.28}, kettle),
      fitted("kitchenware", {0.35, 0.24, 0.2}, {0.5, 0.36, 0.3}, rack),
      fitted("kitchenware", {0.26, 0.15, 0.16}, {0.36, 0.2, 0.22}, toaster),
      fitted("kitchenware", {0.18, 0.24, 0.28}, {0.32, 0.38, 0.42}, coffee),
      fitted("kitchenware", {0.1, 0.14, 0.22}, {0.16, 0.2, 0.34}, knives),
      fitted("kitchenware", {0.16, 0.28, 0.28}, {0.24, 0.38, 0.38}, mixer),
      fitted("clutter", {0.25, 0.3, 0.02}, {0.4, 0.42, 0.08}, paper),
      fitted("clutter", {0.2, 0.1, 0.1}, {0.26, 0.14, 0.18}, tissues),
      fitted("clutter", {0.08, 0.08, 0.12}, {0.14, 0.14, 0.22}, pens),
      fitted("clutter", {0.3, 0.2, 0.08}, {0.5, 0.35, 0.16}, tray),
      fitted("clutter", {0.2, 0.2, 0.28}, {0.34, 0.34, 0.45}, globe),
      fitted("clutter", {0.14, 0.16, 0.22}, {0.28, 0.3, 0.95}, speaker),
      fitted("clutter", {0.28, 0.28, 0.1}, {0.4, 0.4, 0.18}, hat),
      fitted("clutter", {0.35, 0.18, 0.2}, {0.55, 0.28, 0.32}, tools),
      fitted("clutter", {0.4, 0.3, 0.3}, {0.65, 0.45, 0.65}, laundryBasket),
      fitted("clutter", {0.1, 0.1, 0.7}, {0.16, 0.16, 0.95}, umbrella),
  };
}

} // namespace pcl::indoor
