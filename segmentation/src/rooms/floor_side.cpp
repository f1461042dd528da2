/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/floor_side.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl::indoor {
namespace {

/** One end of a gap. */
using End = float Gap::*;

/** From a column to one beside it. */
constexpr std::uint64_t next_x = std::uint64_t(1) << 32, next_y = 1;
constexpr std::uint64_t steps[] = {next_x, next_y, 0 - next_x, 0 - next_y};

/** Gaps that are as long as rooms are high, and their neighbours. */
class RoomGaps {
public:
  explicit RoomGaps(const FreeSpace& space)
  : height_(space.length())
  , furniture_width_(
        static_cast<std::uint64_t>(std::ceil(0.2 * height_ / space.cell_size)))
  {
    for (const auto& gap : space.gaps)
      if (gap.high - gap.low > 0.4 * height_) // over tables, too
        gaps_.push_back(gap);
  }

  std::size_t
  count() const
  {
    return gaps_.size();
  }

  /** \brief How often one end of the space is nearer to the middle than in the column
   * before, by the height of furniture, and stays so as far as furniture is wide. */
  int
  countObjects(End end) const
  {
    int count = 0;
    for (const auto& gap : gaps_)
      for (const auto step : steps)
        forEachIn(gap.column + step, [&](const Gap& next) {
          count += isStep(gap, next, end) && isLevel(gap, 0 - step, 1, end) &&
                   isLevel(next, step, furniture_width_, end);
        });
    return count;
  }

private:
  /** In heights of rooms. */
  double
  difference(float a, float b) const
  {
    return (static_cast<double>(a) - b) / height_;
  }

  bool
  isSame(float a, float b) const
  {
    return std::abs(difference(a, b)) < 0.06; // some 15 cm
  }

  /** The other end stays level. */
  bool
  isStep(const Gap& gap, const Gap& next, End end) const
  {
    const bool is_low = end == &Gap::low;
    const double height =
        is_low ? difference(next.low, gap.low) : difference(gap.high, next.high);
    return height > 0.1 && height < 0.5 && // furniture has some 25 to 125 cm
           (is_low ? isSame(gap.high, next.high) : isSame(gap.low, next.low));
  }

  /** What follows on a gap has its end where the gap has it, or is no gap. */
  bool
  isLevel(const Gap& gap, std::uint64_t step, std::uint64_t count, End end) const
  {
    for (std::uint64_t i = 1; i <= count; ++i) {
      bool is_gap = false, is_level = false;
      forEachIn(gap.column + i * step, [&](const Gap& next) {
        is_gap = true;
        is_level = is_level || isSame(next.*end, gap.*end);
      });
      if (is_gap && !is_level)
        return false;
    }
    return true;
  }

  template <typename Visit>
  void
  forEachIn(std::uint64_t column, const Visit& visit) const
  {
    auto gap = std::lower_bound(
        gaps_.begin(), gaps_.end(), column, [](const Gap& g, std::uint64_t c) {
          return g.column < c;
        });
    for (; gap != gaps_.end() && gap->column == column; ++gap)
      visit(*gap);
  }

  std::vector<Gap> gaps_;
  double height_;
  std::uint64_t furniture_width_; ///< columns: a fifth of the height of rooms
};

} // namespace

ObjectsAtEnds&
ObjectsAtEnds::operator+=(const ObjectsAtEnds& other)
{
  low += other.low;
  high += other.high;
  columns += other.columns;
  return *this;
}

int
ObjectsAtEnds::clearEnd(double times) const
{
  // Furnished homes and offices have 0.04 to 0.14 per column, and 1.5 to 50 times as
  // many at the floor; empty buildings less than 0.04, at either end.
  constexpr int enough = 20; // columns at the sides of objects
  constexpr double per_column = 0.04;
  const int more = std::max(low, high), less = std::min(low, high);
  const bool is_clear = more >= enough &&
                        more >= per_column * static_cast<double>(columns) &&
                        more > times * less;
  return !is_clear ? 0 : high > low ? 1 : -1;
}

ObjectsAtEnds
objectsAtEnds(const FreeSpace& space)
{
  if (!(space.length() > 0.0))
    return {};
  const RoomGaps rooms(space);
  return {rooms.countObjects(&Gap::low), rooms.countObjects(&Gap::high), rooms.count()};
}

} // namespace pcl::indoor
