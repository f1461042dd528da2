/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/wall_lean.h"

#include "rooms/dimensions.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {
namespace {

/** The least squares of what stretches say about the shift of their surroundings. */
struct ShiftEquations {
  // The shift is 0 with a deviation of 1 (45 degrees) to begin with, and voxels scatter
  // by one: far from walls nothing is known to lean.
  float xx = 1.0f, xy = 0.0f, yy = 1.0f, x = 0.0f, y = 0.0f;

  void
  add(const WallStretch& wall, double weight)
  {
    const Eigen::Vector2d& n = wall.normal;
    xx += static_cast<float>(weight * n.x() * n.x());
    xy += static_cast<float>(weight * n.x() * n.y());
    yy += static_cast<float>(weight * n.y() * n.y());
    x += static_cast<float>(weight * n.x() * wall.lean);
    y += static_cast<float>(weight * n.y() * wall.lean);
  }

  Eigen::Vector2d
  solution() const // the matrix is the identity and more
  {
    const double determinant = double(xx) * yy - double(xy) * xy;
    return {(double(yy) * x - double(xy) * y) / determinant,
            (double(xx) * y - double(xy) * x) / determinant};
  }
};

/** How much a stretch counts so far from it; sigma and places in pixels. */
double
nearness(double squared_distance, double sigma)
{
  return std::exp(-0.5 * squared_distance / (sigma * sigma));
}

/** Stretches by square tiles of the map. */
class StretchTiles {
public:
  StretchTiles(const std::vector<WallStretch>& walls, int nx, int ny, double side)
  : side_(side)
  , tiles_{tileOf(nx) + 1, tileOf(ny) + 1, {}}
  {
    tiles_.values.resize(tiles_.size());
    for (std::size_t i = 0; i < walls.size(); ++i)
      tiles_.at(tileOf(walls[i].place.x()), tileOf(walls[i].place.y())).push_back(i);
  }

  /** Call with each stretch in the tile of a place and the eight around it. */
  template <typename Visit>
  void
  visit(const Eigen::Vector2d& place, Visit&& call) const
  {
    const int x = tileOf(place.x()), y = tileOf(place.y());
    for (int u = std::max(0, x - 1); u <= std::min(tiles_.nx - 1, x + 1); ++u)
      for (int v = std::max(0, y - 1); v <= std::min(tiles_.ny - 1, y + 1); ++v)
        for (const std::size_t i : tiles_.at(u, v))
          call(i);
  }

private:
  int
  tileOf(double at) const
  {
    return static_cast<int>(at / side_);
  }

  double side_;
  PixelMap<std::vector<std::size_t>> tiles_;
};

/** How far each stretch agrees with those around it, 0 ... 1: least squares with
 * weights that fall with the residual (Cauchy), so that what most of them say counts.
 * \return nothing if all shifts are too small to matter */
std::vector<double>
agreement(const std::vector<WallStretch>& walls, int nx, int ny, double sigma)
{
  const StretchTiles tiles(walls, nx, ny, 3.0 * sigma);
  std::vector<double> agrees(walls.size(), 1.0), next = agrees;
  double greatest = 0.0;
  for (int turn = 0; turn < 5; ++turn) {
    greatest = 0.0;
    for (std::size_t i = 0; i < walls.size(); ++i) {
      ShiftEquations sums;
      tiles.visit(walls[i].place, [&](std::size_t k) {
        const double squared = (walls[i].place - walls[k].place).squaredNorm();
        sums.add(walls[k], agrees[k] * walls[k].weight * nearness(squared, sigma));
      });
      const Eigen::Vector2d shift = sums.solution();
      const double residual = (walls[i].lean - walls[i].normal.dot(shift)) / least_lean;
      next[i] = 1.0 / (1.0 + residual * residual);
      greatest = std::max(greatest, shift.norm());
    }
    agrees = next;
  }
  return greatest < least_lean ? std::vector<double>{} : agrees;
}

} // namespace

PixelMap<Eigen::Vector2f>
leanMap(const std::vector<WallStretch>& walls, int nx, int ny, double pixel_size)
{
  PixelMap<Eigen::Vector2f> lean{nx, ny, {}};
  const double sigma = 0.5 * surroundings / pixel_size;
  if (std::all_of(
          walls.begin(), walls.end(), [](const auto& wall) { return wall.lean == 0; }))
    return lean;
  const auto agrees = agreement(walls, nx, ny, sigma);
  if (agrees.empty())
    return lean;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  std::vector<double> kernel; // by whole pixels
  for (int x = -radius; x <= radius; ++x)
    for (int y = -radius; y <= radius; ++y)
      kernel.push_back(nearness(x * x + y * y, sigma));
  std::vector<ShiftEquations> equations(lean.size());
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const int x0 = static_cast<int>(walls[i].place.x()) - radius;
    const int y0 = static_cast<int>(walls[i].place.y()) - radius;
    const int side = 2 * radius + 1;
    const double weight = agrees[i] * walls[i].weight;
    for (int x = std::max(0, x0); x < std::min(nx, x0 + side); ++x)
      for (int y = std::max(0, y0); y < std::min(ny, y0 + side); ++y)
        equations[lean.index(x, y)].add(walls[i],
                                        weight * kernel[(x - x0) * side + y - y0]);
  }
  lean.values.reserve(lean.size());
  for (const auto& sums : equations) {
    const Eigen::Vector2d shift = sums.solution();
    const bool leans = shift.norm() >= least_lean;
    lean.values.push_back(leans ? Eigen::Vector2f(shift.cast<float>())
                                : Eigen::Vector2f(0.0f, 0.0f));
  }
  return lean;
}

PixelMap<float>
slabHeights(const RoomMap& map)
{
  PixelMap<float> heights{map.ceiling.nx, map.ceiling.ny, {}};
  heights.values.reserve(heights.size());
  for (const int layer : map.ceiling.values)
    heights.values.push_back(
        static_cast<float>((layer < 0 ? map.range.end - 1 : layer) + 0.5 -
                           0.5 * (map.slab.first + map.slab.last)));
  return heights;
}

Eigen::Vector2d
straightened(const PixelMap<Eigen::Vector2f>& lean,
             const PixelMap<float>& slab,
             const Eigen::Vector3d& place)
{
  Eigen::Vector2d upright = place.head<2>();
  for (int turn = 0; turn < 3; ++turn) { // the lean is that of the place above
    const int x = static_cast<int>(std::floor(upright.x()));
    const int y = static_cast<int>(std::floor(upright.y()));
    if (!lean.contains(x, y))
      return upright;
    const Eigen::Vector2d shift = lean.at(x, y).cast<double>();
    if (shift.isZero(0.0) && turn == 0)
      return upright;
    upright = place.head<2>() - (slab.at(x, y) - place.z()) * shift;
  }
  return upright;
}

PixelMap<std::uint8_t>
straightenedColumns(const VoxelBits& occupancy,
                    const PixelMap<Eigen::Vector2f>& lean,
                    const PixelMap<float>& slab)
{
  auto columns = PixelMap<std::uint8_t>::filled(lean.nx, lean.ny, 0);
  const GridShape& shape = occupancy.shape;
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y) {
      const auto column = occupancy.column(x, y);
      if (!column.any(0, shape.nz))
        continue;
      if (lean.at(x, y).isZero(0.0f)) {
        columns.at(x, y) = 1;
        continue;
      }
      column.forEachSet(0, shape.nz, [&](int z) {
        const Eigen::Vector2d place =
            straightened(lean, slab, Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5));
        const int u = static_cast<int>(std::floor(place.x()));
        const int v = static_cast<int>(std::floor(place.y()));
        if (columns.contains(u, v))
          columns.at(u, v) = 1;
      });
    }
  return columns;
}

} // namespace pcl::indoor
