/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/draped_cloth.h"

#include "furniture/part_maker.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::indoor {

namespace {

constexpr double cell = 0.045;     // metres, finer than arms and rails are thick
constexpr int finest = 28;         // cells along a side at most: bounds the triangles
constexpr double steepness = 5.0;  // metres of fall per metre where it hangs down
constexpr double shortest = 0.015; // metres above its lowest point that it must reach

// Heights over the corners of a grid of cells.
class Field {
public:
  explicit Field(const Eigen::Vector3d& size)
  : columns_(std::clamp(static_cast<int>(size.x() / cell), 4, finest))
  , rows_(std::clamp(static_cast<int>(size.y() / cell), 4, finest))
  , size_(size)
  , heights_(static_cast<std::size_t>((columns_ + 1) * (rows_ + 1)), 0.0)
  {}

  int
  columns() const
  {
    return columns_;
  }

  int
  rows() const
  {
    return rows_;
  }

  double&
  at(int i, int k)
  {
    return heights_[static_cast<std::size_t>(k * (columns_ + 1) + i)];
  }

  Eigen::Vector2d
  place(double i, double k) const
  {
    return {size_.x() * (i / columns_ - 0.5), size_.y() * (k / rows_ - 0.5)};
  }

private:
  int columns_, rows_;
  Eigen::Vector3d size_;
  std::vector<double> heights_;
};

// The highest support within half a cell of each corner.
void
touchDown(Field& field, const std::vector<Triangle>& supports, double top)
{
  const RayTracer tracer(supports);
  for (int k = 0; k <= field.rows(); ++k)
    for (int i = 0; i <= field.columns(); ++i)
      for (const double di : {-0.33, 0.0, 0.33})
        for (const double dk : {-0.33, 0.0, 0.33}) {
          const Eigen::Vector2d p = field.place(i + di, k + dk);
          const Eigen::Vector3d from(p.x(), p.y(), top);
          const auto hit = tracer.trace(from.cast<float>(), {0, 0, -1});
          field.at(i, k) = std::max(field.at(i, k), top - hit.distance);
        }
}

// Cloth does not fall upright: beside what holds it, it goes down at a slope.
void
hang(Field& field)
{
  const double dx = (field.place(1, 0) - field.place(0, 0)).norm() * steepness,
               dy = (field.place(0, 1) - field.place(0, 0)).norm() * steepness;
  const int last_i = field.columns(), last_k = field.rows();
  for (int k = 0; k <= last_k; ++k)
    for (int i = 0; i <= last_i; ++i) {
      if (i > 0)
        field.at(i, k) = std::max(field.at(i, k), field.at(i - 1, k) - dx);
      if (k > 0)
        field.at(i, k) = std::max(field.at(i, k), field.at(i, k - 1) - dy);
    }
  for (int k = last_k; k >= 0; --k)
    for (int i = last_i; i >= 0; --i) {
      if (i < last_i)
        field.at(i, k) = std::max(field.at(i, k), field.at(i + 1, k) - dx);
      if (k < last_k)
        field.at(i, k) = std::max(field.at(i, k), field.at(i, k + 1) - dy);
    }
}

// Two numbers of a range, the second drawn first.
Eigen::Vector2d
drawnPair(RandomDraw& draw, double low, double high)
{
  const double y = draw.uniform(low, high);
  return {draw.uniform(low, high), y};
}

// The body between the cloth's two sides where it is held; its rim is closed.
class Body {
public:
  Body(Field& field, const Eigen::Vector3d& size, RandomDraw& draw)
  : field_(field)
  , top_(size.z())
  , thickness_(draw.uniform(0.006, 0.02))
  , fold_(draw.uniform(0.0, 0.02))
  , waves_(drawnPair(draw, 8, 20))
  , phases_(drawnPair(draw, 0, 6))
  {}

  std::vector<Triangle>
  triangles()
  {
    for (int k = 0; k < field_.rows(); ++k)
      for (int i = 0; i < field_.columns(); ++i) {
        if (!isHeld(i, k))
          continue;
        quad(corner(i, k, true),
             corner(i + 1, k, true),
             corner(i + 1, k + 1, true),
             corner(i, k + 1, true));
        quad(corner(i, k, false),
             corner(i, k + 1, false),
             corner(i + 1, k + 1, false),
             corner(i + 1, k, false));
        if (!isHeld(i, k - 1))
          rim(i, k, i + 1, k);
        if (!isHeld(i + 1, k))
          rim(i + 1, k, i + 1, k + 1);
        if (!isHeld(i, k + 1))
          rim(i + 1, k + 1, i, k + 1);
        if (!isHeld(i - 1, k))
          rim(i, k + 1, i, k);
      }
    return triangles_;
  }

private:
  bool
  isHeld(int i, int k)
  {
    if (i < 0 || k < 0 || i >= field_.columns() || k >= field_.rows())
      return false;
    return std::max({field_.at(i, k),
                     field_.at(i + 1, k),
                     field_.at(i, k + 1),
                     field_.at(i + 1, k + 1)}) > shortest;
  }

  Eigen::Vector3f
  corner(int i, int k, bool upper)
  {
    const Eigen::Vector2d p = field_.place(i, k);
    const double wave =
        fold_ * (1 + std::sin(waves_.x() * p.x() + 3 * p.y() + phases_.x()) *
                         std::sin(waves_.y() * p.y() - 2 * p.x() + phases_.y()));
    const double z =
        std::max(0.0, field_.at(i, k)) + wave + (upper ? thickness_ : 0.001);
    return Eigen::Vector3d(
               p.x(), p.y(), std::min(z, top_ - (upper ? 0.0 : 0.5 * thickness_)))
        .cast<float>();
  }

  void
  rim(int i, int k, int j, int l)
  {
    quad(corner(i, k, false),
         corner(j, l, false),
         corner(j, l, true),
         corner(i, k, true));
  }

  void
  quad(const Eigen::Vector3f& a,
       const Eigen::Vector3f& b,
       const Eigen::Vector3f& c,
       const Eigen::Vector3f& d)
  {
    triangles_.push_back({a, b, c});
    triangles_.push_back({a, c, d});
  }

  Field& field_;
  double top_, thickness_, fold_;
  Eigen::Vector2d waves_, phases_;
  std::vector<Triangle> triangles_;
};

} // namespace

FurnitureModel
drapeCloth(const std::vector<Triangle>& supports,
           const Eigen::Vector3d& size,
           std::uint32_t seed)
{
  RandomDraw draw(seed);
  Field field(size);
  touchDown(field, supports, size.z());
  hang(field);
  PartMaker make(size, false);
  const auto triangles = Body(field, size, draw).triangles();
  if (!triangles.empty())
    make.add("cloth", triangles);
  return make.take();
}

} // namespace pcl::indoor
