/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "normals/free_space_grid.h"

#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

constexpr double most_cells = 8e6;
constexpr std::uint8_t most_clearance = 255; // and everything further
constexpr double outlier_share = 0.005;      // cut off at either end of each axis

/** The box that holds all but the outliers. */
Eigen::AlignedBox3d
innerBox(const std::vector<Eigen::Vector3f>& positions)
{
  std::vector<float> values(positions.size());
  Eigen::Vector3d lower, upper;
  const auto cut =
      static_cast<std::size_t>(outlier_share * static_cast<double>(positions.size()));
  for (int axis = 0; axis < 3; ++axis) {
    std::transform(positions.begin(),
                   positions.end(),
                   values.begin(),
                   [&](const auto& p) { return p[axis]; });
    lower[axis] = pcl::indoor::valueAtRank(values, cut);
    upper[axis] = pcl::indoor::valueAtRank(values, values.size() - 1 - cut);
    const double margin = 0.05 * (upper[axis] - lower[axis]);
    lower[axis] -= margin;
    upper[axis] += margin;
  }
  return {lower, upper};
}

} // namespace

namespace pcl::indoor {

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
  clearances_.assign(static_cast<std::size_t>(shape_.x()) * shape_.y() * shape_.z(),
                     most_clearance);
  for (const auto& position : positions) {
    const auto cell = cellOf(position.cast<double>());
    if (contains(cell))
      clearances_[index(cell)] = 0;
  }
  for (int axis = 0; axis < 3; ++axis)
    sweep(axis);
}

/** City-block distances: two sweeps per axis are exact. */
void
FreeSpaceGrid::sweep(int axis)
{
  const std::size_t step = axis == 0 ? static_cast<std::size_t>(shape_.y()) * shape_.z()
                           : axis == 1 ? static_cast<std::size_t>(shape_.z())
                                       : 1;
  const std::size_t block = step * shape_[axis];
  const auto lower = [](std::uint8_t& value, std::uint8_t neighbor) {
    if (neighbor < value)
      value = std::min<std::uint8_t>(value, static_cast<std::uint8_t>(neighbor + 1));
  };
  for (std::size_t first = 0; first < clearances_.size(); first += block) {
    for (std::size_t i = first + step; i < first + block; ++i)
      lower(clearances_[i], clearances_[i - step]);
    for (std::size_t i = first + block - step; i-- > first;)
      lower(clearances_[i], clearances_[i + step]);
  }
}

std::vector<std::uint8_t>
FreeSpaceGrid::enclosedDirections() const
{
  std::vector<std::uint8_t> directions(clearances_.size(), 0);
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Eigen::Vector3i cell;
    for (cell[u] = 0; cell[u] < shape_[u]; ++cell[u])
      for (cell[v] = 0; cell[v] < shape_[v]; ++cell[v]) {
        bool hit = false;
        for (cell[axis] = 0; cell[axis] < shape_[axis]; ++cell[axis]) {
          hit = hit || isOccupied(index(cell));
          directions[index(cell)] += hit;
        }
        hit = false;
        for (cell[axis] = shape_[axis] - 1; cell[axis] >= 0; --cell[axis]) {
          hit = hit || isOccupied(index(cell));
          directions[index(cell)] += hit;
        }
      }
  }
  return directions;
}

bool
FreeSpaceGrid::sees(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const
{
  const Eigen::Vector3d start = (from.cast<double>() - origin_) / cell_size_;
  const Eigen::Vector3d end = (to.cast<double>() - origin_) / cell_size_;
  const double length = (end - start).norm();
  // The surface around the position itself does not block the sight of it.
  const double stop = length - 1.8;
  if (!(stop > 0))
    return true;
  const Eigen::Vector3d way = (end - start) / length;
  const double block_speed = way.lpNorm<1>(); // city-block distance per length
  const Eigen::Vector3d per_cell = way.cwiseAbs().cwiseInverse();
  std::ptrdiff_t step[3] = {
      static_cast<std::ptrdiff_t>(shape_.y()) * shape_.z(), shape_.z(), 1};
  for (int axis = 0; axis < 3; ++axis)
    if (way[axis] <= 0)
      step[axis] = -step[axis];
  double at = 0; // where the line entered the cell
  for (bool is_first = true;;) {
    const Eigen::Vector3d place = start + at * way;
    const Eigen::Vector3i cell = cellAt(place);
    // Outside of the box, which the line does not enter again, there is nothing.
    if (!contains(cell))
      return true;
    double next[3]; // where the line leaves the cell, per axis
    int left[3];    // cells before it leaves the grid
    for (int axis = 0; axis < 3; ++axis) {
      const bool rises = way[axis] > 0;
      next[axis] = way[axis] != 0 ? at + (cell[axis] + rises - place[axis]) / way[axis]
                                  : std::numeric_limits<double>::infinity();
      left[axis] = rises ? shape_[axis] - 1 - cell[axis] : cell[axis];
    }
    // On a way of d, the cell changes by less than d + 1 along each axis.
    constexpr int rounding = 4, worthwhile = 7;
    const auto* clearance = &clearances_[index(cell)];
    for (; *clearance < worthwhile; is_first = false) {
      if (*clearance == 0 && !is_first)
        return false;
      const bool is_x = next[0] < next[1]; // no branches, which nothing could predict
      const double nearest = is_x ? next[0] : next[1];
      const int axis = nearest < next[2] ? 1 - is_x : 2;
      at = next[axis];
      if (at >= stop || left[axis]-- == 0)
        return true;
      clearance += step[axis];
      next[axis] += per_cell[axis];
    }
    is_first = false;
    at += (*clearance - rounding) / block_speed;
    if (at >= stop)
      return true;
  }
}

} // namespace pcl::indoor
