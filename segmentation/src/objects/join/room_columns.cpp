/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/join/room_columns.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace {

constexpr int step_count = 64;
constexpr std::uint64_t floor_steps = 0b11;

/** The steps from the first to the last, both included. */
std::uint64_t
stepsBetween(int first, int last)
{
  const auto below = [](int step) {
    return step >= step_count ? ~std::uint64_t{0} : (std::uint64_t{1} << step) - 1;
  };
  return below(last + 1) & ~below(first);
}

} // namespace

namespace pcl::indoor {

RoomColumns::RoomColumns(const std::vector<Eigen::Vector3f>& voxels,
                         double floor,
                         double voxel_size)
: size_(2 * voxel_size)
{
  corner_ = voxels.front().cast<double>();
  for (const auto& voxel : voxels)
    corner_ = corner_.cwiseMin(voxel.cast<double>());
  corner_.z() = floor - 0.5 * size_;
  Columns all;
  all.reserve(voxels.size());
  for (const auto& voxel : voxels) {
    const Eigen::Vector2d place =
        (voxel.head<2>().cast<double>() - corner_.head<2>()) / size_;
    all.push_back({static_cast<std::int32_t>(place.x()),
                   static_cast<std::int32_t>(place.y()),
                   std::uint64_t{1} << stepOf(voxel.z())});
  }
  std::sort(all.begin(), all.end(), [](const Column& a, const Column& b) {
    return std::tie(a.x, a.y) < std::tie(b.x, b.y);
  });
  for (const auto& column : all)
    if (!columns_.empty() && columns_.back().x == column.x &&
        columns_.back().y == column.y)
      columns_.back().heights |= column.heights;
    else
      columns_.push_back(column);
}

int
RoomColumns::stepOf(double height) const
{
  const double step = std::floor((height - corner_.z()) / size_);
  return static_cast<int>(std::min(step_count - 1.0, std::max(0.0, step)));
}

double
RoomColumns::middleOf(std::int32_t cell, int axis) const
{
  return corner_[axis] + size_ * (cell + 0.5);
}

/** Call a function with the x of each row that crosses an outline, and with the row's
 * columns that have their middle in it. */
template <typename Function>
void
RoomColumns::forRowsIn(const KDop16& outline, Function function) const
{
  const auto find = [this](Columns::const_iterator begin, const auto& is_before) {
    return std::partition_point(begin, columns_.end(), is_before);
  };
  auto row = find(columns_.begin(), [&](const Column& column) {
    return middleOf(column.x, 0) < -outline[8];
  });
  while (row != columns_.end() && middleOf(row->x, 0) <= outline[0]) {
    const auto number = row->x;
    const double x = middleOf(number, 0);
    const auto span = outlineSpan(outline, x);
    const auto begin = find(row, [&](const Column& column) {
      return column.x == number && middleOf(column.y, 1) < span.low;
    });
    auto end = begin;
    while (end != columns_.end() && end->x == number &&
           middleOf(end->y, 1) <= span.high)
      ++end;
    function(x, begin, end);
    row = find(end, [&](const Column& column) { return column.x == number; });
  }
}

double
RoomColumns::areaOfFloor(const KDop16& outline) const
{
  std::size_t count = 0;
  forRowsIn(outline, [&](double /*x*/, auto begin, auto end) {
    count += std::count_if(begin, end, [](const Column& column) {
      return (column.heights & floor_steps) != 0;
    });
  });
  return count * size_ * size_;
}

RoomColumns::Gap
RoomColumns::areaBetween(const KDop16& a, const KDop16& b, Heights heights) const
{
  const auto [from, to] = std::minmax(heights.from, heights.to);
  const int first = std::max(1, stepOf(from)), last = std::max(first, stepOf(to));
  const auto between = stepsBetween(first, last), below = stepsBetween(0, first - 1);
  std::size_t open = 0, filled = 0;
  forRowsIn(hullOfBoth(a, b), [&](double x, auto begin, auto end) {
    const auto in_a = outlineSpan(a, x), in_b = outlineSpan(b, x);
    for (auto column = begin; column != end; ++column) {
      const double y = middleOf(column->y, 1);
      if (in_a.contains(y) || in_b.contains(y))
        continue;
      if (column->heights & between)
        ++filled;
      else if (column->heights & below)
        ++open;
    }
  });
  return {open * size_ * size_, filled * size_ * size_};
}

} // namespace pcl::indoor
