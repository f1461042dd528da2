/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Numbers that lie one after the other in an array, for range-based loops. */
class NumberRange {
public:
  NumberRange(const std::vector<std::uint32_t>& numbers,
              std::size_t begin,
              std::size_t end)
  : begin_(numbers.data() + begin)
  , end_(numbers.data() + end)
  {}

  const std::uint32_t*
  begin() const
  {
    return begin_;
  }

  const std::uint32_t*
  end() const
  {
    return end_;
  }

  std::size_t
  size() const
  {
    return static_cast<std::size_t>(end_ - begin_);
  }

private:
  const std::uint32_t *begin_, *end_;
};

/** \brief The occupied cells of a regular grid, sparse, with the points of each.
 * Cells are in ascending order of their keys, hence in an order that does not depend on
 * the order of the points; the points of a cell are in the order of the input.
 */
struct PointCells {
  std::vector<std::uint64_t> keys;          ///< one per occupied cell, ascending
  std::vector<std::uint32_t> cell_of_point; ///< one per point
  std::vector<std::uint32_t> offsets; ///< points of cell c: points[offsets[c]] ...
  std::vector<std::uint32_t> points;  ///< ... to points[offsets[c + 1]], exclusive

  /** \brief Get the number of occupied cells. */
  std::size_t
  size() const
  {
    return keys.size();
  }

  /** \brief Get the points of a cell, ascending. */
  NumberRange
  pointsOf(std::size_t cell) const
  {
    return NumberRange(points, offsets[cell], offsets[cell + 1]);
  }
};

/** \brief Lists of neighbours in one array: those of node i are targets[offsets[i]] to
 * targets[offsets[i + 1]], exclusive, in ascending order; a node is not its own
 * neighbour.
 */
struct Adjacency {
  std::vector<std::uint32_t> offsets;
  std::vector<std::uint32_t> targets;

  /** \brief Get the neighbours of a node, ascending. */
  NumberRange
  of(std::size_t node) const
  {
    return NumberRange(targets, offsets[node], offsets[node + 1]);
  }
};

/** \brief Sort points into the cells of a regular grid whose corner is their minimum.
 * Linear in the number of points; memory is linear in the number of occupied cells.
 * \param[in] points finite points, metres, in a local frame (a float must resolve them)
 * \param[in] cell_size edge of a cell, metres, positive
 * \return the occupied cells; empty for no points
 * \throws pcl::BadArgumentException if the cell size is not positive, or so small that
 * the extent of the points is more than two million cells
 */
PCL_INDOOR_EXPORTS PointCells
groupByCell(const std::vector<Eigen::Vector3f>& points, double cell_size);

/** \brief Sort the points into their cells anew, in ascending order in each.
 * \param[in,out] cells whose cell_of_point says where they belong; there may be cells
 * without points
 */
PCL_INDOOR_EXPORTS void
listPoints(PointCells& cells);

/** \brief Find the up to 26 occupied cells around each cell.
 * \param[in] keys as made by groupByCell()
 */
PCL_INDOOR_EXPORTS Adjacency
cellAdjacency(const std::vector<std::uint64_t>& keys);

/** \brief Get the index of a cell along x, y and z from its key; the smallest is 0. */
PCL_INDOOR_EXPORTS Eigen::Vector3i
cellIndex(std::uint64_t key);

} // namespace pcl::indoor
