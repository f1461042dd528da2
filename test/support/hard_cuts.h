/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/space/grid_cut.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

struct CutProblem {
  pcl::indoor::GridShape shape;
  std::vector<std::int16_t> gain;
  int smoothness = 0;
};

/** \brief Problems that are hard to cut, each for another reason. All are cubes or
 * halls with sides of about so many voxels, so that the number of voxels can be chosen.
 */
namespace hard_cuts {

/** \brief A gain for each voxel, called in the order of memory. */
template <typename Gain>
CutProblem
fill(const pcl::indoor::GridShape& shape, int smoothness, Gain gain)
{
  CutProblem problem{shape, {}, smoothness};
  problem.gain.reserve(shape.size());
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y)
      for (int z = 0; z < shape.nz; ++z)
        problem.gain.push_back(static_cast<std::int16_t>(gain(x, y, z)));
  return problem;
}

/** \brief A normal number, near enough: the sum of twelve. */
inline double
normal(std::mt19937& rng)
{
  double sum = -6.0;
  for (int i = 0; i < 12; ++i)
    sum += rng() / 4294967296.0;
  return sum;
}

/** \brief Independent gains, all in a range alike likely. */
inline CutProblem
uniform(int side, int largest, int smoothness = 60)
{
  std::mt19937 rng(63);
  return fill({side, side, side}, smoothness, [&](int, int, int) {
    return static_cast<int>(rng() % (2 * largest + 1)) - largest;
  });
}

/** \brief Independent normal gains. The random-field Ising model has its phase
 * transition at a deviation of 2.27 times the smoothness: there flow goes farthest.
 */
inline CutProblem
critical(int side, double deviation = 2.27)
{
  std::mt19937 rng(64);
  return fill({side, side, side}, 60, [&](int, int, int) {
    return std::lround(60 * deviation * normal(rng));
  });
}

/** \brief The mean of 2 r + 1 values along an axis, in a ring. */
inline void
blur(std::vector<double>& values, int side, std::size_t step, int r)
{
  std::vector<double> line(side);
  for (std::size_t start = 0; start < values.size(); ++start) {
    if (start / step % side != 0)
      continue;
    for (int i = 0; i < side; ++i) {
      line[i] = 0.0;
      for (int k = -r; k <= r; ++k)
        line[i] += values[start + step * ((i + k + side) % side)] / (2 * r + 1);
    }
    for (int i = 0; i < side; ++i)
      values[start + step * i] = line[i];
  }
}

/** \brief Normal gains that change slowly from place to place: hills and valleys. */
inline CutProblem
smooth(int side, int radius, double deviation)
{
  std::mt19937 rng(67);
  std::vector<double> values(static_cast<std::size_t>(side) * side * side);
  for (double& value : values)
    value = normal(rng);
  for (const std::size_t step : {std::size_t{1},
                                 static_cast<std::size_t>(side),
                                 static_cast<std::size_t>(side) * side})
    for (int twice = 0; twice < 2; ++twice)
      blur(values, side, step, std::min(radius, (side - 1) / 2));
  double squares = 0.0;
  for (const double value : values)
    squares += value * value;
  const double scale =
      deviation / std::sqrt(squares / static_cast<double>(values.size()));
  std::size_t v = 0;
  return fill({side, side, side}, 60, [&](int, int, int) {
    return std::lround(values[v++] * scale);
  });
}

/** \brief One corridor, a voxel wide, that fills a cube. */
template <typename Gain>
CutProblem
corridor(int side, int smoothness, Gain gain)
{
  CutProblem problem = fill({side, side, side}, smoothness, [](int, int, int) {
    return pcl::indoor::GRID_CUT_EXCLUDED;
  });
  std::vector<std::size_t> layer; // of a storey, from the first corner to the last one
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y) {
      const bool backwards = x % 4 >= 2;
      const bool turn = x % 2 == 1 && y == (backwards ? 0 : side - 1);
      const int at = x % 2 == 0 && backwards ? side - 1 - y : y;
      if (x % 2 == 0 || (turn && x + 1 < side))
        layer.push_back(problem.shape.index(x, at, 0));
    }
  std::vector<std::size_t> path;
  for (int z = 0; z < side; ++z) {
    if (z % 2 == 0)
      for (const std::size_t v : layer)
        path.push_back(v + z);
    else if (z + 1 < side)
      path.push_back(layer.back() + z);
    if (z % 2 == 1)
      std::reverse(layer.begin(), layer.end());
  }
  for (std::size_t i = 0; i < path.size(); ++i)
    problem.gain[path[i]] = static_cast<std::int16_t>(gain(i, path.size()));
  return problem;
}

/** \brief Small pieces of what wants inside in one half, of what does not in the other.
 */
inline CutProblem
corridorOfPieces(int side)
{
  std::mt19937 rng(68);
  return corridor(
      side, pcl::indoor::grid_cut_max_smoothness, [&](std::size_t i, std::size_t size) {
        const int piece = rng() % 100 == 0;
        return i < size / 2 ? piece : -piece;
      });
}

/** \brief Random gains along a corridor. */
inline CutProblem
corridorOfChance(int side)
{
  std::mt19937 rng(69);
  return corridor(side, 60, [&](std::size_t, std::size_t) {
    return static_cast<int>(rng() % 3) - 1;
  });
}

/** \brief Each half agrees with itself, hardly: flow goes through everything. */
inline CutProblem
halves(int side, int left, int right, int smoothness = 60)
{
  return fill({side, side, side}, smoothness, [&](int x, int, int) {
    return x < side / 2 ? left : -right;
  });
}

/** \brief A cube whose inner part does not care, between two opposite faces that do. */
inline CutProblem
farApart(int side, int gain)
{
  return fill({side, side, side}, 60, [&](int x, int, int) {
    return x == 0 ? gain : x == side - 1 ? -gain : 0;
  });
}

/** \brief A large hall that is nearly undecided, with strong evidence at its rim. */
inline CutProblem
hall(int side, int base)
{
  std::mt19937 rng(70);
  const int nz = std::min(20, side);
  return fill({side, side, nz}, 60, [&](int x, int y, int z) {
    const bool rim =
        x == 0 || y == 0 || z == 0 || x == side - 1 || y == side - 1 || z == nz - 1;
    return !rim || rng() % 5 != 0 ? base : rng() % 2 != 0 ? 200 : -200;
  });
}

/** \brief Nested boxes, one in another, that disagree. */
inline CutProblem
shells(int side, int width, int gain)
{
  return fill({side, side, side}, 60, [&](int x, int y, int z) {
    const int off = std::max(
        {std::abs(2 * x - side), std::abs(2 * y - side), std::abs(2 * z - side)});
    return off / 2 / width % 2 != 0 ? gain : -gain;
  });
}

/** \brief Cubes that disagree with all their neighbours. */
inline CutProblem
checkerboard(int side, int cube, int gain)
{
  return fill({side, side, side}, 60, [&](int x, int y, int z) {
    return (x / cube + y / cube + z / cube) % 2 != 0 ? gain : -gain;
  });
}

/** \brief Long narrow rooms at a corridor. */
inline CutProblem
comb(int side)
{
  std::mt19937 rng(72);
  return fill({side, side, std::min(20, side)}, 60, [&](int x, int y, int) -> int {
    if (x < 2)
      return 1;
    if (y / 2 % 2 != 0)
      return pcl::indoor::GRID_CUT_EXCLUDED;
    return x >= side - 2 ? -50 : rng() % 2 != 0 ? 1 : -1;
  });
}

/** \brief A third of the voxels at random, just enough for ways through. */
inline CutProblem
maze(int side)
{
  std::mt19937 rng(73);
  return fill({side, side, side}, 60, [&](int, int, int) -> int {
    const bool open = rng() % 100 < 33;
    const int gain = static_cast<int>(rng() % 7) - 3;
    return open ? gain : pcl::indoor::GRID_CUT_EXCLUDED;
  });
}

} // namespace hard_cuts
