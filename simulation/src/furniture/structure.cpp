/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/part_maker.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

void
column(PartMaker& make, const Eigen::Vector3d& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  if (draw.pick(2) == 0)
    make.prism("shaft", {0, 0}, std::min(x, y), 0.0, std::min(x, y), size.z(), 20);
  else
    make.box("shaft", {-x, -y, x, y}, 0.0, size.z());
}

void
beam(PartMaker& make, const Eigen::Vector3d& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2;
  make.box("beam", {-x, -y, x, y}, 0.0, size.z());
}

// Climbs towards +y.
void
stairs(PartMaker& make, const Eigen::Vector3d& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2;
  const double flight = size.z() - 1.0; // the handrail ends a metre above the last step
  const int steps = partsIn(flight, 0.175);
  const double rise = flight / steps, run = size.y() / steps;
  for (int i = 0; i < steps; ++i) {
    const double under = std::max(0.0, (i - 1) * rise); // open below, like a slab
    make.box("step",
             {-x + 0.05, -y + i * run, x - 0.05, -y + (i + 1) * run},
             under,
             (i + 1) * rise);
  }
  for (const double side : {-x, x - 0.04})
    for (int i = 0; i < steps; i += 4) {
      const double y0 = -y + (i + 0.5) * run;
      make.box(
          "post", {side, y0 - 0.02, side + 0.04, y0 + 0.02}, i * rise, i * rise + 1.0);
    }
  for (const double side : {-x, x - 0.04}) {
    for (int i = 0; i < steps; ++i) // a rail of short pieces follows the steps
      make.box("rail",
               {side, -y + i * run, side + 0.04, -y + (i + 1) * run},
               i * rise + 0.94,
               (i + 1) * rise + 1.0);
    make.join(steps, "rail");
  }
}

// Steps around a pole, to the left; they begin and end at the front.
void
spiralStairs(PartMaker& make, const Eigen::Vector3d& size, RandomDraw&)
{
  constexpr double core = 0.07, thickness = 0.05; // metres
  const double x = size.x() / 2, y = size.y() / 2, flight = size.z() - 1.0;
  const int steps = partsIn(flight, 0.19, 6);
  const double rise = flight / steps, turn = 1.9 * M_PI / steps;
  make.prism("pole", {0, 0}, core, 0.0, core, size.z(), 12);
  const auto at = [&](double i, double share) {
    const double angle = M_PI / 2 + i * turn;
    return Eigen::Vector2d(share * x * std::cos(angle), share * y * std::sin(angle));
  };
  for (int i = 0; i < steps; ++i) {
    const double top = (i + 1) * rise;
    make.slab("step",
              {at(i, core / x), at(i, 0.97), at(i + 0.5, 0.97), at(i + 1.0, 0.97)},
              std::max(0.0, top - thickness),
              top);
    const Eigen::Vector2d p = at(i, 0.97), q = at(i + 1.0, 0.97);
    make.rod("post", {p.x(), p.y(), top}, {p.x(), p.y(), top + 0.95 - rise}, 0.012);
    make.rod(
        "rail", {p.x(), p.y(), top + 0.95 - rise}, {q.x(), q.y(), top + 0.95}, 0.02);
  }
}

void
railing(PartMaker& make, const Eigen::Vector3d& size, RandomDraw&)
{
  const double x = size.x() / 2, y = size.y() / 2;
  const int posts = partsIn(size.x(), 1.0) + 1;
  make.box("rail", {-x, -y, x, y}, size.z() - 0.05, size.z());
  for (int i = 0; i < posts; ++i) {
    const double left = -x + i * (2 * x - 0.04) / (posts - 1);
    make.box("post", {left, -0.5 * y, left + 0.04, 0.5 * y}, 0.0, size.z() - 0.05);
  }
  for (int bar = 1; bar < 6; ++bar) {
    const double z = bar * (size.z() - 0.05) / 6;
    make.box("bar", {-x, -0.25 * y, x, 0.25 * y}, z, z + 0.02);
  }
}

} // namespace

std::vector<FurnitureClass>
structureClasses()
{
  return {{"column", {0.35, 0.35, 2.8}, {0.45, 0.45, 2.8}, column},
          {"beam", {3.0, 0.25, 0.25}, {5.0, 0.35, 0.35}, beam},
          {"stairs", {1.2, 4.8, 4.1}, {1.2, 4.8, 4.1}, stairs},
          {"stairs", {1.5, 1.5, 3.8}, {1.8, 1.8, 4.2}, spiralStairs},
          {"railing", {3.0, 0.06, 1.0}, {4.0, 0.06, 1.1}, railing}};
}

FurnitureModel
makeDoor(double width, double height, double depth, double leaf_angle, bool hinge_left)
{
  constexpr double frame = 0.04, thickness = 0.04;
  const double x = width / 2, y = depth / 2;
  PartMaker make({width, depth, height});
  for (const double side : {-1.0, 1.0}) // both halves of the wall, one part
    for (int half = 0; half < 2; ++half) {
      const double inner = std::min(side * x, side * (x - frame));
      make.box("jamb",
               {inner, half == 0 ? -y : 0.0, inner + frame, half == 0 ? 0.0 : y},
               0.0,
               height);
    }
  make.box("head", {-x + frame, -y, x - frame, 0}, height - frame, height);
  make.box("head", {-x + frame, 0, x - frame, y}, height - frame, height);
  make.join(6, "frame");
  const double leaf = width - 2 * frame;
  const double y0 = leaf_angle > 0 ? y - thickness : -thickness / 2;
  make.box("leaf", {0, y0, leaf, y0 + thickness}, 0.01, height - frame - 0.003);
  for (const double side : {y0 - 0.05, y0 + thickness})
    make.box("handle", {leaf - 0.17, side, leaf - 0.05, side + 0.05}, 1.02, 1.05);
  FurnitureModel model = make.take();
  // Built with the hinge at the origin: turn about it, mirror for a hinge at +x, move.
  const Eigen::Vector3f pivot(0, static_cast<float>(y0 + thickness), 0);
  const float c = static_cast<float>(std::cos(leaf_angle));
  const float s = static_cast<float>(std::sin(leaf_angle));
  const auto place = [&](const Eigen::Vector3f& p) {
    const Eigen::Vector3f q = p - pivot;
    const float along = c * q.x() - s * q.y(), across = s * q.x() + c * q.y();
    const float hinge = static_cast<float>(-x + frame) + along;
    return Eigen::Vector3f(hinge_left ? -hinge : hinge, pivot.y() + across, q.z());
  };
  for (std::size_t i = 1; i < model.parts.size(); ++i)
    for (auto& t : model.parts[i].triangles) {
      t = {place(t.a), place(t.b), place(t.c)};
      if (hinge_left) // a mirror turns the normals around
        std::swap(t.b, t.c);
    }
  return model;
}

FurnitureModel
makeWindow(
    double width, double height, double depth, double frame_width, double frame_depth)
{
  const double frame = frame_width;
  const double x = width / 2, y = std::min(depth / 2, frame_depth / 2);
  PartMaker make({width, depth, height});
  int pieces = 0;
  const auto bar = [&](const Rectangle& r, double z0, double z1) {
    make.box("frame", {r.x0, -y, r.x1, 0.0}, z0, z1); // halves: one for each room
    make.box("frame", {r.x0, 0.0, r.x1, y}, z0, z1);
    pieces += 2;
  };
  bar({-x, 0, x, 0}, 0.0, frame);
  bar({-x, 0, x, 0}, height - frame, height);
  const int panes = partsIn(width, 1.0);
  for (int i = 0; i <= panes; ++i) {
    const double left = -x + i * (width - frame) / panes;
    bar({left, 0, left + frame, 0}, frame, height - frame);
  }
  make.join(pieces, "frame");
  FurnitureModel model = make.take();
  FurniturePart pane{"glass", {}, true};
  for (const float side : {1.0f, -1.0f}) { // double glazing: a pane for each room
    const auto at = [&](double px, double pz) {
      constexpr float half_gap = 0.004f;
      return Eigen::Vector3f(
          static_cast<float>(side * px), side * half_gap, static_cast<float>(pz));
    };
    pane.triangles.push_back({at(x, 0), at(-x, 0), at(-x, height)});
    pane.triangles.push_back({at(x, 0), at(-x, height), at(x, height)});
  }
  model.parts.push_back(pane);
  return model;
}

} // namespace pcl::indoor
