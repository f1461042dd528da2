/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/shapes/seating_kit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

// A back bent around the sitter: bend 0 is flat, 1 reaches to the front.
SheetShape
bentBack(const Frame& f, double low, double bend, double lean)
{
  return [=](double u, double v) -> Eigen::Vector3d {
    const double t = (v + 1) / 2, angle = u * bend * M_PI / 2;
    const double across = bend > 0.05 ? std::sin(angle) / std::sin(bend * M_PI / 2) : u;
    const double in = bend * (1 - std::cos(angle)) * (f.y - f.rear);
    return {f.x * across,
            f.rear + in - lean * t,
            low + t * (f.top - low) * (1 - 0.12 * bend * u * u)};
  };
}

void
addBars(PartMaker& make, const Frame& f, int count, bool upright)
{
  const double lean = 0.06, in = 0.02;
  for (const double x : {-f.x + in, f.x - in})
    tube(make,
         "post",
         {{x, f.rear + in, f.seat - 0.03}, {x, f.rear + in - lean, f.top}},
         0.014);
  for (int i = 0; i < count; ++i) {
    const double t = (i + 0.5) / count;
    if (upright)
      tube(make,
           "bar",
           {{(2 * t - 1) * (f.x - 0.05), f.rear + in, f.seat - 0.01},
            {(2 * t - 1) * (f.x - 0.04), f.rear + in - lean, f.top - 0.02}},
           0.007,
           5);
    else
      sheet(make, "slat", {5, 1, 0.014}, [&](double u, double v) -> Eigen::Vector3d {
        const double s = 0.2 + 0.8 * t;
        return {u * (f.x - in),
                f.rear + in - lean * s - 0.025 * (1 - u * u),
                f.seat + s * (f.top - f.seat) - 0.03 + 0.025 * v};
      });
  }
  if (upright)
    sheet(make, "rail", {5, 1, 0.016}, [&](double u, double v) -> Eigen::Vector3d {
      return {
          u * f.x, f.rear + in - lean - 0.02 * (1 - u * u), f.top - 0.03 + 0.03 * v};
    });
}

void
addMesh(PartMaker& make, const Frame& f)
{
  const double low = f.seat + 0.06, lean = 0.08;
  const auto shape = bentBack(f, low, 0.25, lean);
  Path rim;
  for (const auto& p : {Eigen::Vector2d(-1, -1),
                        Eigen::Vector2d(-1, 0),
                        Eigen::Vector2d(-1, 1),
                        Eigen::Vector2d(0, 1),
                        Eigen::Vector2d(1, 1),
                        Eigen::Vector2d(1, 0),
                        Eigen::Vector2d(1, -1),
                        Eigen::Vector2d(0, -1),
                        Eigen::Vector2d(-0.98, -1)})
    rim.push_back(shape(p.x(), p.y()));
  tube(make, "frame", rim, 0.012, 5);
  sheet(make, "mesh", {6, 4, 0.003}, [&](double u, double v) {
    return shape(0.96 * u, 0.96 * v);
  });
  tube(make,
       "spine",
       {{0, f.rear + 0.12, f.seat - 0.05},
        {0, f.rear - 0.03, f.seat},
        shape(0, 0) - Eigen::Vector3d(0, 0.03, 0)},
       0.018);
}

void
buildSeating(PartMaker& make, const Size& size, RandomDraw& draw, const Seating& style)
{
  const bool has_back = style.back != Back::None;
  const double wide = style.arms >= Arms::Thick ? 0.12 : 0.0;
  Frame f{size.x() / 2 - wide, size.y() / 2, 0, 0, size.z()};
  f.rear = -size.y() / 2 + (has_back ? draw.uniform(0.06, 0.1) : 0.0);
  f.seat =
      has_back ? size.z() * (style.seat_share + draw.uniform(-0.03, 0.03)) : size.z();
  const double under = style.seat == Seat::Thick     ? 0.16
                       : style.seat == Seat::Cushion ? 0.11
                       : style.seat == Seat::Padded  ? 0.07
                                                     : 0.03;
  legs(make, style.legs, {f.x, f.y}, std::max(0.04, f.seat - under), draw);
  addSeat(make, style.seat, f);
  addBack(make, style.back, f);
  addArms(make, style.arms, f);
}

} // namespace

void
addSeat(PartMaker& make, Seat kind, const Frame& f)
{
  const Rectangle r{-f.x, f.rear, f.x, f.y};
  const Eigen::Vector3d middle(0, (f.rear + f.y) / 2, f.seat);
  const double depth = (f.y - f.rear) / 2;
  switch (kind) {
  case Seat::Board:
    return roundBox(make, "seat", r, f.seat - 0.03, f.seat, 0.012);
  case Seat::Saddle:
    return sheet(
        make, "seat", {6, 6, 0.02}, [&](double u, double v) -> Eigen::Vector3d {
          return middle +
                 Eigen::Vector3d(f.x * u,
                                 depth * v,
                                 -0.025 * (1 - u * u) * (1 - 0.5 * v) + 0.01 * v -
                                     0.02 * std::pow(std::max(0.0, v), 4));
        });
  case Seat::Round:
    return make.loft(
        "seat",
        r,
        {{0.95, f.seat - 0.04}, {1, f.seat - 0.03}, {1, f.seat - 0.01}, {0.94, f.seat}},
        20);
  case Seat::Padded:
    return roundBox(make, "seat", r, f.seat - 0.07, f.seat, 0.035);
  case Seat::Cushion:
    make.box("base", r, f.seat - 0.11, f.seat - 0.06);
    return pillow(make,
                  "cushion",
                  {middle - Eigen::Vector3d(0, 0, 0.04), {f.x, 0, 0}, {0, depth, 0}},
                  0.1);
  case Seat::Thick:
    return roundBox(make, "seat", r, f.seat - 0.16, f.seat, 0.06);
  }
}

void
addBack(PartMaker& make, Back kind, const Frame& f)
{
  const double middle = (f.seat + f.top) / 2;
  switch (kind) {
  case Back::None:
    return;
  case Back::Slats:
    return addBars(make, f, 3, false);
  case Back::Ladder:
    return addBars(make, f, 5, false);
  case Back::Bars:
    return addBars(make, f, 7, true);
  case Back::Board:
    return sheet(make, "back", {4, 3, 0.018}, bentBack(f, f.seat - 0.02, 0.12, 0.06));
  case Back::Curved:
    return sheet(make, "back", {8, 3, 0.018}, bentBack(f, f.seat + 0.08, 0.55, 0.04));
  case Back::Round:
    return sheet(make, "back", {12, 3, 0.05}, bentBack(f, f.seat - 0.04, 0.9, 0.02));
  case Back::Mesh:
    return addMesh(make, f);
  case Back::Padded:
    return pillow(make,
                  "back",
                  {{0, f.rear, middle + 0.02},
                   {f.x, 0, 0},
                   {0, -0.05, (f.top - f.seat) / 2 + 0.02}},
                  0.1);
  case Back::Tufted:
    roundBox(make,
             "back",
             {-f.x, f.rear - 0.08, f.x, f.rear + 0.03},
             f.seat - 0.1,
             f.top,
             0.05);
    for (int i = 0; i < 3; ++i)
      pillow(make,
             "pad",
             {{(i - 1) * 0.62 * f.x, f.rear + 0.04, middle},
              {0.3 * f.x, 0, 0},
              {0, -0.03, 0.42 * (f.top - f.seat)}},
             0.07);
    return;
  }
}

void
addArms(PartMaker& make, Arms kind, const Frame& f)
{
  const double high = f.seat + 0.2, low = f.seat - 0.06, front = f.y - 0.08;
  for (const double s : {-1.0, 1.0}) {
    const double x = s * f.x;
    const auto across = [&](double wide) {
      return Rectangle{std::min(x - s * 0.01, x + s * wide),
                       f.rear,
                       std::max(x - s * 0.01, x + s * wide),
                       f.y - 0.02};
    };
    switch (kind) {
    case Arms::None:
      return;
    case Arms::Thin:
      tube(make,
           "armrest",
           {{x, front, low}, {x, front, high}, {x, f.rear, high}},
           0.012);
      break;
    case Arms::Loop:
      tube(make,
           "armrest",
           arc({x, (f.rear + front) / 2, low + 0.02},
               {0, (front - f.rear) / 2, 0},
               {0, 0, high - low},
               0,
               M_PI,
               8),
           0.014);
      break;
    case Arms::Thick:
      roundBox(make, "armrest", across(0.13), f.seat - 0.2, high, 0.02);
      break;
    case Arms::Rounded:
      roundBox(make, "armrest", across(0.1), f.seat - 0.2, high - 0.06, 0.03);
      tube(make,
           "roll",
           {{x + s * 0.05, f.rear, high - 0.05},
            {x + s * 0.05, f.y - 0.02, high - 0.05}},
           0.085,
           10);
      break;
    case Arms::Wings:
      roundBox(make, "armrest", across(0.1), f.seat - 0.2, high, 0.04);
      sheet(make, "wing", {2, 3, 0.05}, [&](double u, double v) -> Eigen::Vector3d {
        const double t = (v + 1) / 2;
        return {x + s * 0.04,
                f.rear + (u + 1) / 2 * (0.3 - 0.12 * t),
                high + t * (f.top - high)};
      });
      break;
    }
  }
}

FurnitureClass
seating(const char* name,
        const Size& smallest,
        const Size& largest,
        const Seating& style,
        int like)
{
  return styled(name, smallest, largest, style, buildSeating, like);
}

// An egg or shell of one piece on any legs.
FurnitureClass
shell(const char* name, const Size& smallest, const Size& largest, Legs carrier)
{
  return fitted(
      name,
      smallest,
      largest,
      [carrier](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2,
                     seat = draw.uniform(0.42, 0.48) * size.z();
        legs(make, carrier, {0.75 * x, 0.75 * y}, seat, draw);
        sheet(make, "shell", {8, 10, 0.02}, [&](double u, double v) -> Eigen::Vector3d {
          const double t = (v + 1) / 2, back = std::max(0.0, t - 0.45) / 0.55;
          const double rim = u * u * (0.12 + 0.1 * std::sin(M_PI * t));
          return {x * u * (1 - 0.35 * back * back),
                  y * (1 - 2 * std::min(1.0, t / 0.6)) - 0.04 * back +
                      0.12 * u * u * back,
                  seat + rim + (size.z() - seat) * back - 0.03 * std::pow(1 - t, 4)};
        });
      });
}

} // namespace pcl::indoor
