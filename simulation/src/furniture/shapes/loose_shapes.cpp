/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/shapes/solids.h"
#include "plan/turned_rectangle.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

using P = Eigen::Vector3d;

// A handle from one side to the other over a bag.
void
strap(PartMaker& make, double half, double y, double z0, double z1)
{
  tube(make,
       "strap",
       arc({0, y, z0}, {half, 0, 0}, {0, 0, z1 - z0}, 0, M_PI, 8),
       0.009,
       5);
}

// Leans back a little, a pocket in front.
void
backpack(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  sheet(make, "bag", {4, 6, 0.9 * y}, [&](double u, double v) -> P {
    return {0.95 * x * u * (1 - 0.25 * std::pow((v + 1) / 2, 3)),
            -0.15 * y - 0.15 * y * v,
            (0.04 + 0.96 * (v + 1) / 2) * 0.93 * z};
  });
  pillow(make,
         "pocket",
         {{0, 0.55 * y, 0.35 * z}, {0.7 * x, 0, 0}, {0, 0, 0.27 * z}},
         0.7 * y);
  for (const double s : {-0.5, 0.5})
    tube(make,
         "strap",
         {{s * x, -0.7 * y, 0.15 * z},
          {1.2 * s * x, -y, 0.45 * z},
          {s * x, -0.75 * y, 0.85 * z}},
         0.014,
         5);
  strap(make, 0.12 * x + 0.03, -0.4 * y, 0.92 * z, z);
}

void
handbag(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               body = size.z() * draw.uniform(0.62, 0.75);
  make.loft("bag",
            {-x, -y, x, y},
            {{0.9, 0, 0.4},
             {1, 0.15 * body, 0.4},
             {0.97, 0.5 * body, 0.4},
             {0.7, 0.95 * body, 0.4},
             {0.42, body, 0.4}},
            20);
  strap(make, 0.5 * x, 0, 0.9 * body, z);
}

void
tote(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               body = size.z() * draw.uniform(0.62, 0.75);
  make.vessel("bag", {-x, -y, x, y}, 0, body, 0.85, 1.0, 0.35);
  for (const double s : {-0.8, 0.8})
    strap(make, 0.5 * x, s * y, body - 0.02, z);
}

void
paperBag(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.vessel("bag", {-x, -y, x, y}, 0, 0.85 * z, 0.97, 1.0, 0.03);
  for (const double s : {-0.9, 0.9})
    strap(make, 0.3 * x, s * y, 0.83 * z, z);
}

void
sportsBag(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  tube(make,
       "bag",
       {{-x, 0, 0.42 * z},
        {-0.9 * x, 0, 0.42 * z},
        {0.9 * x, 0, 0.42 * z},
        {x, 0, 0.42 * z}},
       0.42 * z,
       12);
  for (const double s : {-0.3, 0.3})
    strap(make, 0.35 * x, s * y, 0.7 * z, z);
}

void
briefcase(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  roundBox(make, "case", {-x, -y, x, y}, 0, 0.9 * z, 0.04);
  strap(make, 0.08, 0, 0.89 * z, z);
}

void
trolley(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               body = size.z() * draw.uniform(0.62, 0.75);
  roundBox(make, "case", {-x, -0.9 * y, x, y}, 0.05, body, 0.05);
  for (const double s : {-0.85, 0.85})
    tube(make,
         "wheel",
         {{s * x - 0.012, -0.8 * y, 0.03}, {s * x + 0.012, -0.8 * y, 0.03}},
         0.03,
         8);
  tube(make,
       "handle",
       {{-0.5 * x, -0.8 * y, body},
        {-0.5 * x, -0.8 * y, z},
        {0.5 * x, -0.8 * y, z},
        {0.5 * x, -0.8 * y, body}},
       0.01,
       5);
}

// Tied at its neck.
void
tiedSack(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.loft("sack",
            {-x, -y, x, y},
            {{0.7, 0},
             {1, 0.2 * z},
             {0.85, 0.55 * z},
             {0.25, 0.8 * z},
             {0.2, 0.83 * z},
             {0.5, z}},
            18);
}

FurnitureClass
shoes(int kind)
{
  return fitted("shoes",
                {0.2, 0.24, kind == 1 ? 0.22 : 0.07},
                {0.3, 0.32, kind == 1 ? 0.4 : 0.13},
                [kind](PartMaker& make, const Size& size, RandomDraw& draw) {
                  const double x = size.x() / 2, z = size.z();
                  for (const double s : {-1.0, 1.0}) {
                    const double at = s * 0.55 * x,
                                 off = draw.uniform(-0.1, 0.1) * size.y(),
                                 y = 0.42 * size.y(), w = 0.4 * x;
                    const double heel = kind == 2 ? 0.65 * z : 0.02;
                    make.loft("sole",
                              {at - w, off - y, at + w, off + y},
                              {{0.9, 0, 0.7},
                               {1, 0.02, 0.7},
                               {0.95, 0.3 * z, 0.7},
                               {0.7, 0.55 * z, 0.7}},
                              14);
                    make.loft("shaft",
                              {at - 0.8 * w, off - y, at + 0.8 * w, off - 0.2 * y},
                              {{1, heel, 0.8},
                               {0.9, 0.7 * z, 0.8},
                               {0.95, z, 0.8},
                               {0.75, z, 0.8},
                               {0.6, 0.5 * z, 0.8}},
                              12);
                  }
                });
}

// On the floor or a desk: in loops, stretched out, with a strip of sockets.
FurnitureClass
cable(int kind)
{
  const bool coil = kind == 0;
  return fitted(
      "cable",
      coil ? Size(0.15, 0.15, 0.02) : Size(0.5, 0.15, 0.02),
      coil ? Size(0.35, 0.35, 0.06) : Size(1.8, 0.5, 0.05),
      [kind](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2, phase = draw.uniform(0, 6);
        Path path;
        const int pieces = 36;
        for (int i = 0; i <= pieces; ++i) {
          const double t = static_cast<double>(i) / pieces;
          if (kind == 0) {
            const double a = 22 * t, r = 0.75 + 0.15 * std::sin(2.3 * a + phase);
            path.push_back(
                {r * x * std::cos(a), r * y * std::sin(a), 0.008 + 0.7 * size.z() * t});
          }
          else
            path.push_back(
                {x * (2 * t - 1),
                 y * (0.7 * std::sin(5 * t + phase) + 0.3 * std::sin(13 * t)),
                 0.008 + 0.004 * std::sin(9 * t)});
        }
        tube(make, "cable", path, kind == 0 ? 0.006 : 0.008, 5);
        if (kind == 2)
          roundBox(make,
                   "sockets",
                   {0.5 * x, path.back().y() - 0.03, x, path.back().y() + 0.03},
                   0,
                   0.045,
                   0.01);
      });
}

void
bear(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  ellipsoid(make, "body", {0, 0, 0.33 * z}, {0.6 * x, 0.6 * y, 0.33 * z});
  ellipsoid(make, "head", {0, 0.1 * y, 0.76 * z}, {0.45 * x, 0.5 * y, 0.2 * z});
  for (const double s : {-1.0, 1.0}) {
    ellipsoid(make, "ear", {s * 0.35 * x, 0, 0.93 * z}, {0.14 * x, 0.1 * y, 0.07 * z});
    tube(make,
         "arm",
         {{s * 0.45 * x, 0.1 * y, 0.5 * z}, {s * 0.85 * x, 0.5 * y, 0.38 * z}},
         0.13 * x);
    tube(make,
         "leg",
         {{s * 0.3 * x, 0.2 * y, 0.12 * z}, {s * 0.55 * x, 0.85 * y, 0.1 * z}},
         0.16 * x);
  }
}

void
car(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  roundBox(make, "car", {-0.85 * x, -y, 0.85 * x, y}, 0.2 * z, 0.6 * z, 0.1 * z);
  make.frustum("cabin",
               {-0.8 * x, -0.6 * y, 0.8 * x, 0.3 * y},
               0.58 * z,
               {-0.6 * x, -0.4 * y, 0.6 * x, 0.1 * y},
               z);
  for (const double sx : {-0.9, 0.9})
    for (const double sy : {-0.6, 0.6})
      tube(make,
           "wheel",
           {{sx * x - 0.1 * x, sy * y, 0.22 * z}, {sx * x + 0.1 * x, sy * y, 0.22 * z}},
           0.22 * z,
           10);
}

void
blocks(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  for (int i = 0; i < 9; ++i) {
    const int below = i < 5 ? 0 : (i < 8 ? 1 : 2);
    const double h = 0.33 * z, level = below * h,
                 px = draw.uniform(-0.7, 0.7) * x * (1 - level / z),
                 py = draw.uniform(-0.7, 0.7) * y * (1 - level / z),
                 a = draw.uniform(0, 1.5), side = 0.56 * std::min(x, y);
    make.slab("block", turnedRectangle({px, py}, {side, side}, a), level, level + h);
  }
  return make.join(9, "blocks");
}

void
ringStack(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, z = size.z();
  tube(make, "rod", {{0, 0, 0}, {0, 0, z}}, 0.12 * x);
  for (int i = 0; i < 5; ++i)
    lathe(make,
          "ring",
          {0, 0},
          {{(0.8 - 0.12 * i) * x, 0.02 * z + 0.17 * i * z},
           {(1 - 0.14 * i) * x, (0.1 + 0.17 * i) * z},
           {(0.8 - 0.12 * i) * x, (0.18 + 0.17 * i) * z}},
          14);
}

void
house(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  row(make, "floor", {{-x, -0.8 * y, 0}, {x, 0.8 * y, 0.015}}, {0, 0, 0.32 * z}, 3);
  for (const double s : {-x, -0.01, x - 0.015})
    make.box("wall", {s, -0.8 * y, s + 0.015, 0.8 * y}, 0.015, 0.64 * z);
  make.box("back", {-x, -0.8 * y, x, -0.75 * y}, 0.015, 0.64 * z);
  return make.frustum(
      "roof", {-x, -y, x, y}, 0.655 * z, {-x, -0.05 * y, x, 0.05 * y}, z);
}

void
train(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  for (int i = 0; i < 4; ++i) {
    const double at = -x + (i + 0.5) * x / 2;
    roundBox(make,
             "wagon",
             {at - 0.22 * x, -0.8 * y, at + 0.22 * x, 0.8 * y},
             0.25 * z,
             i == 0 ? z : 0.75 * z,
             0.02);
    for (const double s : {-0.12, 0.12})
      tube(make,
           "wheel",
           {{at + s * x, -y, 0.2 * z}, {at + s * x, y, 0.2 * z}},
           0.2 * z,
           8);
  }
}

void
doll(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.loft("skirt",
            {-x, -y, x, y},
            {{1, 0}, {0.5, 0.45 * z}, {0.35, 0.7 * z}, {0.15, 0.75 * z}},
            14);
  ellipsoid(make, "head", {0, 0, 0.87 * z}, {0.35 * x, 0.4 * y, 0.13 * z});
  tube(make,
       "arms",
       {{-0.9 * x, 0, 0.45 * z},
        {-0.4 * x, 0, 0.68 * z},
        {0.4 * x, 0, 0.68 * z},
        {0.9 * x, 0.3 * y, 0.5 * z}},
       0.08 * x);
}

} // namespace

std::vector<FurnitureClass>
looseShapes()
{
  return {
      fitted("bag", {0.28, 0.18, 0.4}, {0.36, 0.28, 0.52}, backpack),
      fitted("bag", {0.25, 0.1, 0.25}, {0.42, 0.18, 0.45}, handbag),
      fitted("bag", {0.3, 0.12, 0.4}, {0.45, 0.22, 0.6}, tote),
      fitted("bag", {0.2, 0.1, 0.3}, {0.36, 0.18, 0.5}, paperBag),
      fitted("bag", {0.45, 0.25, 0.28}, {0.7, 0.35, 0.42}, sportsBag),
      fitted("bag", {0.35, 0.08, 0.28}, {0.5, 0.16, 0.4}, briefcase),
      fitted("bag", {0.34, 0.2, 0.75}, {0.5, 0.32, 1.1}, trolley),
      fitted("bag", {0.3, 0.3, 0.4}, {0.55, 0.55, 0.75}, tiedSack),
      shoes(0),
      shoes(1),
      shoes(2),
      cable(0),
      cable(1),
      cable(2),
      fitted("toy", {0.18, 0.18, 0.22}, {0.4, 0.4, 0.5}, bear),
      fitted("toy", {0.08, 0.18, 0.08}, {0.2, 0.4, 0.18}, car),
      fitted("toy", {0.25, 0.25, 0.1}, {0.45, 0.45, 0.22}, blocks),
      fitted("toy", {0.14, 0.14, 0.16}, {0.22, 0.22, 0.3}, ringStack),
      fitted("toy", {0.5, 0.25, 0.5}, {0.8, 0.4, 0.9}, house),
      fitted("toy", {0.35, 0.06, 0.08}, {0.7, 0.1, 0.14}, train),
      fitted("toy", {0.12, 0.1, 0.25}, {0.2, 0.18, 0.5}, doll),
  };
}

} // namespace pcl::indoor
