/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/shapes/solids.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl::indoor {

namespace {

enum class Top { Board, Rounded, Round, Oval, Boat, Tray, Frame };

/** A top and what carries it. */
struct TableStyle {
  Top top;
  Legs legs;
  bool shelf = false;
  bool apron = false;
};

void
addTop(PartMaker& make, Top kind, const Size& size, double thick)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(), low = z - thick;
  switch (kind) {
  case Top::Board:
    return make.box("top", {-x, -y, x, y}, low, z);
  case Top::Rounded: {
    const Rectangle r{-x, -y, x, y};
    return make.loft("top",
                     r,
                     {{0.99, low, 0.15},
                      {1, low + 0.3 * thick, 0.15},
                      {1, z - 0.2 * thick, 0.15},
                      {0.995, z, 0.15}},
                     28);
  }
  case Top::Round:
  case Top::Oval:
    return make.loft(
        "top", {-x, -y, x, y}, {{0.96, low}, {1, low + 0.5 * thick}, {1, z}}, 28);
  case Top::Boat:
    return sheet(
        make, "top", {12, 2, thick}, [&](double u, double v) -> Eigen::Vector3d {
          return {x * u, y * v * (1 - 0.25 * u * u), z - thick / 2};
        });
  case Top::Tray:
    make.box("top", {-x, -y, x, y}, low, z - 0.03);
    for (const double s : {-1.0, 1.0}) {
      block(make,
            "rim",
            {Eigen::Vector3d(-x, s > 0 ? y - 0.015 : -y, z - 0.03),
             Eigen::Vector3d(x, s > 0 ? y : -y + 0.015, z)});
      block(make,
            "rim",
            {Eigen::Vector3d(s > 0 ? x - 0.015 : -x, -y + 0.015, z - 0.03),
             Eigen::Vector3d(s > 0 ? x : -x + 0.015, y - 0.015, z)});
    }
    return;
  case Top::Frame:
    for (const double s : {-1.0, 1.0}) {
      block(make,
            "frame",
            {Eigen::Vector3d(-x, s > 0 ? y - 0.05 : -y, low),
             Eigen::Vector3d(x, s > 0 ? y : -y + 0.05, z)});
      block(make,
            "frame",
            {Eigen::Vector3d(s > 0 ? x - 0.05 : -x, -y + 0.05, low),
             Eigen::Vector3d(s > 0 ? x : -x + 0.05, y - 0.05, z)});
    }
    return make.box("top",
                    {-x + 0.05, -y + 0.05, x - 0.05, y - 0.05},
                    low + 0.3 * thick,
                    z - 0.004);
  }
}

void
buildTable(PartMaker& make, const Size& size, RandomDraw& draw, const TableStyle& style)
{
  const bool curved =
      style.top == Top::Round || style.top == Top::Oval || style.top == Top::Boat;
  const double thick = draw.uniform(0.022, 0.045),
               in = curved ? 0.7 : draw.uniform(0.86, 0.98);
  const Eigen::Vector2d half = in * size.head<2>() / 2;
  const double low = size.z() - thick - (style.top == Top::Tray ? 0.03 : 0.0);
  addTop(make, style.top, size, size.z() - low);
  legs(make, style.legs, half, low, draw);
  if (style.apron)
    for (const double s : {-1.0, 1.0}) {
      const double y = s * (half.y() - 0.03), x = s * (half.x() - 0.03);
      make.box("apron",
               {-half.x() + 0.04, y - 0.01, half.x() - 0.04, y + 0.01},
               low - 0.09,
               low);
      make.box("apron",
               {x - 0.01, -half.y() + 0.04, x + 0.01, half.y() - 0.04},
               low - 0.09,
               low);
    }
  if (style.shelf)
    make.loft("shelf",
              {-0.92 * half.x(), -0.92 * half.y(), 0.92 * half.x(), 0.92 * half.y()},
              {{1, 0.25 * low, curved ? 1.0 : 0.05},
               {1, 0.25 * low + 0.02, curved ? 1.0 : 0.05}},
              24);
}

FurnitureClass
table(const char* name,
      const Size& smallest,
      const Size& largest,
      const TableStyle& style)
{
  return styled(name, smallest, largest, style, buildTable);
}

/** A desk: what carries it, what is below and above it. */
struct DeskStyle {
  Legs legs;
  int drawers = 0;     ///< blocks of drawers below
  bool corner = false; ///< goes on at right angles, on the right
  bool hutch = false;  ///< shelves over its rear
  bool screen = false; ///< a low wall at its rear
  bool bent = false;   ///< its front is curved
};

void
deskTop(
    PartMaker& make, const Size& size, const DeskStyle& style, double depth, double z)
{
  const double x = size.x() / 2, y = size.y() / 2, rear = -y;
  if (style.bent)
    sheet(make, "top", {12, 2, 0.025}, [&](double u, double v) -> Eigen::Vector3d {
      return {x * u, rear + (v + 1) / 2 * depth * (1 - 0.18 * (1 - u * u)), z - 0.0125};
    });
  else
    make.box("top", {-x, rear, x, rear + depth}, z - 0.025, z);
  if (style.corner) {
    make.box("top", {x - 0.55, rear + depth, x, y}, z - 0.025, z);
    make.box("panel", {x - 0.55, y - 0.03, x, y}, 0, z - 0.025);
  }
}

void
buildDesk(PartMaker& make, const Size& size, RandomDraw& draw, const DeskStyle& style)
{
  const double x = size.x() / 2, rear = -size.y() / 2,
               top = style.hutch || style.screen ? draw.uniform(0.72, 0.76) : size.z();
  const double depth = style.corner ? std::min(0.7, 0.5 * size.y()) : size.y();
  std::vector<FurniturePart> none;
  deskTop(make, size, style, depth, top);
  PartMaker below({size.x(), depth, top}, false);
  legs(below, style.legs, {x - 0.02, depth / 2 - 0.02}, top - 0.025, draw);
  const double wide = draw.uniform(0.34, 0.42);
  for (int i = 0; i < style.drawers; ++i) {
    const double left = i == 0 ? x - wide - 0.05 : -x + 0.05;
    below.box("body",
              {left, -depth / 2 + 0.05, left + wide, depth / 2 - 0.06},
              0.06,
              0.93 * top);
    row(below,
        "drawer",
        {{left + 0.005, depth / 2 - 0.06, 0.08},
         {left + wide - 0.005, depth / 2 - 0.04, 0.3 * top}},
        {0, 0, 0.29 * top},
        3);
  }
  for (auto part : below.take().parts) {
    for (auto& t : part.triangles)
      for (auto* p : {&t.a, &t.b, &t.c})
        p->y() += static_cast<float>(rear + depth / 2);
    make.add(part.name, part.triangles);
  }
  if (style.screen)
    make.box("screen", {-x, rear, x, rear + 0.03}, top - 0.2, size.z());
  if (style.hutch) {
    for (const double s : {-x, -0.01, x - 0.02})
      make.box("side", {s, rear, s + 0.02, rear + 0.24}, top, size.z());
    row(make,
        "shelf",
        {{-x + 0.02, rear, size.z() - 0.02}, {x - 0.02, rear + 0.24, size.z()}},
        {0, 0, -0.42 * (size.z() - top)},
        2);
  }
}

FurnitureClass
desk(const Size& smallest, const Size& largest, const DeskStyle& style)
{
  return styled("desk", smallest, largest, style, buildDesk);
}

// A bureau whose flap is down or whose top slants.
void
slantedDesk(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               low = draw.uniform(0.6, 0.7) * z;
  legs(make, Legs::Tapered, {x - 0.02, y - 0.02}, low - 0.1, draw);
  make.frustum("case", {-x, -y, x, y}, low - 0.12, {-x, -y, x, y}, low);
  make.frustum("bureau", {-x, -y, x, y}, low, {-x, -y, x, -0.4 * y}, z);
}

// A pane on a body of one piece: pebbles, drums, tree trunks, cubes.
FurnitureClass
monolith(const char* name,
         const Size& smallest,
         const Size& largest,
         double corner,
         double foot,
         double waist)
{
  return fitted(
      name, smallest, largest, [=](PartMaker& make, const Size& size, RandomDraw&) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z();
        make.loft("body",
                  {-x, -y, x, y},
                  {{foot, 0, corner},
                   {foot, 0.1 * z, corner},
                   {waist, 0.5 * z, corner},
                   {0.95, z - 0.05, corner},
                   {1, z - 0.03, corner},
                   {1, z, corner}},
                  24);
      });
}

// Two or three tables that stand under each other.
void
nest(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  const int count = 2 + draw.pick(2);
  for (int i = 0; i < count; ++i) {
    const double s = 1 - 0.18 * i, z = size.z() * (1 - 0.12 * i), out = 0.15 * i * y;
    make.loft("top",
              {-0.8 * s * x, -y + out, 0.8 * s * x, out + 0.7 * y},
              {{1, z - 0.02, 0.1}, {1, z, 0.1}},
              20);
    for (const double sx : {-0.75 * s * x, 0.75 * s * x})
      tube(make,
           "leg",
           {{sx, -y + out + 0.03, z - 0.02},
            {sx, -y + out + 0.03, 0.01},
            {sx, out + 0.65 * y, 0.01},
            {sx, out + 0.65 * y, z - 0.02}},
           0.01,
           5);
  }
}

/** Beside a bed. */
struct NightStyle {
  Legs legs;
  int drawers, handle;
  bool open = false;
};

void
buildNight(PartMaker& make, const Size& size, RandomDraw& draw, const NightStyle& style)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               low = style.legs == Legs::Plinth ? 0.05 : draw.uniform(0.12, 0.22);
  const double body = style.open ? low + 0.6 * (z - low) : low;
  legs(make, style.legs, {x - 0.01, y - 0.02}, low, draw);
  make.box("body", {-x, -y, x, y - 0.04}, body, z);
  if (style.open) {
    for (const double s : {-x, x - 0.02})
      make.box("side", {s, -y, s + 0.02, y - 0.04}, low, body);
    make.box("shelf", {-x + 0.02, -y, x - 0.02, y - 0.04}, low, low + 0.02);
  }
  front(make, size, {1, style.drawers, true, style.handle, body, z - 0.01});
}

FurnitureClass
night(const NightStyle& style)
{
  return styled(
      "bedside_table", {0.36, 0.34, 0.42}, {0.6, 0.48, 0.65}, style, buildNight);
}

} // namespace

std::vector<FurnitureClass>
tableShapes()
{
  const Size low(0.9, 0.65, 0.7), high(2.2, 1.1, 0.78), small(0.7, 0.7, 0.7),
      large(1.4, 1.4, 0.78), oval_low(1.2, 0.8, 0.7), oval_high(2.0, 1.1, 0.78);
  const Size tea_low(0.7, 0.45, 0.32), tea_high(1.3, 0.8, 0.5),
      side_low(0.4, 0.4, 0.35), side_high(0.9, 0.9, 0.55);
  const Size desk_low(1.1, 0.55, 0.7), desk_high(1.8, 0.85, 0.78);
  return {
      table("table", low, high, {Top::Board, Legs::Tapered, false, true}),
      table("table", low, high, {Top::Rounded, Legs::Splayed}),
      table("table", low, high, {Top::Board, Legs::Hairpin}),
      table("table", low, high, {Top::Rounded, Legs::Sled}),
      table("table", low, high, {Top::Board, Legs::Crossed, true}),
      table("table", oval_low, oval_high, {Top::Oval, Legs::Columns}),
      table("table", oval_low, {3.0, 1.3, 0.78}, {Top::Boat, Legs::Columns}),
      table("table",
            {0.7, 0.7, 0.9},
            {1.2, 0.8, 1.1},
            {Top::Board, Legs::Straight, true}),
      table("table", low, high, {Top::Frame, Legs::Panels, true}),
      table("table", low, high, {Top::Board, Legs::Trestle}),
      table("table", {0.6, 0.6, 0.7}, {0.8, 0.8, 1.1}, {Top::Rounded, Legs::Pedestal}),
      table("round_table", small, large, {Top::Round, Legs::Tapered, false, true}),
      table("round_table", small, large, {Top::Round, Legs::Star}),
      table("round_table", small, large, {Top::Round, Legs::Splayed}),
      table("round_table", small, large, {Top::Round, Legs::Hairpin, true}),
      table("round_table", oval_low, oval_high, {Top::Oval, Legs::Splayed}),
      monolith("round_table", {0.6, 0.6, 0.7}, {1.2, 1.2, 0.76}, 1.0, 0.6, 0.35),
      table("round_table",
            {0.5, 0.5, 0.95},
            {0.7, 0.7, 1.1},
            {Top::Round, Legs::Pedestal}),
      desk({1.4, 1.3, 0.7}, {2.0, 1.8, 0.78}, {Legs::Straight, 1, true}),
      desk({1.4, 1.2, 0.7}, {2.0, 1.7, 0.78}, {Legs::Panels, 0, true}),
      desk({1.1, 0.55, 1.2}, {1.6, 0.8, 1.6}, {Legs::Panels, 1, false, true}),
      desk({1.2, 0.65, 1.0}, {1.8, 0.8, 1.25}, {Legs::Columns, 0, false, false, true}),
      desk(desk_low, desk_high, {Legs::Tapered, 1}),
      desk(desk_low, desk_high, {Legs::Crossed, 0}),
      desk({1.4, 0.8, 0.7},
           {2.0, 1.0, 0.78},
           {Legs::Columns, 1, false, false, false, true}),
      desk({1.5, 0.75, 0.72}, {2.0, 0.95, 0.78}, {Legs::Panels, 2}),
      fitted("desk", {0.8, 0.45, 0.9}, {1.2, 0.6, 1.15}, slantedDesk),
      table("coffee_table", tea_low, tea_high, {Top::Board, Legs::Hairpin}),
      table("coffee_table", tea_low, tea_high, {Top::Rounded, Legs::Tapered, true}),
      table("coffee_table", tea_low, tea_high, {Top::Tray, Legs::Splayed}),
      table("coffee_table", tea_low, tea_high, {Top::Frame, Legs::Panels, true}),
      table("coffee_table", tea_low, tea_high, {Top::Oval, Legs::Sled}),
      table("coffee_table", side_low, side_high, {Top::Round, Legs::Splayed, true}),
      table("coffee_table", side_low, side_high, {Top::Tray, Legs::Crossed}),
      monolith("coffee_table", side_low, side_high, 0.12, 0.9, 0.9),
      fitted("coffee_table", {0.5, 0.5, 0.4}, {0.8, 0.7, 0.6}, nest),
      night({Legs::Tapered, 2, 2}),
      night({Legs::Plinth, 3, 1}),
      night({Legs::Splayed, 1, 3, true}),
      night({Legs::Sled, 1, 0, true}),
      table("bedside_table",
            {0.35, 0.35, 0.45},
            {0.5, 0.5, 0.65},
            {Top::Round, Legs::Pedestal}),
  };
}

} // namespace pcl::indoor
