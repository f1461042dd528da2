/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/plane_shadow.h"

#include <algorithm>

namespace {

constexpr std::uint8_t seen = 4; // the object has points in the cell itself

} // namespace

namespace pcl::indoor {

PlaneShadow::PlaneShadow(const PlaneCell& low, const PlaneCell& high)
: low_(low)
, columns_(high[0] - low[0] + 1)
, rows_(high[1] - low[1] + 1)
, flags_(static_cast<std::size_t>(columns_ * rows_), 0)
{}

void
PlaneShadow::mark(const PlaneCell& cell, Flag flag)
{
  const auto column = cell[0] - low_[0], row = cell[1] - low_[1];
  for (auto r = std::max<std::int64_t>(row - 1, 0); r <= std::min(row + 1, rows_ - 1);
       ++r)
    for (auto c = std::max<std::int64_t>(column - 1, 0);
         c <= std::min(column + 1, columns_ - 1);
         ++c)
      flags_[indexOf(c, r)] |= flag | (c == column && r == row ? seen : 0);
}

void
PlaneShadow::end(const PlaneCell& cell, Side side)
{
  flags_[indexOf(cell[0] - low_[0], cell[1] - low_[1])] |= side;
}

void
PlaneShadow::coverAll()
{
  for (auto& flags : flags_)
    flags |= covered;
}

/** Those that a way leads to from what is not covered or from outside. */
std::vector<std::uint8_t>
PlaneShadow::openCells() const
{
  std::vector<std::uint8_t> open(flags_.size(), 0);
  std::vector<PlaneCell> reached;
  const auto enter = [&](std::int64_t column, std::int64_t row, std::uint8_t side) {
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_)
      return;
    const auto cell = indexOf(column, row);
    if (open[cell] || (flags_[cell] & (closing | side)))
      return;
    open[cell] = 1;
    reached.push_back({column, row});
  };
  for (std::int64_t row = 0; row < rows_; ++row) {
    enter(0, row, LowColumns);
    enter(columns_ - 1, row, HighColumns);
    for (std::int64_t column = 0; column < columns_; ++column)
      if (!(flags_[indexOf(column, row)] & covered))
        enter(column, row, 0);
  }
  for (std::int64_t column = 0; column < columns_; ++column) {
    enter(column, 0, LowRows);
    enter(column, rows_ - 1, HighRows);
  }
  while (!reached.empty()) {
    const auto [column, row] = reached.back();
    reached.pop_back();
    enter(column + 1, row, LowColumns);
    enter(column - 1, row, HighColumns);
    enter(column, row + 1, LowRows);
    enter(column, row - 1, HighRows);
  }
  return open;
}

std::vector<PlaneCell>
PlaneShadow::enclosed() const
{
  const auto open = openCells();
  std::vector<std::uint8_t> enclosed(flags_.size());
  for (std::size_t cell = 0; cell < flags_.size(); ++cell)
    enclosed[cell] = !open[cell] && (flags_[cell] & covered);
  std::vector<PlaneCell> cells;
  for (std::int64_t row = 0; row < rows_; ++row)
    for (std::int64_t column = 0; column < columns_; ++column)
      if (enclosed[indexOf(column, row)] &&
          ((flags_[indexOf(column, row)] & seen) || isAmong(enclosed, column, row)))
        cells.push_back({low_[0] + column, low_[1] + row});
  return cells;
}

bool
PlaneShadow::isAmong(const std::vector<std::uint8_t>& enclosed,
                     std::int64_t column,
                     std::int64_t row) const
{
  if (column == 0 || row == 0 || column == columns_ - 1 || row == rows_ - 1)
    return false;
  for (auto r = row - 1; r <= row + 1; ++r)
    for (auto c = column - 1; c <= column + 1; ++c)
      if (!enclosed[indexOf(c, r)])
        return false;
  return true;
}

} // namespace pcl::indoor
