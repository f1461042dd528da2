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

// What holds a radiator on the wall, and its valve.
void
mounts(PartMaker& make, const Size& size)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  for (const double s : {-0.7, 0.7})
    make.box("mount", {s * x - 0.01, -y, s * x + 0.01, 0}, 0.1 * z, 0.3 * z);
  tube(make, "valve", {{x - 0.05, -0.5 * y, 0.0}, {x - 0.05, 0, 0.12}}, 0.012);
}

void
castIronRadiator(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const int ribs = std::max(3, static_cast<int>(size.x() / 0.075));
  for (int i = 0; i < ribs; ++i)
    roundBox(make,
             "rib",
             {-x + i * 2 * x / ribs, -y, -x + (i + 0.85) * 2 * x / ribs, y},
             0.05,
             z,
             0.03);
  make.join(ribs, "ribs");
  mounts(make, size);
}

// Two plates with fins between.
void
plateRadiator(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  roundBox(make, "plate", {-x, -y, x, -y + 0.02}, 0.06, z, 0.009);
  roundBox(make, "plate", {-x, y - 0.02, x, y}, 0.06, z, 0.009);
  row(make,
      "fin",
      {{-x + 0.02, -y + 0.02, 0.1}, {-x + 0.025, y - 0.02, z - 0.04}},
      {(2 * x - 0.05) / 15, 0, 0},
      16);
  make.join(16, "fins");
  mounts(make, size);
}

// A ladder to dry towels on.
void
towelRadiator(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  for (const double s : {-x + 0.015, x - 0.015})
    tube(make, "post", {{s, 0, 0}, {s, 0, z}}, 0.015);
  for (double at = 0.06; at < z - 0.05; at += 0.075)
    tube(make,
         "bar",
         {{-x + 0.015, 0, at}, {0, y - 0.012, at}, {x - 0.015, 0, at}},
         0.011,
         5);
  mounts(make, size);
}

void
louvres(PartMaker& make, const Size& size)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  row(make,
      "louvre",
      {{-0.85 * x, 0.5 * y, 0.12 * z}, {0.85 * x, y, 0.12 * z + 0.01}},
      {0, 0, 0.06 * z},
      3);
}

void
bentConditioner(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  sheet(make, "body", {1, 8, y}, [&](double u, double v) -> P {
    return {x * u, 0.3 * y * (1 - v * v) - 0.2 * y, 0.05 * z + (v + 1) / 2 * 0.9 * z};
  });
  louvres(make, size);
}

void
boxConditioner(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  roundBox(make, "body", {-x, -y, x, y - 0.02}, 0, z, 0.06);
  louvres(make, size);
}

void
roundConditioner(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, z = size.z();
  lathe(make,
        "body",
        {0, 0},
        {{0.8 * x, 0},
         {0.8 * x, 0.05 * z},
         {0.6 * x, 0.1 * z},
         {0.6 * x, 0.9 * z},
         {0.5 * x, z}},
        16);
  louvres(make, size);
}

// A bicycle to train on.
void
exerciseBicycle(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  for (const double s : {-0.8, 0.8})
    tube(make, "foot", {{-x, s * y, 0.03}, {x, s * y, 0.03}}, 0.03);
  tube(make,
       "frame",
       {{0, -0.8 * y, 0.05}, {0, -0.1 * y, 0.35 * z}, {0, 0.8 * y, 0.05}},
       0.03);
  tube(make,
       "wheel",
       arc({0, 0.55 * y, 0.35 * z},
           {0, 0.25 * z, 0},
           {0, 0, 0.25 * z},
           0,
           1.98 * M_PI,
           14),
       0.03);
  tube(make, "post", {{0, -0.3 * y, 0.3 * z}, {0, -0.5 * y, 0.68 * z}}, 0.025);
  pillow(make, "saddle", {{0, -0.5 * y, 0.7 * z}, {0.11, 0, 0}, {0, 0.14, 0}}, 0.08);
  tube(make,
       "handle",
       {{-0.7 * x, 0.3 * y, 0.95 * z},
        {-0.3 * x, 0.7 * y, 0.9 * z},
        {0.3 * x, 0.7 * y, 0.9 * z},
        {0.7 * x, 0.3 * y, 0.95 * z}},
       0.016);
  tube(make, "post", {{0, 0.6 * y, 0.4 * z}, {0, 0.7 * y, z}}, 0.025);
}

// To step: two long treads and poles.
void
stepper(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.box("rail", {-x, -y, x, y}, 0, 0.05);
  lathe(make, "wheel", {0, 0.7 * y}, {{0.6 * x, 0.05}, {0.6 * x, 0.4 * z}});
  for (const double s : {-0.7, 0.7}) {
    roundBox(make,
             "tread",
             {s * x - 0.09, -0.9 * y, s * x + 0.09, 0.3 * y},
             0.2 * z,
             0.25 * z,
             0.02);
    tube(make,
         "pole",
         {{s * x, 0.6 * y, 0.1 * z}, {s * x, 0.4 * y, 0.6 * z}, {s * x, 0.1 * y, z}},
         0.018);
  }
  make.box("panel", {-0.15, 0.55 * y, 0.15, 0.6 * y}, 0.75 * z, 0.95 * z);
}

// Wheels, a frame of tubes, a bar and a saddle.
FurnitureClass
bicycle(bool small)
{
  return fitted(
      "bicycle",
      small ? Size(0.45, 0.9, 0.6) : Size(0.5, 1.55, 0.95),
      small ? Size(0.55, 1.3, 0.85) : Size(0.65, 1.85, 1.15),
      [small](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
                     r = small ? 0.28 * z : 0.32 * z,
                     lean = draw.uniform(-0.1, 0.1) * x;
        for (const double s : {-1.0, 1.0}) {
          const auto wheel =
              arc({0, s * (y - r), r}, {0, r, 0}, {0, 0, r}, 0, 1.98 * M_PI, 18);
          tube(make, "wheel", wheel, 0.02, 5);
          for (int i = 0; i < 6; ++i)
            tube(make, "spoke", {{0, s * (y - r), r}, wheel[3 * i]}, 0.003, 3);
          make.join(7, "wheel");
        }
        const P hub(0, -0.05 * y, 0.8 * r), seat(0, -0.3 * y, 0.82 * z),
            head(0, y - 1.4 * r, 0.85 * z);
        tube(make,
             "frame",
             {{0, -(y - r), r},
              hub,
              head,
              small ? P(hub + P(0, 0.02, 0.1)) : P(0.97 * seat)},
             0.018);
        tube(make, "frame", {hub, seat}, 0.018);
        tube(make, "fork", {{0, y - r, r}, head + P(0, 0, 0.02)}, 0.018);
        pillow(
            make, "saddle", {seat + P(0, 0, 0.03), {0.08, 0, 0}, {0, 0.12, 0}}, 0.07);
        tube(make,
             "handle",
             {{-x, head.y() - 0.12, z - 0.02},
              {-0.6 * x, head.y(), z - 0.04},
              head + P(lean, 0, 0.04),
              {0.6 * x, head.y(), z - 0.04},
              {x, head.y() - 0.12, z - 0.02}},
             0.013);
        tube(make,
             "pedals",
             {{-0.14, hub.y() - 0.1, hub.z()},
              {-0.04, hub.y() - 0.1, hub.z()},
              {0.04, hub.y() + 0.1, hub.z()},
              {0.14, hub.y() + 0.1, hub.z()}},
             0.012);
      });
}

void
grandPiano(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const double top = 0.62 * z;
  legs(make, Legs::Tapered, {0.8 * x, 0.8 * y}, top - 0.25, draw);
  Polygon outline{{-x, y - 0.25},
                  {-x, -0.6 * y},
                  {-0.6 * x, -y},
                  {-0.2 * x, -y},
                  {0.2 * x, -0.6 * y},
                  {x, 0.1 * y},
                  {x, y - 0.25}};
  make.slab("body", outline, top - 0.25, top);
  make.box("keyboard", {-x, y - 0.25, x, y}, top - 0.2, top - 0.1);
  sheet(make, "lid", {4, 4, 0.02}, [&](double u, double v) -> P {
    const double t = (u + 1) / 2;
    return {-x + 1.7 * x * t,
            -0.1 * y + 0.7 * y * v * (1 - 0.5 * t),
            top + 0.02 + t * (z - top - 0.03)};
  });
}

// On a stand.
void
electricPiano(PartMaker& make, const Size& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(), keys = 0.9 * z;
  roundBox(make, "keyboard", {-x, -y, x, y}, keys, z, 0.02);
  for (const double s : {-1.0, 1.0})
    tube(make,
         "stand",
         {{s * 0.7 * x, -0.8 * y, 0.02}, {-s * 0.7 * x, 0.5 * y, keys}},
         0.02,
         4);
}

void
uprightPiano(PartMaker& make, const Size& size, bool has_music)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               keys = std::min(0.72, 0.6 * z);
  make.box("body", {-x, -y, x, -0.1 * y}, 0.05, z);
  for (const double s : {-x, x - 0.05}) {
    sheet(make, "cheek", {3, 2, 0.05}, [&](double u, double v) -> P {
      return {s + 0.025,
              -0.1 * y + (u + 1) / 2 * 1.1 * y,
              0.05 + (v + 1) / 2 * (keys + 0.05) * (1 - 0.2 * (u + 1) / 2)};
    });
    make.box("foot", {s, -y, s + 0.05, y}, 0, 0.05);
  }
  roundBox(
      make, "keyboard", {-x + 0.05, -0.1 * y, x - 0.05, y}, keys - 0.1, keys, 0.015);
  if (has_music)
    sheet(make, "music", {2, 2, 0.012}, [&](double u, double v) -> P {
      return {0.4 * x * u, -0.05 * y - 0.05 * v, keys + 0.16 + 0.12 * v};
    });
}

void
plainPiano(PartMaker& make, const Size& size, RandomDraw&)
{
  uprightPiano(make, size, false);
}

// With a rest for music.
void
musicPiano(PartMaker& make, const Size& size, RandomDraw&)
{
  uprightPiano(make, size, true);
}

} // namespace

std::vector<FurnitureClass>
deviceShapes()
{
  const Size wide_low(0.5, 0.08, 0.4), wide_high(1.6, 0.2, 0.9);
  const Size wall_low(0.7, 0.16, 0.24), wall_high(1.1, 0.28, 0.4),
      stand_low(0.3, 0.28, 0.7), stand_high(0.5, 0.42, 1.8);
  const Size train_low(0.6, 1.1, 1.1), train_high(0.8, 1.8, 1.5);
  const Size keys_low(1.2, 0.3, 0.8), keys_high(1.55, 0.65, 1.3);
  return {
      fitted("radiator", wide_low, wide_high, castIronRadiator),
      fitted("radiator", wide_low, wide_high, plateRadiator),
      fitted("radiator", {0.4, 0.08, 0.9}, {0.6, 0.14, 1.6}, towelRadiator),
      fitted("air_conditioner", wall_low, wall_high, bentConditioner, 0),
      fitted("air_conditioner", wall_low, wall_high, boxConditioner, 0),
      fitted("air_conditioner", stand_low, stand_high, boxConditioner, 1),
      fitted("air_conditioner", stand_low, stand_high, roundConditioner, 1),
      fitted("treadmill", train_low, train_high, exerciseBicycle),
      fitted("treadmill", train_low, train_high, stepper),
      bicycle(false),
      bicycle(true),
      fitted("piano", keys_low, keys_high, electricPiano),
      fitted("piano", keys_low, keys_high, plainPiano),
      fitted("piano", keys_low, keys_high, musicPiano),
      fitted("piano", {1.4, 1.5, 1.2}, {1.5, 2.1, 1.7}, grandPiano),
  };
}

} // namespace pcl::indoor
