/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** A cell of a plane: column and row. */
using PlaneCell = std::array<std::int64_t, 2>;

/** What an object covers of a plane, and where it is closed towards it. */
class PlaneShadow {
public:
  enum Flag : std::uint8_t { covered = 1, closing = 2 };

  /** \param[in] low, high the outermost cells, inclusive */
  PlaneShadow(const PlaneCell& low, const PlaneCell& high);

  /** Mark a cell and those that touch it, as far as they are within. */
  void
  mark(const PlaneCell& cell, Flag flag);

  /** The covered cells from which, on each of the four sides, covered cells lead to one
   * that closes. */
  std::vector<PlaneCell>
  enclosed() const;

private:
  std::size_t
  indexOf(std::int64_t column, std::int64_t row) const
  {
    return static_cast<std::size_t>(row * columns_ + column);
  }

  PlaneCell low_;
  std::int64_t columns_, rows_;
  std::vector<std::uint8_t> flags_;
};

} // namespace indoor
} // namespace pcl
