/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** A cell of a plane: column and row. */
using PlaneCell = std::array<std::int64_t, 2>;

/** What an object covers of a plane, and where it is closed towards it. */
class PlaneShadow {
public:
  enum Flag : std::uint8_t { covered = 1, closing = 2 };

  /** Towards lower or higher numbers. */
  enum Side : std::uint8_t {
    LowColumns = 16,
    HighColumns = 32,
    LowRows = 64,
    HighRows = 128
  };

  /** \param[in] low, high the outermost cells, inclusive */
  PlaneShadow(const PlaneCell& low, const PlaneCell& high);

  /** Mark a cell that the object has points in, and those that touch it, as far as they
   * are within. */
  void
  mark(const PlaneCell& cell, Flag flag);

  /** Let the object cover all cells. */
  void
  coverAll();

  /** The plane ends at this cell, which must be within, on that side. */
  void
  end(const PlaneCell& cell, Side side);

  /** The cells that are closed off: no path of side-by-side cells leads to them from an
   * uncovered cell, or from outside, except over a closing cell or an end of the plane.
   * A closed-off cell without points of the object counts only if all cells around it
   * are closed off, too. */
  std::vector<PlaneCell>
  enclosed() const;

private:
  std::size_t
  indexOf(std::int64_t column, std::int64_t row) const
  {
    return static_cast<std::size_t>(row * columns_ + column);
  }

  std::vector<std::uint8_t>
  openCells() const;

  bool
  isAmong(const std::vector<std::uint8_t>& enclosed,
          std::int64_t column,
          std::int64_t row) const;

  PlaneCell low_;
  std::int64_t columns_, rows_;
  std::vector<std::uint8_t> flags_;
};

} // namespace pcl::indoor
