/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/ascending_numbers.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::indoor::tool {

/** \brief One point per cell of a grid: the first one that was added.
 *
 * If there are more than a limit, cells become twice as large, but no larger than four
 * times the first size. Which points are kept depends on nothing but their order.
 * Memory follows the cells: 17 to 18 bytes for each, and 4 for each place of a table of
 * which at least a third is filled, while points are added or looked for.
 */
class CellSample {
public:
  /** \param[in] cell_size in the unit of the points, positive */
  CellSample(double cell_size, std::size_t limit);

  /** \param[in] index of the point in its file */
  void
  add(const Eigen::Vector3f& point, std::uint64_t index);

  /** \brief The number of the point that stands for this one; none if no point of its
   * cell was added. Makes the table first if shrink() has given it back. */
  std::optional<std::uint32_t>
  find(const Eigen::Vector3f& point);

  /** \brief The points that were kept. */
  const PointCloud<PointXYZ>::Ptr&
  points() const
  {
    return points_;
  }

  /** \brief Of the points, one after the other. */
  const AscendingNumbers&
  indices() const
  {
    return indices_;
  }

  /** \brief Give back the memory that more points would have taken, and the table. */
  void
  shrink();

  double
  cellSize() const
  {
    return cell_size_ * (1 << level_);
  }

private:
  std::uint64_t
  cellOf(const Eigen::Vector3f& point) const;

  /** Where the point of a cell is in the table, or the free place where it belongs. */
  std::size_t
  placeOf(std::uint64_t cell) const;

  /** Make the table of that many places; no two points may be in one cell. */
  void
  makeTable(std::size_t places);

  /** Make cells larger, and keep the first point of each. */
  void
  thinOut();

  double cell_size_;
  std::size_t limit_;
  int level_ = 0;
  PointCloud<PointXYZ>::Ptr points_;
  AscendingNumbers indices_;
  std::vector<std::uint32_t> numbers_; ///< of points, a table of a power of two or none
};

} // namespace pcl::indoor::tool
