/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "free_space_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

constexpr double most_cells = 8e6;
constexpr double outlier_share = 0.005; // cut off at either end of each axis

/** The box that holds all but the outliers. */
Eigen::AlignedBox3d
innerBox(const std::vector<Eigen::Vector3f>& positions)
{
  Eigen::AlignedBox3d box;
  std::vector<float> values(positions.size());
  Eigen::Vector3d lower, upper;
  const auto cut = static_cast<std::ptrdiff_t>(outlier_share *
                                               static_cast<double>(positions.size()));
  for (int axis = 0; axis < 3; ++axis) {
    std::transform(positions.begin(),
                   positions.end(),
                   values.begin(),
                   [&](const auto& p) { return p[axis]; });
    std::nth_element(values.begin(), values.begin() + cut, values.end());
    lower[axis] = values[cut];
    std::nth_element(values.begin(), values.end() - 1 - cut, values.end());
    upper[axis] = *(values.end() - 1 - cut);
    const double margin = 0.05 * (upper[axis] - lower[axis]);
    lower[axis] -= margin;
    upper[axis] += margin;
  }
  return Eigen::AlignedBox3d(lower, upper);
}

} // namespace

namespace pcl {
namespace indoor {

FreeSpaceGrid::FreeSpaceGrid(const std::vector<Eigen::Vector3f>& positions,
                             double cell_size)
{
  const auto box = innerBox(positions);
  const auto cells = [&](double size) {
    return Eigen::Vector3d((box.sizes() / size).array().floor() + 1);
  };
  cell_size_ = cell_size;
  while (cells(cell_size_).prod() > most_cells)
    cell_size_ *= 1.1;
  origin_ = box.min();
  shape_ = cells(cell_size_).cast<int>();
  occupied_.assign(static_cast<std::size_t>(shape_.x()) * shape_.y() * shape_.z(), 0);
  for (const auto& position : positions) {
    const auto cell = cellOf(position.cast<double>());
    if (contains(cell))
      occupied_[index(cell)] = 1;
  }
}

std::vector<std::uint8_t>
FreeSpaceGrid::enclosedDirections() const
{
  std::vector<std::uint8_t> directions(occupied_.size(), 0);
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Eigen::Vector3i cell;
    for (cell[u] = 0; cell[u] < shape_[u]; ++cell[u])
      for (cell[v] = 0; cell[v] < shape_[v]; ++cell[v]) {
        bool hit = false;
        for (cell[axis] = 0; cell[axis] < shape_[axis]; ++cell[axis]) {
          hit = hit || occupied_[index(cell)];
          directions[index(cell)] += hit;
        }
        hit = false;
        for (cell[axis] = shape_[axis] - 1; cell[axis] >= 0; --cell[axis]) {
          hit = hit || occupied_[index(cell)];
          directions[index(cell)] += hit;
        }
      }
  }
  return directions;
}

std::vector<std::uint16_t>
FreeSpaceGrid::clearances() const
{
  // City-block distance to the nearest occupied cell: two sweeps per axis are exact.
  constexpr std::uint16_t far = 30000;
  std::vector<std::uint16_t> clearance(occupied_.size());
  for (std::size_t i = 0; i < clearance.size(); ++i)
    clearance[i] = occupied_[i] ? 0 : far;
  const std::size_t steps[3] = {static_cast<std::size_t>(shape_.y()) * shape_.z(),
                                static_cast<std::size_t>(shape_.z()),
                                1};
  for (int axis = 0; axis < 3; ++axis) {
    const auto step = steps[axis];
    const auto length = static_cast<std::size_t>(shape_[axis]);
    for (std::size_t i = 0; i < clearance.size(); ++i)
      if ((i / step) % length > 0)
        clearance[i] = std::min<std::uint16_t>(clearance[i], clearance[i - step] + 1);
    for (std::size_t i = clearance.size(); i-- > 0;)
      if ((i / step) % length + 1 < length)
        clearance[i] = std::min<std::uint16_t>(clearance[i], clearance[i + step] + 1);
  }
  return clearance;
}

bool
FreeSpaceGrid::sees(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const
{
  const Eigen::Vector3d start = (from.cast<double>() - origin_) / cell_size_;
  const Eigen::Vector3d end = (to.cast<double>() - origin_) / cell_size_;
  const Eigen::Vector3d way = end - start;
  const double length = way.norm();
  // The surface around the position itself does not block the sight of it.
  const double stop = length - 1.8;
  if (!(stop > 0))
    return true;
  Eigen::Vector3i cell = start.array().floor().cast<int>();
  Eigen::Vector3i step;
  Eigen::Vector3d next, increment;
  for (int axis = 0; axis < 3; ++axis) {
    step[axis] = way[axis] > 0 ? 1 : -1;
    increment[axis] = way[axis] != 0 ? length / std::abs(way[axis])
                                     : std::numeric_limits<double>::infinity();
    const double border = cell[axis] + (way[axis] > 0 ? 1 : 0);
    next[axis] = way[axis] != 0 ? (border - start[axis]) * length / way[axis]
                                : std::numeric_limits<double>::infinity();
  }
  for (;;) {
    const int axis = next.x() < next.y() ? (next.x() < next.z() ? 0 : 2)
                                         : (next.y() < next.z() ? 1 : 2);
    if (next[axis] >= stop)
      return true;
    cell[axis] += step[axis];
    next[axis] += increment[axis];
    if (contains(cell) && occupied_[index(cell)])
      return false;
  }
}

} // namespace indoor
} // namespace pcl
