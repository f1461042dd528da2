/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/scan_sample.h"

#include "rooms/space/voxel_normals.h"

#include <pcl/indoor/point_hash.h>
#include <pcl/indoor/quantile.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl::indoor {
namespace {

using Points = std::vector<Eigen::Vector3f>;
using KeyedPoints = std::vector<std::pair<std::uint64_t, std::uint32_t>>;

constexpr double points_per_cell = 4.0; // a surface without holes, where it is average
constexpr int levels = 12; // of an octree, each half as large as the one before

/** A coordinate's bits with two places between each two. */
std::uint64_t
spread(std::uint64_t value)
{
  std::uint64_t result = 0;
  for (int bit = 0; bit < levels; ++bit)
    result |= (value >> bit & 1) << 3 * bit;
  return result;
}

/** The size at which an occupied cell holds some points on average. */
double
cellSize(const Points& sample, const SampleCells& cells)
{
  std::vector<std::uint64_t> keys;
  for (const auto& point : sample) {
    if (!cells.contains(point))
      continue;
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key |= spread(cells.place(point, axis, cells.edge / (1 << levels))) << axis;
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  double finer = 0.0; // points per cell, one level below
  for (int level = levels; level >= 0; --level) {
    std::size_t count = 0;
    const int shift = 3 * (levels - level);
    for (std::size_t i = 0; i < keys.size(); ++i)
      count += i == 0 || keys[i] >> shift != keys[i - 1] >> shift;
    const double mean = static_cast<double>(keys.size()) / std::max<double>(1.0, count);
    if (mean >= points_per_cell) {
      const double part =
          level == levels ? 1.0 : (points_per_cell - finer) / (mean - finer);
      return cells.edge / (1 << levels) * std::exp2(levels - level - 1 + part);
    }
    finer = mean;
  }
  return 0.0;
}

/** \param[in] key of a point inside the cells */
template <typename Key>
KeyedPoints
grouped(const Points& sample, const SampleCells& cells, const Key& key)
{
  KeyedPoints groups;
  for (std::uint32_t i = 0; i < sample.size(); ++i)
    if (cells.contains(sample[i]))
      groups.emplace_back(key(sample[i]), i);
  std::sort(groups.begin(), groups.end());
  return groups;
}

/** \param[in] points of one cell, relative to one of them
 * \return of a plane, if they lie in one */
std::optional<SurfacePiece>
pieceOf(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const auto& p : points) {
    sum += p;
    squares += p * p.transpose();
  }
  const auto count = static_cast<double>(points.size());
  const Eigen::Vector3d mean = sum / count;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(squares / count - mean * mean.transpose());
  const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0.0);
  if (!(values[1] - values[0] > plane_flatness * values[2]))
    return {};
  return SurfacePiece{solver.eigenvectors().col(0), mean};
}

/** From the lowest hundredth to the highest one of what is left without the values that
 * lie nine times as far away as these reach, such as -10000 for nothing. */
std::pair<double, double>
rangeOfMost(std::vector<float>& values)
{
  if (values.empty())
    return {0.0, 0.0};
  const std::size_t hundredth = values.size() / 100;
  float low = valueAtRank(values, hundredth);
  float high = valueAtRank(values, values.size() - 1 - hundredth);
  const float middle = median(values);
  const float spread = 0.1f * (high - low); // of all values but those far away
  const bool are_high = high - middle <= spread;
  if (!are_high && middle - low > spread)
    return {low, high};
  const float between = are_high ? high - spread : low + spread;
  float below = low, above = high; // the ends of the gap
  for (const float value : values)
    if (value < between)
      below = std::max(below, value);
    else
      above = std::min(above, value);
  if (above - below > 9.0f * spread)
    (are_high ? low : high) = are_high ? above : below;
  return {low, high};
}

} // namespace

bool
SampleCells::contains(const Eigen::Vector3f& point) const
{
  const Eigen::Array3d local = point.cast<double>() - origin;
  return (local >= 0.0).all() && (local < edge).all();
}

std::uint64_t
SampleCells::place(const Eigen::Vector3f& point, int axis, double cell_size) const
{
  return static_cast<std::uint64_t>((point[axis] - origin[axis]) / cell_size);
}

Points
samplePoints(const Points& points)
{
  const auto one_in =
      static_cast<std::uint32_t>(std::max<std::size_t>(1, points.size() / sample_size));
  Points sample;
  for (const auto& point : points)
    if (static_cast<std::uint32_t>(pointHash(point) >> 32) % one_in == 0)
      sample.push_back(point);
  std::sort(sample.begin(), sample.end(), [](const auto& a, const auto& b) {
    return std::make_tuple(a.x(), a.y(), a.z()) < std::make_tuple(b.x(), b.y(), b.z());
  });
  return sample;
}

SampleCells
cubeAround(const Points& sample, double cell_size)
{
  SampleCells cells;
  Eigen::Vector3d low, high;
  std::vector<float> values(sample.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::transform(sample.begin(), sample.end(), values.begin(), [axis](const auto& p) {
      return p[axis];
    });
    std::tie(low[axis], high[axis]) = rangeOfMost(values);
  }
  cells.edge = 1.1 * (high - low).maxCoeff(); // the outermost surfaces are inside
  cells.origin = 0.5 * (low + high) - Eigen::Vector3d::Constant(0.5 * cells.edge);
  cells.size = cell_size;
  return cells;
}

SampleCells
cellsOf(const Points& sample)
{
  auto cells = cubeAround(sample, 0.0);
  if (cells.edge > 0.0)
    cells.size = cellSize(sample, cells);
  return cells;
}

std::vector<SurfacePiece>
surfacePieces(const Points& sample, const SampleCells& cells)
{
  const double size = 2.0 * cells.size;
  const auto groups = grouped(sample, cells, [&](const Eigen::Vector3f& p) {
    return cells.place(p, 0, size) << 42 | cells.place(p, 1, size) << 21 |
           cells.place(p, 2, size);
  });
  std::vector<SurfacePiece> pieces;
  std::vector<Eigen::Vector3d> points;
  for (std::size_t begin = 0, end = 0; begin < groups.size(); begin = end) {
    points.clear();
    const Eigen::Vector3f& first = sample[groups[begin].second];
    for (; end < groups.size() && groups[end].first == groups[begin].first; ++end)
      points.push_back((sample[groups[end].second] - first).cast<double>());
    if (points.size() < plane_points)
      continue;
    if (auto piece = pieceOf(points)) {
      piece->place += first.cast<double>();
      pieces.push_back(*piece);
    }
  }
  return pieces;
}

FreeSpace
freeSpaceOf(const Points& sample, const SampleCells& cells)
{
  const auto columns = grouped(sample, cells, [&](const Eigen::Vector3f& p) {
    return cells.place(p, 0, cells.size) << 32 | cells.place(p, 1, cells.size);
  });
  FreeSpace space;
  space.cell_size = cells.size;
  std::vector<float> column;
  for (std::size_t begin = 0, end = 0; begin < columns.size(); begin = end) {
    ++space.columns;
    column.clear();
    for (; end < columns.size() && columns[end].first == columns[begin].first; ++end)
      column.push_back(sample[columns[end].second].z());
    std::sort(column.begin(), column.end());
    for (std::size_t i = 1; i < column.size(); ++i)
      if (column[i] - column[i - 1] > 2.0 * cells.size) // else along a surface
        space.gaps.push_back({columns[begin].first, column[i - 1], column[i]});
  }
  return space;
}

double
FreeSpace::length() const
{
  std::vector<double> longest; // of each column
  double sum = 0.0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const double length = gaps[i].high - gaps[i].low;
    if (i == 0 || gaps[i].column != gaps[i - 1].column)
      longest.push_back(length);
    else
      longest.back() = std::max(longest.back(), length);
  }
  for (const double length : longest)
    sum += length;
  std::sort(longest.begin(), longest.end());
  double shorter = 0.0;
  for (const double length : longest)
    if ((shorter += length) >= 0.5 * sum)
      return length;
  return 0.0;
}

} // namespace pcl::indoor
