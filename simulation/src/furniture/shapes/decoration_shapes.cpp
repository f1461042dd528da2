/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/shapes/solids.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

using P = Eigen::Vector3d;

enum class Hanging { Deep, Canvas, Round, Triptych, Clock, Mirror, Leaning };

FurnitureClass
picture(const Size& smallest, const Size& largest, Hanging kind, int like = 0)
{
  return fitted(
      "picture",
      smallest,
      largest,
      [kind](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z();
        const auto ellipse = [&](double f, double y0) {
          return arc({0, y0, z / 2}, {f * x, 0, 0}, {0, 0, f * z / 2}, 0, 2 * M_PI, 20);
        };
        const auto disc = [&](double f, double y0, double y1) {
          std::vector<Path> rings{ellipse(f, y1), ellipse(f, y0)};
          for (auto& ring : rings)
            ring.pop_back();
          skin(make, "picture", rings);
        };
        if (kind == Hanging::Leaning) // its upper edge at a wall
          return sheet(make, "picture", {1, 1, 0.03}, [&](double u, double v) -> P {
            return {x * u, -y * v, z * (v + 1) / 2};
          });
        if (kind == Hanging::Canvas)
          return make.box("picture", {-x, -y, x, y}, 0, z);
        if (kind == Hanging::Triptych) {
          for (int i = 0; i < 3; ++i)
            make.box("picture",
                     {-x + i * 0.68 * x, -y, -x + i * 0.68 * x + 0.62 * x, y},
                     i == 1 ? 0 : 0.1 * z,
                     i == 1 ? z : 0.9 * z);
          return;
        }
        if (kind == Hanging::Round || kind == Hanging::Clock) {
          disc(0.95, -y, 0);
          const auto rim = arc({0, 0, z / 2},
                               {x - 0.02, 0, 0},
                               {0, 0, z / 2 - 0.02},
                               0,
                               1.98 * M_PI,
                               20);
          tube(make, "frame", rim, std::min(0.02, y), 5);
          if (kind == Hanging::Clock)
            for (const double a : {0.4, 2.2})
              tube(make,
                   "hand",
                   {{0, 0.4 * y, z / 2},
                    {0.6 * x * std::cos(a), 0.4 * y, z / 2 + 0.3 * z * std::sin(a)}},
                   0.006,
                   4);
          return;
        }
        const double f = draw.uniform(0.03, 0.09) * std::min(2 * x, z) / 0.5;
        make.box("picture",
                 {-x + f, -y, x - f, kind == Hanging::Deep ? -0.5 * y : 0.5 * y},
                 f,
                 z - f);
        for (const double s : {0.0, 1.0}) {
          make.frustum("frame",
                       {-x, -y, x, y},
                       s > 0 ? z - f : 0,
                       {-x, -y, x, y},
                       s > 0 ? z : f);
          make.box("frame", {s > 0 ? x - f : -x, -y, s > 0 ? x : -x + f, y}, f, z - f);
        }
        make.join(4, "frame");
      },
      like);
}

// To write on: on the wall, on a frame with wheels, on an easel.
FurnitureClass
writingBoard(int kind)
{
  const bool stands = kind > 0;
  return fitted(
      "board",
      stands ? Size(0.7, 0.5, 1.6) : Size(0.9, 0.05, 0.6),
      stands ? Size(1.8, 0.65, 1.95) : Size(2.4, 0.1, 1.2),
      [=](PartMaker& make, const Size& size, RandomDraw&) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
                     low = stands ? 0.45 * z : 0.0;
        if (kind == 2) {
          for (const double s : {-0.9, 0.9})
            tube(make, "leg", {{s * x, y, 0}, {0.3 * s * x, 0, z}}, 0.015);
          tube(make, "leg", {{0, -y, 0}, {0, 0, z}}, 0.015);
          return sheet(make, "board", {1, 2, 0.02}, [&](double u, double v) -> P {
            return {0.95 * x * u,
                    0.45 * y - 0.45 * y * (v + 1) / 2 + 0.05,
                    low + (v + 1) / 2 * (z - low)};
          });
        }
        make.box("board",
                 {-x + 0.02, -0.5 * (stands ? 0.02 : 2 * y), x - 0.02, 0.01},
                 low + 0.02,
                 z - 0.02);
        for (const double s : {-x, x - 0.02})
          make.box("frame", {s, -0.02, s + 0.02, 0.02}, low, z);
        make.box("tray", {-0.6 * x, 0.01, 0.6 * x, stands ? 0.08 : y}, low, low + 0.02);
        if (!stands)
          return;
        for (const double s : {-x + 0.02, x - 0.02}) {
          tube(make, "post", {{s, 0, 0.05}, {s, 0, low + 0.1}}, 0.018, 4);
          tube(make, "foot", {{s, -y, 0.04}, {s, y, 0.04}}, 0.018, 4);
        }
      },
      stands ? by_number : 0);
}

FurnitureClass
fireplace(int kind)
{
  return fitted(
      "fireplace",
      {0.5, 0.3, kind == 2 ? 0.7 : 1.0},
      {1.5, 0.6, kind == 2 ? 1.1 : 2.3},
      [kind](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
                     open = draw.uniform(0.45, 0.65);
        if (kind == 0 ||
            kind == 2) { // a surround with mantel, with or without a breast above
          const double high = kind == 0 ? 0.5 * z : z - 0.06;
          for (const double s : {-1.0, 1.0})
            roundBox(make,
                     "side",
                     {s > 0 ? open * x : -0.95 * x,
                      -y,
                      s > 0 ? 0.95 * x : -open * x,
                      0.8 * y},
                     0,
                     high,
                     0.02);
          make.box("lintel", {-open * x, -y, open * x, 0.8 * y}, 0.7 * high, high);
          make.box("back", {-open * x, -y, open * x, -0.8 * y}, 0, 0.7 * high);
          roundBox(make, "mantel", {-x, -y, x, y}, high, high + 0.06, 0.02);
          if (kind == 0)
            make.box("breast", {-0.8 * x, -y, 0.8 * x, 0.2 * y}, high + 0.06, z);
          return;
        }
        if (kind == 1) { // of steel, round, on a foot
          lathe(make,
                "body",
                {0, 0},
                {{0.3 * x, 0},
                 {0.25 * x, 0.15 * z},
                 {x, 0.25 * z},
                 {x, 0.45 * z},
                 {0.3 * x, 0.55 * z},
                 {0.2 * x, 0.6 * z},
                 {0.2 * x, z}},
                18);
          return make.box("foot", {-0.5 * x, -y, 0.5 * x, y}, 0, 0.02);
        }
        make.box("body", {-x, -y, x, y - 0.03}, 0.12, 0.6 * z); // a tiled stove
        make.box("plinth", {-0.9 * x, -y, 0.9 * x, 0.8 * y}, 0, 0.12);
        make.box("upper", {-0.8 * x, -y, 0.8 * x, 0.6 * y}, 0.6 * z, 0.95 * z);
        roundBox(make, "crown", {-0.9 * x, -y, 0.9 * x, 0.8 * y}, 0.95 * z, z, 0.03);
        roundBox(
            make, "door", {-0.4 * x, y - 0.03, 0.4 * x, y}, 0.2 * z, 0.42 * z, 0.01);
      });
}

FurnitureClass
person(bool sits)
{
  return fitted(
      "person",
      sits ? Size(0.5, 0.7, 1.2) : Size(0.45, 0.35, 1.5),
      sits ? Size(0.6, 0.9, 1.4) : Size(0.8, 0.5, 1.9),
      [sits](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, z = size.z(), hip = sits ? 0.4 * z : 0.5 * z,
                     rear = sits ? -0.25 : 0.0;
        for (const double s : {-1.0, 1.0}) {
          const double fore = sits ? 0.25 : draw.uniform(-0.1, 0.15), wide = 0.4 * x;
          tube(make,
               "leg",
               sits ? Path{{s * wide, rear, hip},
                           {s * wide, fore, hip + 0.02},
                           {s * wide, fore + 0.05, 0.05}}
                    : Path{{s * wide, rear, hip},
                           {s * wide, fore / 2, hip / 2},
                           {s * wide, fore, 0.05}},
               0.07,
               8);
          roundBox(make,
                   "shoe",
                   {s * wide - 0.05, fore - 0.06, s * wide + 0.05, fore + 0.2},
                   0,
                   0.09,
                   0.03);
          tube(make,
               "arm",
               {{s * 0.8 * x, rear, 0.8 * z},
                {s * x, rear + 0.05, 0.62 * z},
                {s * 0.7 * x,
                 rear + draw.uniform(0.1, 0.35),
                 draw.uniform(0.5, 0.65) * z}},
               0.045,
               8);
        }
        make.loft("trunk",
                  {-0.85 * x, rear - 0.13, 0.85 * x, rear + 0.13},
                  {{0.75, hip - 0.08}, {0.8, 0.6 * z}, {1, 0.78 * z}, {0.3, 0.86 * z}});
        ellipsoid(make, "head", {0, rear + 0.025, 0.93 * z}, {0.085, 0.1, 0.07 * z});
      },
      sits ? by_number : 0);
}

FurnitureClass
ball(int kind)
{
  return fitted("ball",
                {0.2, kind == 1 ? 0.13 : 0.2, kind == 1 ? 0.13 : 0.2},
                {0.65, kind == 1 ? 0.3 : 0.65, kind == 1 ? 0.3 : 0.65},
                [kind](PartMaker& make, const Size& size, RandomDraw&) {
                  const P half = size / 2;
                  if (kind == 1) // sags
                    return lathe(make,
                                 "ball",
                                 {0, 0},
                                 {{0.6 * half.x(), 0},
                                  {half.x(), 0.7 * half.z()},
                                  {0.85 * half.x(), 1.4 * half.z()},
                                  {0.45 * half.x(), 2 * half.z()}});
                  ellipsoid(make, "ball", {0, 0, half.z()}, half);
                  if (kind == 2) // with ears to hold on to
                    for (const double s : {-0.3, 0.3})
                      tube(make,
                           "horn",
                           {{s * half.x(), 0, 1.8 * half.z()},
                            {1.3 * s * half.x(), 0, 2.2 * half.z()}},
                           0.03);
                });
}

} // namespace

std::vector<FurnitureClass>
decorationShapes()
{
  return {
      picture({0.2, 0.02, 0.25}, {1.0, 0.05, 0.8}, Hanging::Deep),
      picture({0.4, 0.03, 0.4}, {1.4, 0.05, 1.0}, Hanging::Canvas),
      picture({0.25, 0.03, 0.25}, {0.7, 0.05, 0.7}, Hanging::Round),
      picture({0.9, 0.03, 0.4}, {1.5, 0.04, 0.8}, Hanging::Triptych),
      picture({0.25, 0.04, 0.25}, {0.4, 0.06, 0.4}, Hanging::Clock),
      picture({0.4, 0.03, 0.8}, {0.8, 0.05, 1.6}, Hanging::Mirror, by_number),
      picture({0.4, 0.12, 0.5}, {1.0, 0.3, 1.2}, Hanging::Leaning, by_number),
      writingBoard(0),
      writingBoard(1),
      writingBoard(2),
      fireplace(0),
      fireplace(1),
      fireplace(2),
      fireplace(3),
      person(false),
      person(true),
      ball(0),
      ball(1),
      ball(2),
  };
}

} // namespace pcl::indoor
