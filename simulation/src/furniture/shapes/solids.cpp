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

void
triangle(std::vector<Triangle>& triangles,
         const Eigen::Vector3d& a,
         const Eigen::Vector3d& b,
         const Eigen::Vector3d& c)
{
  triangles.push_back({a.cast<float>(), b.cast<float>(), c.cast<float>()});
}

void
quad(std::vector<Triangle>& triangles,
     const Eigen::Vector3d& a,
     const Eigen::Vector3d& b,
     const Eigen::Vector3d& c,
     const Eigen::Vector3d& d)
{
  triangle(triangles, a, b, c);
  triangle(triangles, a, c, d);
}

// A grid of places over u and v from -1 to 1.
class Grid {
public:
  Grid(const SheetShape& shape, int columns, int rows)
  : columns_(columns)
  , rows_(rows)
  {
    for (int k = 0; k <= rows; ++k)
      for (int i = 0; i <= columns; ++i)
        places_.push_back(shape(2.0 * i / columns - 1, 2.0 * k / rows - 1));
  }

  const Eigen::Vector3d&
  at(int i, int k) const
  {
    return places_[static_cast<std::size_t>(std::clamp(k, 0, rows_) * (columns_ + 1) +
                                            std::clamp(i, 0, columns_))];
  }

  Eigen::Vector3d
  normal(int i, int k) const
  {
    const Eigen::Vector3d across = at(i + 1, k) - at(i - 1, k),
                          along = at(i, k + 1) - at(i, k - 1), n = across.cross(along);
    return n.norm() > 0 ? Eigen::Vector3d(n.normalized()) : Eigen::Vector3d::UnitZ();
  }

private:
  int columns_, rows_;
  std::vector<Eigen::Vector3d> places_;
};

// The body between two surfaces over the same grid.
template <class Upper, class Lower>
std::vector<Triangle>
between(int columns, int rows, const Upper& upper, const Lower& lower)
{
  std::vector<Triangle> triangles;
  for (int k = 0; k < rows; ++k)
    for (int i = 0; i < columns; ++i) {
      quad(triangles,
           upper(i, k),
           upper(i + 1, k),
           upper(i + 1, k + 1),
           upper(i, k + 1));
      quad(triangles,
           lower(i, k),
           lower(i, k + 1),
           lower(i + 1, k + 1),
           lower(i + 1, k));
    }
  const auto rim = [&](int i, int k, int j, int l) {
    quad(triangles, lower(i, k), lower(j, l), upper(j, l), upper(i, k));
  };
  for (int i = 0; i < columns; ++i) {
    rim(i, 0, i + 1, 0);
    rim(i + 1, rows, i, rows);
  }
  for (int k = 0; k < rows; ++k) {
    rim(columns, k, columns, k + 1);
    rim(0, k + 1, 0, k);
  }
  return triangles;
}

double
puffed(double u)
{
  return std::sqrt(std::max(0.0, 1 - u * u * u * u));
}

} // namespace

Path
arc(const Eigen::Vector3d& middle,
    const Eigen::Vector3d& first_axis,
    const Eigen::Vector3d& second_axis,
    double from,
    double to,
    int pieces)
{
  Path path;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = from + (to - from) * i / pieces;
    path.push_back(middle + std::cos(angle) * first_axis +
                   std::sin(angle) * second_axis);
  }
  return path;
}

void
skin(PartMaker& make, const std::string& name, const std::vector<Path>& rings)
{
  std::vector<Triangle> triangles;
  const auto count = rings.front().size();
  const auto cap = [&](const Path& ring, bool upper) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& p : ring)
      middle += p / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
      const auto &p = ring[i], &q = ring[(i + 1) % count];
      triangle(triangles, upper ? p : q, upper ? q : p, middle);
    }
  };
  cap(rings.front(), false);
  cap(rings.back(), true);
  for (std::size_t r = 0; r + 1 < rings.size(); ++r)
    for (std::size_t i = 0; i < count; ++i) {
      const auto next = (i + 1) % count;
      quad(triangles, rings[r][i], rings[r][next], rings[r + 1][next], rings[r + 1][i]);
    }
  make.add(name, triangles);
}

void
tube(PartMaker& make,
     const std::string& name,
     const Path& path,
     double radius,
     int sides)
{
  std::vector<Path> rings;
  Eigen::Vector3d u = (path[1] - path[0]).unitOrthogonal();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Eigen::Vector3d before = path[i] - path[i > 0 ? i - 1 : i],
                          after = path[std::min(i + 1, path.size() - 1)] - path[i];
    const Eigen::Vector3d way = (before.normalized() + after.normalized()).normalized();
    u = (u - u.dot(way) * way).normalized(); // turned as little as possible
    const Eigen::Vector3d v = way.cross(u);
    rings.push_back(arc(path[i],
                        radius * u,
                        radius * v,
                        M_PI / sides,
                        (2 + 1.0 / sides) * M_PI,
                        sides));
    rings.back().pop_back();
  }
  skin(make, name, rings);
}

void
sheet(PartMaker& make,
      const std::string& name,
      const SheetGrid& grid,
      const SheetShape& shape)
{
  const Grid places(shape, grid.columns, grid.rows);
  const auto side = [&](double offset) {
    return [&places, offset](int i, int k) -> Eigen::Vector3d {
      return places.at(i, k) + offset * places.normal(i, k);
    };
  };
  make.add(name,
           between(grid.columns,
                   grid.rows,
                   side(grid.thickness / 2),
                   side(-grid.thickness / 2)));
}

void
pillow(PartMaker& make, const std::string& name, const Patch& patch, double thickness)
{
  constexpr int pieces = 8;
  const Eigen::Vector3d normal =
      patch.right.cross(patch.up).normalized() * thickness / 2;
  const auto side = [&](double way) {
    return [&patch, normal, way](int i, int k) -> Eigen::Vector3d {
      const double u = 2.0 * i / pieces - 1, v = 2.0 * k / pieces - 1;
      const double in = 0.06; // corners stand out: seams between them are drawn in
      return patch.middle + u * (1 - in * (1 - v * v)) * patch.right +
             v * (1 - in * (1 - u * u)) * patch.up +
             way * puffed(u) * puffed(v) * normal;
    };
  };
  make.add(name, between(pieces, pieces, side(1), side(-1)));
}

void
roundBox(PartMaker& make,
         const std::string& name,
         const Rectangle& base,
         double z0,
         double z1,
         double radius)
{
  constexpr int pieces = 3; // per rounded edge
  const double width = base.x1 - base.x0, depth = base.y1 - base.y0;
  const double r = std::min({radius, 0.499 * width, 0.499 * depth, 0.499 * (z1 - z0)});
  const auto outline = [&](double in, double z) {
    Path ring;
    const double corner = r - in;
    for (int k = 0; k < 4; ++k) {
      const double x = k == 0 || k == 3 ? base.x1 - r : base.x0 + r,
                   y = k < 2 ? base.y1 - r : base.y0 + r;
      const auto bend = arc({x, y, z},
                            {corner, 0, 0},
                            {0, corner, 0},
                            k * M_PI / 2,
                            (k + 1) * M_PI / 2,
                            pieces);
      ring.insert(ring.end(), bend.begin(), bend.end());
    }
    return ring;
  };
  std::vector<Path> rings;
  for (const bool upper : {false, true})
    for (int i = 0; i <= pieces; ++i) {
      const double angle = M_PI / 2 * (upper ? i : pieces - i) / pieces * 0.98;
      const double in = r * (1 - std::cos(angle)), off = r * (1 - std::sin(angle));
      rings.push_back(outline(in, upper ? z1 - off : z0 + off));
    }
  skin(make, name, rings);
}

void
ellipsoid(PartMaker& make,
          const std::string& name,
          const Eigen::Vector3d& middle,
          const Eigen::Vector3d& half)
{
  constexpr int pieces = 7, sides = 12;
  std::vector<Path> rings;
  for (int i = 0; i < pieces; ++i) {
    const double angle = M_PI * ((i + 0.3) / (pieces - 0.4) - 0.5);
    const double c = std::cos(angle);
    rings.push_back(
        arc({middle.x(), middle.y(), middle.z() + half.z() * std::sin(angle)},
            {c * half.x(), 0, 0},
            {0, c * half.y(), 0},
            0,
            2 * M_PI,
            sides));
    rings.back().pop_back();
  }
  skin(make, name, rings);
}

void
lathe(PartMaker& make,
      const std::string& name,
      const Eigen::Vector2d& middle,
      const std::vector<Turn>& profile,
      int sides)
{
  std::vector<Path> rings;
  for (const auto& turn : profile) {
    const double r = std::max(turn.radius, 1e-4);
    rings.push_back(arc(
        {middle.x(), middle.y(), turn.z}, {r, 0, 0}, {0, r, 0}, 0, 2 * M_PI, sides));
    rings.back().pop_back();
  }
  skin(make, name, rings);
}

void
block(PartMaker& make, const std::string& name, const Corners& box)
{
  const auto &low = box.low, &high = box.high;
  make.box(name, {low.x(), low.y(), high.x(), high.y()}, low.z(), high.z());
}

void
row(PartMaker& make,
    const std::string& name,
    const Corners& first,
    const Eigen::Vector3d& step,
    int count)
{
  for (int i = 0; i < count; ++i)
    block(make, name, {first.low + i * step, first.high + i * step});
}

void
blades(PartMaker& make,
       const std::string& name,
       const Eigen::Vector3d& root,
       const Eigen::Vector3d& reach,
       int count,
       double width,
       RandomDraw& draw)
{
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * (i + draw.uniform()) / count,
                 far = draw.uniform(0.6, 1.0), high = draw.uniform(0.5, 1.0),
                 droop = draw.uniform(0.0, 0.8);
    const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0),
        side(-out.y(), out.x(), 0);
    const auto blade = [&](double u, double v) -> Eigen::Vector3d {
      const double t = (v + 1) / 2,
                   w = width * (0.15 + std::sin(M_PI * (0.1 + 0.8 * t)));
      const double rise = high * reach.z() * (t - droop * t * t) / (1 - 0.5 * droop);
      return root +
             far * t * out.cwiseProduct(Eigen::Vector3d(reach.x(), reach.y(), 0)) +
             Eigen::Vector3d(0, 0, rise) + u * w / 2 * side +
             Eigen::Vector3d(0, 0, 0.2 * w * std::abs(u));
    };
    sheet(make, name, {2, 4, 0.004}, blade);
  }
  make.join(count, name);
}

FurnitureClass
fitted(const char* name,
       const Size& smallest,
       const Size& largest,
       const FurnitureRecipe& build,
       int like)
{
  return {name, smallest, largest, build, true, like};
}

} // namespace pcl::indoor
