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

// A turned bottle: shares of its radius and height.
FurnitureClass
bottle(const std::vector<Turn>& profile, bool grip)
{
  return fitted("bottle",
                {grip ? 0.1 : 0.05, 0.05, 0.15},
                {grip ? 0.18 : 0.1, 0.12, 0.35},
                [=](PartMaker& make, const Size& size, RandomDraw&) {
                  std::vector<Turn> turned;
                  for (const auto& t : profile)
                    turned.push_back({t.radius * size.y() / 2, t.z * size.z()});
                  lathe(make, "bottle", {0, 0}, turned, 14);
                  if (grip) {
                    const double r = size.y() / 2;
                    tube(make,
                         "handle",
                         {{0.8 * r, 0, 0.75 * size.z()},
                          {1.8 * r, 0, 0.65 * size.z()},
                          {1.7 * r, 0, 0.35 * size.z()},
                          {0.8 * r, 0, 0.25 * size.z()}},
                         0.12 * r);
                  }
                });
}

// Hollow objects: shares of radius and height of their outer side, from foot to rim.
FurnitureClass
vessel(const char* name,
       const Size& smallest,
       const Size& largest,
       const std::vector<Section>& outside,
       int handles)
{
  return fitted(
      name,
      smallest,
      largest,
      [=](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double grip = handles > 0 ? 0.14 * size.x() : 0.0,
                     right = size.x() / 2 - grip,
                     left = handles == 2 ? -right : -size.x() / 2;
        const double y = std::min(size.y() / 2, (right - left) / 2), z = size.z(),
                     low = draw.uniform(0.25, 0.5) * z;
        std::vector<Section> sections = outside;
        for (auto& s : sections)
          s.z *= z;
        make.hollow(name, {left, -y, right, y}, sections, draw.uniform(0.002, 0.006));
        for (int i = 0; i < handles; ++i) {
          const double s = i == 0 ? 1 : -1, near = s * (right - 0.006);
          tube(make,
               "handle",
               arc({near, 0, (low + 0.85 * z) / 2},
                   {s * grip, 0, 0},
                   {0, 0, (0.85 * z - low) / 2},
                   -M_PI / 2,
                   M_PI / 2,
                   6),
               0.006,
               5);
        }
      });
}

// What stands on the floor or a shelf and holds objects.
// A basket of wire or wicker.
void
wicker(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  return make.vessel("bin", {-x, -y, x, y}, 0, z, 0.7, 1.0, 1.0);
}

// With a lid that swings.
void
swingBin(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.loft("bin", {-x, -y, x, y}, {{0.85, 0, 0.15}, {1, 0.75 * z, 0.15}}, 20);
  return make.frustum(
      "lid", {-x, -y, x, y}, 0.75 * z, {-0.8 * x, -0.15 * y, 0.8 * x, 0.15 * y}, z);
}

// A bag of a bin is seen over its rim.
void
baggedBin(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.vessel(
      "bin", {-0.95 * x, -0.95 * y, 0.95 * x, 0.95 * y}, 0, 0.95 * z, 0.8, 0.95, 1.0);
  const double phase = draw.uniform(0, 6);
  return sheet(make, "bag", {24, 2, 0.004}, [&](double u, double v) -> P {
    const double a = M_PI * u * 0.999, r = 1 + 0.03 * std::sin(5 * a + phase);
    return {r * x * std::cos(a),
            r * y * std::sin(a),
            z - (v + 1) * 0.1 * z - 0.02 * z * std::sin(3 * a + phase)};
  });
}

// Two or three for sorted waste.
void
sortedBins(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  for (int i = 0; i < 3; ++i)
    make.vessel("bin",
                {-x + i * 0.67 * x, -y, -x + i * 0.67 * x + 0.64 * x, y},
                0,
                z,
                0.9,
                1.0,
                0.15);
}

// On wheels, with a hinged lid.
void
wheeledBin(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.frustum("bin",
               {-0.75 * x, -0.75 * y, 0.75 * x, 0.7 * y},
               0.06,
               {-x, -y, x, 0.9 * y},
               0.9 * z);
  for (const double s : {-0.8, 0.8})
    tube(make,
         "wheel",
         {{s * x - 0.02, -0.7 * y, 0.07}, {s * x + 0.02, -0.7 * y, 0.07}},
         0.07,
         10);
  return sheet(make, "lid", {2, 5, 0.02}, [&](double u, double v) -> P {
    return {x * u, y * v, 0.92 * z + 0.06 * z * (1 - v * v)};
  });
}

void
domeBin(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.loft("bin",
            {-x, -y, x, y},
            {{0.97, 0},
             {1, 0.02 * z},
             {1, 0.8 * z},
             {0.9, 0.92 * z},
             {0.5, 0.99 * z},
             {0.2, z}},
            20); // a dome
}

// Boxes of cardboard, baskets, crates.
// Open, its flaps stand out.
void
flappedBox(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(), flap = 0.25 * z;
  make.vessel(
      "box", {-0.85 * x, -0.85 * y, 0.85 * x, 0.85 * y}, 0, z - flap, 1, 1, 0.02);
  for (const double s : {-1.0, 1.0}) {
    const double tilt = draw.uniform(0.05, 0.15);
    sheet(make, "flap", {1, 1, 0.006}, [&](double u, double v) -> P {
      return {s * x * (0.85 + tilt * (v + 1) / 2),
              0.83 * y * u,
              z - flap + (v + 1) / 2 * flap * (1 - tilt)};
    });
    sheet(make, "flap", {1, 1, 0.006}, [&](double u, double v) -> P {
      return {0.83 * x * u,
              s * y * (0.85 + (0.15 - tilt / 2) * (v + 1) / 2),
              z - flap + (v + 1) / 2 * flap * 0.9};
    });
  }
}

// A basket with rounded corners and handles.
void
basket(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.vessel("basket", {-x, -y, x, y}, 0, 0.9 * z, 0.85, 1.0, 0.3);
  for (const double s : {-0.95, 0.95})
    tube(make,
         "handle",
         arc({s * x, 0, 0.85 * z}, {0, 0.5 * y, 0}, {0, 0, 0.15 * z}, 0, M_PI, 6),
         0.01,
         5);
}

// A crate of slats.
void
crate(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  for (const double s : {-1.0, 1.0}) {
    row(make,
        "slat",
        {{-x, s > 0 ? y - 0.012 : -y, 0}, {x, s > 0 ? y : -y + 0.012, 0.25 * z}},
        {0, 0, 0.37 * z},
        3);
    row(make,
        "slat",
        {{s > 0 ? x - 0.012 : -x, -y + 0.012, 0},
         {s > 0 ? x : -x + 0.012, y - 0.012, 0.25 * z}},
        {0, 0, 0.37 * z},
        3);
  }
  return make.box("bottom", {-x + 0.012, -y + 0.012, x - 0.012, y - 0.012}, 0, 0.01);
}

// A stack, each turned a little.
void
stackedBoxes(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  double low = 0;
  for (int i = 0; i < 3; ++i) {
    const double high = i == 2 ? z : low + z * draw.uniform(0.25, 0.36),
                 sx = x * draw.uniform(0.6, 0.9), sy = y * draw.uniform(0.6, 0.9),
                 a = draw.uniform(-0.15, 0.15);
    make.slab("box", turnedRectangle({0, 0}, {2 * sx, 2 * sy}, a), low, high);
    low = high;
  }
}

void
clippedBox(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  roundBox(make,
           "box",
           {-x, -y, x, y - 0.01},
           0,
           0.85 * z,
           0.02); // of plastic, lid and clips
  roundBox(make, "lid", {-x - 0.01, -y - 0.01, x + 0.01, y}, 0.85 * z, z, 0.015);
}

FurnitureClass
books(int kind)
{
  const bool upright = kind == 1 || kind == 2;
  return fitted(
      "books",
      upright ? Size(0.15, 0.15, 0.18) : Size(0.15, 0.12, 0.03),
      upright ? Size(0.6, 0.25, 0.32) : Size(0.34, 0.28, 0.35),
      [kind](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z();
        if (kind == 0) { // a stack, none quite on the other
          const int count = 2 + draw.pick(7);
          for (int i = 0; i < count; ++i) {
            const double sx = x * draw.uniform(0.65, 0.95),
                         sy = y * draw.uniform(0.65, 0.95),
                         a = draw.uniform(-0.25, 0.25);
            make.slab("book",
                      turnedRectangle({0, 0}, {2 * sx, 2 * sy}, a),
                      z * i / count,
                      z * (i + 1) / count);
          }
          return;
        }
        if (kind == 3) // open
          return sheet(make, "book", {8, 1, 0.3 * z}, [&](double u, double v) -> P {
            return {
                x * u,
                y * v,
                z * (0.2 + 0.7 * std::sin(M_PI * std::min(1.0, 1.3 * std::abs(u))))};
          });
        const double lean = kind == 2 ? 0.3 : 0.0;
        for (double left = -x;
             left < x - 0.015;) { // a row; some lean on their neighbours
          const double wide = std::min(draw.uniform(0.015, 0.05), x - left),
                       high = z * draw.uniform(0.7, 1.0);
          const double slant = left > 0.2 * x ? lean * high : 0.0,
                       front = draw.uniform(0.3, 1.0) * y;
          std::vector<Path> rings{{{left, -y, 0},
                                   {left + wide, -y, 0},
                                   {left + wide - slant, -y, high},
                                   {left - slant, -y, high}},
                                  {}};
          for (auto p : rings[0])
            rings[1].push_back({p.x(), front, p.z()});
          skin(make, "book", rings);
          left += wide;
        }
      });
}

} // namespace

std::vector<FurnitureClass>
vesselShapes()
{
  const Size bowl_low(0.1, 0.1, 0.025), bowl_high(0.32, 0.32, 0.15),
      mug_low(0.08, 0.07, 0.07), mug_high(0.14, 0.11, 0.14), cup_low(0.06, 0.06, 0.08),
      cup_high(0.1, 0.1, 0.16);
  return {
      bottle({{1, 0}, {1, 0.45}, {0.9, 0.55}, {0.3, 0.75}, {0.28, 1}, {0.2, 1}}, false),
      bottle({{0.8, 0}, {1, 0.05}, {1, 0.8}, {0.6, 0.86}, {0.5, 0.86}, {0.5, 1}},
             false),
      bottle({{0.9, 0}, {1, 0.1}, {1, 0.7}, {0.5, 0.85}, {0.4, 1}}, true),
      vessel("bowl", bowl_low, bowl_high, {{0.3, 0}, {0.8, 0.25}, {1, 1}}, 0),
      vessel("bowl",
             {0.16, 0.16, 0.02},
             {0.32, 0.32, 0.04},
             {{0.6, 0}, {0.7, 0.3}, {1, 1}},
             0),
      vessel("mug", mug_low, mug_high, {{0.7, 0}, {1, 0.4}, {0.9, 0.8}, {1, 1}}, 1),
      vessel("mug",
             {0.18, 0.14, 0.1},
             {0.34, 0.26, 0.22},
             {{0.95, 0}, {1, 0.1}, {1, 1}},
             2),
      vessel("cup", cup_low, cup_high, {{0.7, 0}, {1, 1}}, 0),
      vessel("cup",
             cup_low,
             {0.1, 0.1, 0.2},
             {{0.7, 0}, {0.15, 0.05}, {0.15, 0.5}, {1, 0.7}, {0.85, 1}},
             0),
      fitted("bin", {0.22, 0.2, 0.25}, {0.5, 0.45, 0.7}, wicker),
      fitted("bin", {0.22, 0.2, 0.25}, {0.5, 0.45, 0.7}, swingBin),
      fitted("bin", {0.22, 0.2, 0.25}, {0.5, 0.45, 0.7}, baggedBin),
      fitted("bin", {0.22, 0.2, 0.25}, {0.5, 0.45, 0.7}, sortedBins),
      fitted("bin", {0.22, 0.2, 0.25}, {0.5, 0.45, 1.0}, wheeledBin),
      fitted("bin", {0.22, 0.2, 0.25}, {0.5, 0.45, 0.7}, domeBin),
      fitted("box", {0.2, 0.15, 0.12}, {0.65, 0.5, 0.5}, flappedBox),
      fitted("box", {0.2, 0.15, 0.12}, {0.65, 0.5, 0.5}, basket),
      fitted("box", {0.2, 0.15, 0.12}, {0.65, 0.5, 0.5}, crate),
      fitted("box", {0.2, 0.15, 0.12}, {0.65, 0.5, 0.9}, stackedBoxes),
      fitted("box", {0.2, 0.15, 0.12}, {0.65, 0.5, 0.5}, clippedBox),
      books(0),
      books(1),
      books(2),
      books(3),
  };
}

} // namespace pcl::indoor
