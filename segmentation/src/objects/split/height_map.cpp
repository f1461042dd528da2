/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/split/height_map.h"

#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

constexpr double empty = std::numeric_limits<double>::quiet_NaN();
constexpr double outline_share = 0.35; // of an object's height
constexpr std::size_t min_area = 4;    // of an object, cells
/** An object rises by chance_deviations of the surface's heights, and so many cells. */
constexpr double min_rise = 0.1;

} // namespace

namespace pcl::indoor {

HeightMap::HeightMap(const std::vector<Eigen::Vector3d>& places, double cell_size)
: cell_size_(cell_size)
{
  Eigen::Array2d low = places.front().head<2>().array(), high = low;
  for (const auto& place : places) {
    low = low.min(place.head<2>().array());
    high = high.max(place.head<2>().array());
  }
  corner_ = low - cell_size;
  const Eigen::Array2d extent = ((high - low) / cell_size).floor() + 3;
  cell_count_ = extent.prod();
  shape_ = extent.min(1e6).cast<int>();
}

bool
HeightMap::find(const Eigen::Vector2d& place, std::uint32_t& cell) const
{
  const Eigen::Array2d index = ((place - corner_) / cell_size_).array().floor();
  if ((index < 0).any() || (index >= shape_.cast<double>()).any())
    return false;
  cell = static_cast<std::uint32_t>(index.x() * shape_.y() + index.y());
  return true;
}

void
HeightMap::prepare()
{
  if (!counts_.empty())
    return;
  counts_.assign(static_cast<std::size_t>(cell_count_), 0);
  sums_.assign(counts_.size(), 0);
}

void
HeightMap::add(std::uint32_t cell, double height)
{
  prepare();
  sums_[cell] += height;
  ++counts_[cell];
}

template <typename Function>
void
HeightMap::forNeighbors(std::uint32_t cell, Function function) const
{
  const int x = static_cast<int>(cell) / shape_.y(),
            y = static_cast<int>(cell) % shape_.y();
  for (int i = std::max(x - 1, 0); i <= std::min(x + 1, shape_.x() - 1); ++i)
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, shape_.y() - 1); ++j)
      if (i != x || j != y)
        function(static_cast<std::uint32_t>(i * shape_.y() + j));
}

void
HeightMap::smoothHeights()
{
  heights_.assign(counts_.size(), empty);
  for (std::uint32_t cell = 0; cell < counts_.size(); ++cell) {
    if (counts_[cell] == 0)
      continue;
    double sum = sums_[cell];
    std::uint32_t count = counts_[cell];
    forNeighbors(cell, [&](std::uint32_t other) {
      sum += sums_[other];
      count += counts_[other];
    });
    heights_[cell] = sum / count;
  }
}

bool
HeightMap::measureSurface(double tolerance, double min_cells)
{
  std::vector<double> near;
  for (const double height : heights_)
    if (std::abs(height) < tolerance)
      near.push_back(height);
  if (static_cast<double>(near.size()) < min_cells)
    return false;
  surface_ = quantile(near, 0.5);
  std::vector<double> depths;
  for (const double height : near)
    if (height <= surface_)
      depths.push_back(surface_ - height);
  deviation_ = deviation_per_median * quantile(depths, 0.5);
  return true;
}

template <typename Take>
HeightMap::Cells
HeightMap::connected(std::uint32_t first, Take take) const
{
  Cells cells;
  if (take(first))
    cells.push_back(first);
  for (std::size_t i = 0; i < cells.size(); ++i)
    forNeighbors(cells[i], [&](std::uint32_t other) {
      if (take(other))
        cells.push_back(other);
    });
  return cells;
}

double
HeightMap::outlineOf(const Cells& raised) const
{
  std::vector<double> rises;
  for (const auto cell : raised)
    rises.push_back(heights_[cell] - surface_);
  return surface_ + outline_share * quantile(rises, 0.75);
}

HeightMap::Cells
HeightMap::largestAbove(double outline, const Cells& raised)
{
  for (const auto cell : raised)
    if (meanHeight(cell) > outline)
      states_[cell] = State::High;
  Cells largest;
  for (const auto cell : raised) {
    auto cells = connected(cell, [&](std::uint32_t other) {
      const bool is_high = states_[other] == State::High;
      if (is_high)
        states_[other] = State::Visited;
      return is_high;
    });
    if (cells.size() > largest.size())
      largest = std::move(cells);
  }
  return largest;
}

std::vector<std::uint32_t>
HeightMap::findObjects()
{
  std::vector<std::uint32_t> object_of_cell(static_cast<std::size_t>(cell_count_), 0);
  object_count_ = 0;
  if (counts_.empty())
    return object_of_cell;
  smoothHeights();
  if (!measureSurface(cell_size_, min_object_surface))
    return object_of_cell;
  const double high = std::max(chance_deviations * deviation_, min_rise * cell_size_);
  const double low = high / 2;
  states_.assign(counts_.size(), State::Open);
  for (std::uint32_t first = 0; first < counts_.size(); ++first) {
    if (states_[first] != State::Open || !(heights_[first] - surface_ > high))
      continue;
    const auto raised = connected(first, [&](std::uint32_t cell) {
      if (states_[cell] != State::Open || !(heights_[cell] - surface_ > low))
        return false;
      states_[cell] = State::Visited;
      return true;
    });
    const auto object = largestAbove(outlineOf(raised), raised);
    if (object.size() < min_area)
      continue;
    ++object_count_;
    for (const auto cell : object)
      object_of_cell[cell] = static_cast<std::uint32_t>(object_count_);
  }
  return object_of_cell;
}

} // namespace pcl::indoor
