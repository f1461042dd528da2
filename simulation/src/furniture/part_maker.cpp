/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/part_maker.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

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

Eigen::Vector3d
PartMaker::cutBack(const Eigen::Vector3d& p) const
{
  if (!cuts_)
    return p;
  const Eigen::Vector3d half(model_.size.x() / 2, model_.size.y() / 2, 0.0);
  const Eigen::Vector3d top(half.x(), half.y(), model_.size.z());
  return p.cwiseMax(-half).cwiseMin(top);
}

void
PartMaker::loft(const std::string& name,
                const Rectangle& extent,
                const std::vector<Section>& sections,
                int sides)
{
  const Eigen::Vector3d middle(
      (extent.x0 + extent.x1) / 2, (extent.y0 + extent.y1) / 2, 0);
  const double x = (extent.x1 - extent.x0) / 2, y = (extent.y1 - extent.y0) / 2;
  const auto at = [&](const Section& section, int i) -> Eigen::Vector3f {
    const double angle = 2 * M_PI * (i % sides + 0.5) / sides;
    const double c = std::cos(angle), s = std::sin(angle);
    const Eigen::Vector3d p(
        section.scale * x * std::copysign(std::pow(std::abs(c), section.corner), c),
        section.scale * y * std::copysign(std::pow(std::abs(s), section.corner), s),
        section.z);
    return cutBack(middle + p).cast<float>();
  };
  FurniturePart part;
  part.name = name;
  const auto add = [&](const Eigen::Vector3f& a,
                       const Eigen::Vector3f& b,
                       const Eigen::Vector3f& c) {
    if (a != b && b != c && c != a)
      part.triangles.push_back({a, b, c});
  };
  const Section first{0.0, sections.front().z}, last{0.0, sections.back().z};
  for (int i = 0; i < sides; ++i) {
    add(at(sections.front(), i + 1), at(sections.front(), i), at(first, i));
    add(at(sections.back(), i), at(sections.back(), i + 1), at(last, i));
    for (std::size_t k = 0; k + 1 < sections.size(); ++k) {
      const auto a = at(sections[k], i), b = at(sections[k], i + 1);
      const auto c = at(sections[k + 1], i + 1), d = at(sections[k + 1], i);
      add(a, b, c);
      add(a, c, d);
    }
  }
  model_.parts.push_back(part);
}

void
PartMaker::slab(const std::string& name, const Polygon& outline, double z0, double z1)
{
  FurniturePart part;
  part.name = name;
  const auto at = [&](std::size_t i, double z) -> Eigen::Vector3f {
    const auto& p = outline[i % outline.size()];
    return cutBack({p.x(), p.y(), z}).cast<float>();
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    part.triangles.push_back({at(i, z0), at(i + 1, z0), at(i + 1, z1)});
    part.triangles.push_back({at(i, z0), at(i + 1, z1), at(i, z1)});
    if (i == 0 || i + 1 == outline.size())
      continue;
    part.triangles.push_back({at(0, z1), at(i, z1), at(i + 1, z1)});
    part.triangles.push_back({at(0, z0), at(i + 1, z0), at(i, z0)});
  }
  model_.parts.push_back(part);
}

void
PartMaker::rod(const std::string& name,
               const Eigen::Vector3d& from,
               const Eigen::Vector3d& to,
               double radius,
               int sides)
{
  const Eigen::Vector3d axis = (to - from).normalized();
  const Eigen::Vector3d u = axis.unitOrthogonal() * radius, v = axis.cross(u);
  const auto rim = [&](const Eigen::Vector3d& end, int i) {
    const double angle = 2 * M_PI * (i % sides) / sides;
    return cutBack(end + std::cos(angle) * u + std::sin(angle) * v);
  };
  FurniturePart part;
  part.name = name;
  for (int i = 0; i < sides; ++i) {
    const auto a = rim(from, i), b = rim(from, i + 1), c = rim(to, i + 1),
               d = rim(to, i);
    quad(part.triangles, a, b, c, d);
    part.triangles.push_back(
        {b.cast<float>(), a.cast<float>(), cutBack(from).cast<float>()});
    part.triangles.push_back(
        {d.cast<float>(), c.cast<float>(), cutBack(to).cast<float>()});
  }
  model_.parts.push_back(part);
}

void
fronts(PartMaker& make,
       const Eigen::Vector3d& size,
       int doors,
       double z0,
       double z1,
       bool handles)
{
  const double x = size.x() / 2, y = size.y() / 2, width = size.x() / doors;
  for (int i = 0; i < doors; ++i) {
    const double left = -x + i * width;
    make.box("door", {left + 0.004, y - 0.04, left + width - 0.004, y - 0.02}, z0, z1);
    if (!handles)
      continue;
    const double at = i % 2 == 0 ? left + width - 0.05 : left + 0.05;
    const double middle = z1 - z0 > 1.2 ? 0.5 * (z0 + z1) : z1 - 0.12;
    make.rod("handle",
             {at, y - 0.012, middle - 0.06},
             {at, y - 0.012, middle + 0.06},
             0.008);
  }
}

int
partsIn(double length, double each, int least)
{
  return std::max(least, static_cast<int>(std::lround(length / each)));
}

void
cornerPosts(PartMaker& make,
            const std::string& name,
            const Rectangle& places,
            double thickness,
            double height)
{
  for (const double x : {places.x0, places.x1})
    for (const double y : {places.y0, places.y1})
      make.box(name, {x, y, x + thickness, y + thickness}, 0, height);
}

std::vector<Section>
ballSections(double height)
{
  return {{0, 0},
          {0.6, 0.1 * height},
          {0.92, 0.3 * height},
          {1, 0.5 * height},
          {0.92, 0.7 * height},
          {0.6, 0.9 * height},
          {0, height}};
}

void
roundLegs(PartMaker& make, double x, double y, double radius, double z, double splay)
{
  for (const double sx : {-1.0, 1.0})
    for (const double sy : {-1.0, 1.0})
      make.rod("leg",
               {sx * (x - radius), sy * (y - radius), 0.0},
               {sx * (x - radius - splay), sy * (y - radius - splay), z},
               radius);
}

void
PartMaker::hollow(const std::string& name,
                  const Rectangle& r,
                  const std::vector<Section>& sections,
                  double thickness)
{
  const double half = std::min(r.x1 - r.x0, r.y1 - r.y0) / 2;
  std::vector<Section> both = sections;
  for (auto section = sections.rbegin(); section != sections.rend(); ++section) {
    both.push_back(*section);
    both.back().scale -= thickness / half;
  }
  both.back().z += thickness;
  loft(name, r, both, 24);
  const double rim = sections.back().z - thickness;
  const Eigen::Vector2d middle((r.x0 + r.x1) / 2, (r.y0 + r.y1) / 2);
  std::vector<Triangle> triangles;
  triangles.swap(model_.parts.back().triangles);
  FurniturePart inside{"inside", {}, false}, floor{"bottom", {}, false};
  for (const auto& t : triangles) {
    const Eigen::Vector3d normal = (t.b - t.a).cross(t.c - t.a).cast<double>(),
                          place = (t.a + t.b + t.c).cast<double>() / 3;
    const bool is_level = std::abs(normal.z()) > 0.99 * normal.norm(),
               is_inwards = normal.head<2>().dot(place.head<2>() - middle) < 0;
    if (is_level && normal.z() > 0 && place.z() < rim)
      floor.triangles.push_back(t);
    else if (!is_level && is_inwards)
      inside.triangles.push_back(t);
    else
      model_.parts.back().triangles.push_back(t);
  }
  model_.parts.push_back(inside);
  model_.parts.push_back(floor);
}

void
PartMaker::add(const std::string& name, std::vector<Triangle> triangles)
{
  const auto touches = [](const Triangle& t) {
    return t.a == t.b || t.b == t.c || t.c == t.a;
  };
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), touches),
                  triangles.end());
  double volume = 0;
  const Eigen::Vector3d origin =
      triangles.empty() ? Eigen::Vector3d(0, 0, 0) : triangles[0].a.cast<double>();
  for (const auto& t : triangles)
    volume +=
        (t.a.cast<double>() - origin)
            .dot((t.b.cast<double>() - origin).cross(t.c.cast<double>() - origin));
  if (volume < 0)
    for (auto& t : triangles)
      std::swap(t.b, t.c);
  model_.parts.push_back({name, std::move(triangles), false});
}

void
PartMaker::fit()
{
  Eigen::AlignedBox3d box;
  for (const auto& part : model_.parts)
    for (const auto& t : part.triangles)
      box.extend(t.a.cast<double>())
          .extend(t.b.cast<double>())
          .extend(t.c.cast<double>());
  const Eigen::Vector3d scale = model_.size.cwiseQuotient(box.sizes()),
                        middle(box.center().x(), box.center().y(), box.min().z());
  const auto moved = [&](const Eigen::Vector3f& p) -> Eigen::Vector3f {
    return (p.cast<double>() - middle).cwiseProduct(scale).cast<float>();
  };
  for (auto& part : model_.parts)
    for (auto& t : part.triangles)
      t = {moved(t.a), moved(t.b), moved(t.c)};
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

} // namespace pcl::indoor
