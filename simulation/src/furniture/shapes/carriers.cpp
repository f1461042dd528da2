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

using Half = Eigen::Vector2d;

constexpr double board = 0.02; // metres thick

template <class Leg>
void
atCorners(const Half& half, double in, const Leg& leg)
{
  for (const double sx : {-1.0, 1.0})
    for (const double sy : {-1.0, 1.0})
      leg(sx * (half.x() - in), sy * (half.y() - in), sx, sy);
}

void
squareLegs(PartMaker& make, const Half& half, double z, double foot, double head)
{
  atCorners(half, head, [&](double x, double y, double, double) {
    make.frustum("leg",
                 {x - foot, y - foot, x + foot, y + foot},
                 0,
                 {x - head, y - head, x + head, y + head},
                 z);
  });
}

void
slantedLegs(PartMaker& make, const Half& half, double z, double radius, double splay)
{
  atCorners(half, radius, [&](double x, double y, double sx, double sy) {
    tube(make, "leg", {{x, y, 0}, {x - sx * splay, y - sy * splay, z}}, radius);
  });
}

void
hairpinLegs(PartMaker& make, const Half& half, double z)
{
  atCorners(half, 0.01, [&](double x, double y, double sx, double sy) {
    tube(make,
         "leg",
         {{x - sx * 0.12, y, z}, {x, y, 0.008}, {x, y - sy * 0.1, z}},
         0.006,
         5);
  });
}

void
runners(PartMaker& make, const Half& half, double z)
{
  constexpr double r = 0.013;
  for (const double x : {-half.x() + r, half.x() - r})
    tube(make,
         "runner",
         {{x, half.y() - 0.05, z},
          {x, half.y() - r, 0.05},
          {x, half.y() - 0.06, r},
          {x, -half.y() + 0.06, r},
          {x, -half.y() + r, 0.05},
          {x, -half.y() + 0.08, z}},
         r);
}

void
star(PartMaker& make, const Half& half, double z, bool wheels)
{
  const double reach = half.minCoeff(), low = wheels ? 0.06 : 0.015;
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * M_PI * i / 5 + 0.3;
    const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0);
    tube(make,
         "arm",
         {Eigen::Vector3d(0, 0, low + 0.05),
          (reach - 0.02) * out + Eigen::Vector3d(0, 0, low)},
         0.016,
         5);
    if (wheels)
      ellipsoid(make,
                "castor",
                (reach - 0.028) * out + Eigen::Vector3d(0, 0, 0.028),
                {0.028, 0.028, 0.028});
  }
  make.join(wheels ? 10 : 5, "star");
  lathe(make,
        "column",
        {0, 0},
        {{0.03, low}, {0.03, 0.5 * z}, {0.02, 0.5 * z}, {0.02, z}});
}

void
crossed(PartMaker& make, const Half& half, double z)
{
  constexpr double r = 0.018;
  for (const double x : {-half.x() + r, half.x() - r})
    for (const double s : {-1.0, 1.0})
      tube(
          make, "leg", {{x, s * (half.y() - r), 0}, {x, -s * (half.y() - r), z}}, r, 4);
}

void
trestles(PartMaker& make, const Half& half, double z)
{
  const double x = 0.75 * half.x();
  for (const double at : {-x, x})
    for (const double sx : {-1.0, 1.0})
      for (const double sy : {-1.0, 1.0})
        tube(make,
             "leg",
             {{at + sx * 0.14, sy * 0.95 * half.y(), 0}, {at, sy * 0.8 * half.y(), z}},
             0.018,
             4);
  for (const double at : {-x, x})
    tube(make,
         "bar",
         {{at, -0.85 * half.y(), 0.95 * z}, {at, 0.85 * half.y(), 0.95 * z}},
         0.018,
         4);
}

void
columns(PartMaker& make, const Half& half, double z)
{
  for (const double x : {-0.6 * half.x(), 0.6 * half.x()}) {
    roundBox(make, "foot", {x - 0.04, -half.y(), x + 0.04, half.y()}, 0, 0.04, 0.015);
    make.box("column", {x - 0.035, -0.05, x + 0.035, 0.05}, 0.03, z);
  }
}

void
panels(PartMaker& make, const Half& half, double z)
{
  for (const double x : {-half.x(), half.x() - 0.03})
    make.box("panel", {x, -half.y(), x + 0.03, half.y()}, 0, z);
  make.box("rail", {-half.x() + 0.03, -0.01, half.x() - 0.03, 0.01}, 0.5 * z, z);
}

void
pedestal(PartMaker& make, const Half& half, double z)
{
  const double r = half.minCoeff();
  lathe(make,
        "pedestal",
        {0, 0},
        {{0.85 * r, 0},
         {0.85 * r, 0.015},
         {0.2 * r, 0.05},
         {0.14 * r, 0.5 * z},
         {0.2 * r, 0.93 * z},
         {0.35 * r, z}},
        16);
}

// On a leaf: doors have it at the side where they open.
void
addHandle(PartMaker& make, const Corners& leaf, const Front& face, bool on_right)
{
  const Eigen::Vector3d middle = (leaf.low + leaf.high) / 2;
  const double rear = leaf.high.y(), reach = rear + 0.014,
               tall = leaf.high.z() - leaf.low.z();
  const double at = face.drawers ? middle.x()
                    : on_right   ? leaf.high.x() - 0.05
                                 : leaf.low.x() + 0.05;
  const double up = tall > 1.2 ? middle.z() : leaf.high.z() - std::min(0.1, 0.5 * tall);
  const double half =
      std::min(0.07, 0.3 * (face.drawers ? leaf.high.x() - leaf.low.x() : tall));
  const Eigen::Vector3d along =
      face.drawers ? Eigen::Vector3d(half, 0, 0) : Eigen::Vector3d(0, 0, half);
  if (face.handle == 1) {
    const Eigen::Vector3d foot(at, rear, up), head(at, reach, up);
    tube(make,
         "handle",
         {foot - along, head - along, head + along, foot + along},
         0.006,
         5);
  }
  else if (face.handle == 2)
    ellipsoid(make, "knob", {at, rear + 0.008, up}, {0.014, 0.012, 0.014});
  else if (face.handle == 3)
    make.box("rail",
             {leaf.low.x(), rear, leaf.high.x(), rear + 0.015},
             leaf.high.z() - 0.025,
             leaf.high.z());
}

} // namespace

void
legs(PartMaker& make, Legs kind, const Half& half, double z, RandomDraw& draw)
{
  const double x = half.x(), y = half.y(), thick = draw.uniform(0.014, 0.026);
  switch (kind) {
  case Legs::Straight:
    return squareLegs(make, half, z, thick, thick);
  case Legs::Tapered:
    return squareLegs(make, half, z, 0.5 * thick, 1.2 * thick);
  case Legs::Splayed:
    return slantedLegs(
        make, half, z, 0.8 * thick, std::min(0.08, 0.2 * half.minCoeff()));
  case Legs::Hairpin:
    return hairpinLegs(make, half, z);
  case Legs::Sled:
    return runners(make, half, z);
  case Legs::Pedestal:
    return pedestal(make, half, z);
  case Legs::Star:
    return star(make, half, z, false);
  case Legs::Castors:
    return star(make, half, z, true);
  case Legs::Panels:
    return panels(make, half, z);
  case Legs::Trestle:
    return trestles(make, half, z);
  case Legs::Crossed:
    return crossed(make, half, z);
  case Legs::Columns:
    return columns(make, half, z);
  case Legs::Plinth:
    return make.box("plinth", {-x + 0.03, -y + 0.03, x - 0.03, y - 0.05}, 0, z);
  case Legs::Skirt:
    return make.box("skirt", {-x, -y, x, y}, 0, z);
  }
}

void
front(PartMaker& make, const Size& size, const Front& face)
{
  constexpr double gap = 0.005; // metres between doors
  const double x = size.x() / 2, y = size.y() / 2, width = size.x() / face.columns,
               pitch = (face.z1 - face.z0) / face.rows;
  for (int i = 0; i < face.columns; ++i)
    for (int k = 0; k < face.rows; ++k) {
      const Corners leaf{
          {-x + i * width + gap, y - 0.04, face.z0 + k * pitch + gap},
          {-x + (i + 1) * width - gap, y - 0.02, face.z0 + (k + 1) * pitch - gap}};
      block(make, face.drawers ? "drawer" : "door", leaf);
      addHandle(make, leaf, face, i % 2 == 0);
    }
}

void
openCase(PartMaker& make, const Corners& b, int bays, int rows, bool back)
{
  const auto &l = b.low, &h = b.high;
  const double wide = (h.x() - l.x() - board) / bays,
               pitch = (h.z() - l.z() - board) / rows;
  row(make,
      "side",
      {{l.x(), l.y(), l.z()}, {l.x() + board, h.y(), h.z()}},
      {wide, 0, 0},
      bays + 1);
  for (int i = 0; i < bays; ++i)
    row(make,
        "shelf",
        {{l.x() + i * wide + board, l.y() + 0.008, l.z()},
         {l.x() + (i + 1) * wide, h.y() - 0.002, l.z() + board}},
        {0, 0, pitch},
        rows + 1);
  if (back)
    make.box("back",
             {l.x() + board, l.y(), h.x() - board, l.y() + 0.008},
             l.z() + board,
             h.z() - board);
}

void
rings(PartMaker& make, double x, double y, double z, double reach)
{
  for (const double sx : {-1.0, 1.0})
    for (const double sy : {-1.0, 1.0})
      lathe(make,
            "ring",
            {x + sx * reach, y + sy * reach},
            {{0.8 * reach, z},
             {0.8 * reach, z + 0.012},
             {0.5 * reach, z + 0.012},
             {0.5 * reach, z}},
            12);
  make.join(4, "rings");
}

} // namespace pcl::indoor
