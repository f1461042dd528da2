/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/ascending_numbers.h"

#include <pcl/indoor/exports.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor::tool {

/** \brief One point per cell of a grid: the first one that was added.
 *
 * If there are more than a limit, cells become twice as large, but no larger than four
 * times the first size. Which points are kept depends on nothing but their order.
 * Memory follows the cells: 17 to 18 bytes for each, and 5 for each place of a table of
 * which at least a third is filled, while points are added or looked for.
 */
class PCL_INDOOR_EXPORTS CellSample {
public:
  /** \param[in] cell_size in the unit of the points, positive */
  CellSample(double cell_size, std::size_t limit);

  /** \brief Add points, but for those that are not finite.
   * \param[in] first index of the first one in its file */
  void
  add(const PointCloud<PointXYZ>& points, std::uint64_t first);

  static constexpr std::uint32_t absent = 0xffffffffu;

  /** \brief Per point the number of the one that stands for it; absent where it is not
   * finite or no point of its cell was added. Makes the table first if shrink() has
   * given it back. */
  std::vector<std::uint32_t>
  find(const PointCloud<PointXYZ>& points);

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

  /** The first place from that of a hash on that is free or has its tag and a point
   * that is_same(number) of. */
  template <typename IsSame>
  std::size_t
  placeOf(std::uint64_t hash, const IsSame& is_same) const;

  template <typename Visit>
  std::size_t
  forEachPlace(const PointCloud<PointXYZ>& points,
               std::size_t begin,
               const Visit& visit) const;

  /** Make the table of that many places; no two points may be in one cell. */
  void
  makeTable(std::size_t places);

  void
  dropTable();

  /** Are there more points than the limit, and can cells become larger? */
  bool
  isTooMany() const;

  /** Make cells larger, and keep the first point of each. */
  void
  thinOut();

  double cell_size_;
  std::size_t limit_;
  int level_ = 0;
  PointCloud<PointXYZ>::Ptr points_;
  AscendingNumbers indices_;
  // A table of a power of two, or none.
  std::vector<std::uint8_t> tags_;     ///< of the point in a place; 0 where it is free
  std::vector<std::uint32_t> numbers_; ///< of the point
};

} // namespace pcl::indoor::tool
