/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "bar_cells.h"

#include <pcl/segmentation/straight_bars.h>

#include <vector>

namespace pcl {
namespace indoor {

/** Finds the bars along the axes of a grid of cells, each as wide as a voxel. */
class BarFinder {
public:
  /** \param[in] cells the occupied ones, each once */
  BarFinder(std::vector<GridCell> cells, const StraightBarOptions& options);

  /** The boxes of cells around them. */
  std::vector<CellBox>
  barsAlong(int axis) const;

private:
  bool
  areOneBeam(const CellBox& a, const CellBox& b, int axis) const;

  bool
  isBar(const CellBox& box, int axis) const;

  /** Cells of a box's length at which, so far from the box across, there is something.
   */
  int
  lengthWith(const CellBox& box, int axis, int from, int to) const;

  CellRuns runs_;
  const StraightBarOptions& options_;
};

} // namespace indoor
} // namespace pcl
