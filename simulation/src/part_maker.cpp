/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "part_maker.h"

#include <cmath>

namespace pcl {
namespace indoor {

namespace {

void
quad(std::vector<Triangle>& triangles,
     const Eigen::Vector3d& a,
     const Eigen::Vector3d& b,
     const Eigen::Vector3d& c,
     const Eigen::Vector3d& d)
{
  triangles.push_back({a.cast<float>(), b.cast<float>(), c.cast<float>()});
  triangles.push_back({a.cast<float>(), c.cast<float>(), d.cast<float>()});
}

} // namespace

void
PartMaker::frustum(const std::string& name,
                   const Rectangle& bottom,
                   double z0,
                   const Rectangle& top,
                   double z1)
{
  const Eigen::Vector3d corners[8] = {{bottom.x0, bottom.y0, z0},
                                      {bottom.x1, bottom.y0, z0},
                                      {bottom.x1, bottom.y1, z0},
                                      {bottom.x0, bottom.y1, z0},
                                      {top.x0, top.y0, z1},
                                      {top.x1, top.y0, z1},
                                      {top.x1, top.y1, z1},
                                      {top.x0, top.y1, z1}};
  FurniturePart part;
  part.name = name;
  const auto side = [&](int a, int b, int c, int d) {
    quad(part.triangles, corners[a], corners[b], corners[c], corners[d]);
  };
  side(3, 2, 1, 0);
  side(4, 5, 6, 7);
  for (int i = 0; i < 4; ++i)
    side(i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i);
  model_.parts.push_back(part);
}

void
PartMaker::prism(const std::string& name,
                 const Eigen::Vector2d& center,
                 double bottom_radius,
                 double z0,
                 double top_radius,
                 double z1,
                 int sides)
{
  FurniturePart part;
  part.name = name;
  const Eigen::Vector3d foot(center.x(), center.y(), z0),
      head(center.x(), center.y(), z1);
  const auto rim = [&](int i, double radius, double z) {
    const double angle = 2 * M_PI * (i % sides) / sides;
    return Eigen::Vector3d(center.x() + radius * std::cos(angle),
                           center.y() + radius * std::sin(angle),
                           z);
  };
  for (int i = 0; i < sides; ++i) {
    const auto a = rim(i, bottom_radius, z0), b = rim(i + 1, bottom_radius, z0);
    const auto c = rim(i + 1, top_radius, z1), d = rim(i, top_radius, z1);
    quad(part.triangles, a, b, c, d);
    part.triangles.push_back({b.cast<float>(), a.cast<float>(), foot.cast<float>()});
    part.triangles.push_back({d.cast<float>(), c.cast<float>(), head.cast<float>()});
  }
  model_.parts.push_back(part);
}

void
PartMaker::join(int count, const std::string& name)
{
  FurniturePart joined;
  joined.name = name;
  const auto first = model_.parts.end() - count;
  for (auto part = first; part != model_.parts.end(); ++part)
    joined.triangles.insert(
        joined.triangles.end(), part->triangles.begin(), part->triangles.end());
  model_.parts.erase(first, model_.parts.end());
  model_.parts.push_back(joined);
}

} // namespace indoor
} // namespace pcl
