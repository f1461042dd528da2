/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** A cell of a regular grid. */
using GridCell = std::array<int, 3>;

/** The cells from one corner to the opposite one, both inclusive. */
struct CellBox {
  GridCell low{}, high{};

  int
  length(int axis) const
  {
    return high[axis] - low[axis] + 1;
  }

  /** The cells in common along an axis; if none, less as many as lie between. */
  int
  common(const CellBox& other, int axis) const
  {
    return std::min(high[axis], other.high[axis]) -
           std::max(low[axis], other.low[axis]) + 1;
  }

  /** Grow as far as the other. */
  void
  include(const CellBox& other)
  {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], other.low[axis]);
      high[axis] = std::max(high[axis], other.high[axis]);
    }
  }
};

/** Occupied cells, and the straight runs that they form along the axes of their grid. A
 * run goes on over single empty cells. */
class CellRuns {
public:
  /** \param[in] cells each once */
  explicit CellRuns(std::vector<GridCell> cells);

  const std::vector<GridCell>&
  cells() const
  {
    return cells_;
  }

  /** The runs along an axis that are thin: across it, the runs through at least a third
   * of their cells are at most a fifth as long.
   * \param[in] min_length of a run, cells
   */
  std::vector<CellBox>
  thinAlong(int axis, double min_length) const;

private:
  /** Along one axis. */
  struct Lines {
    std::vector<std::uint32_t> order; // of cells, line by line
    std::vector<std::uint32_t> ends;  // of runs, exclusive, in that order
    std::vector<int> length_at;       // of the run through each cell
  };

  void
  findRuns(int axis);

  std::vector<GridCell> cells_;
  std::array<Lines, 3> lines_;
};

} // namespace indoor
} // namespace pcl
