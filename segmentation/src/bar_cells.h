/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <algorithm>
#include <array>
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

/** The straight runs of occupied cells along an axis that are thin.
 * A run goes on over up to two empty cells. It is thin if across it the runs through at
 * least a third of its cells are at most a fifth as long as it is.
 * \param[in] cells each once
 * \param[in] min_length of a run, cells
 */
std::vector<CellBox>
thinRuns(const std::vector<GridCell>& cells, int axis, double min_length);

} // namespace indoor
} // namespace pcl
