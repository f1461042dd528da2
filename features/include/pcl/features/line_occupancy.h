/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>
#include <pcl/indoor/exports.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief An occupancy grid of up to 64^3 voxels that counts occupied voxels along
 * lines.
 *
 * A column along z is the 64 bits of one word, so that the whole grid (32 kB) stays in
 * the first-level cache. A cell is packed into one integer, 21 bits per axis of which
 * 15 are a fraction; a step along a line then is one addition.
 */
class PCL_INDOOR_EXPORTS LineOccupancy {
public:
  /** \brief A voxel, or a place within one: x, y and z packed in fixed point. */
  using Cell = std::uint64_t;

  /** \brief Mark the voxels of points in a cube around them.
   * \param[in] points at least one; the cube's edge is the longest of their bounding
   * box
   * \param[in] grid_size voxels per edge, 2 to 64
   */
  LineOccupancy(const std::vector<OrientedPoint>& points, int grid_size);

  /** \brief Voxels per edge, the most that a line can meet. */
  int
  size() const
  {
    return static_cast<int>(largest_coordinate_) + 1;
  }

  /** \brief The voxel of a place; places outside go to the nearest voxel. */
  Cell
  cell(const Eigen::Vector3f& position) const
  {
    const Eigen::Array3f place = ((position - origin_) * inverse_voxel_size_).array();
    const Eigen::Array3f inside = place.max(0.0f).min(largest_coordinate_);
    // A little below the middle: where a line passes exactly between two voxels it then
    // goes through the lower one, however its step was rounded. The 63 roundings of a
    // line add up to less than this, and any other place is farther than 1 / 126 from a
    // border.
    constexpr Cell center = (Cell{1} << (fraction_bits - 1)) - 64;
    const auto field = [&](int axis, int bits) {
      const Cell voxel = static_cast<std::uint32_t>(inside[axis]);
      return ((voxel << fraction_bits) + center) << bits;
    };
    return field(0, 42) | field(1, 21) | field(2, 0);
  }

  /** \brief A line from voxel to voxel. */
  struct Line {
    Cell start;
    Cell step;
    int steps; ///< one less than the voxels it meets
  };

  /** \brief The line between the centres of two voxels.
   *
   * Steps along the axis on which the line is longest, one voxel per step (as ESF
   * does).
   */
  Line
  lineBetween(Cell from, Cell to) const
  {
    const int dx = coordinate(to, 2) - coordinate(from, 2);
    const int dy = coordinate(to, 1) - coordinate(from, 1);
    const int dz = coordinate(to, 0) - coordinate(from, 0);
    const int steps = std::max(std::abs(dx), std::max(std::abs(dy), std::abs(dz)));
    const int scale = reciprocals_[steps];
    // A negative step borrows from the field above it; each sum is whole again.
    const Cell step = (static_cast<Cell>(fraction(dx, scale)) << 42) +
                      (static_cast<Cell>(fraction(dy, scale)) << 21) +
                      static_cast<Cell>(fraction(dz, scale));
    return {from, step, steps};
  }

  /** \brief N_occ of Eq. (5.8): occupied voxels on a line, both ends included. */
  unsigned int
  countOccupied(const Line& line) const
  {
    unsigned int occupied = 0;
    Cell place = line.start;
    for (int k = 0; k <= line.steps; ++k, place += line.step)
      occupied += (rows_[row(place)] >> column(place)) & 1u;
    return occupied;
  }

private:
  static constexpr int fraction_bits = 15;

  static std::size_t
  row(Cell cell)
  {
    return ((cell >> 51) & 0xFC0u) | ((cell >> 36) & 0x3Fu);
  }

  static unsigned int
  column(Cell cell)
  {
    return static_cast<unsigned int>(cell >> fraction_bits) & 63u;
  }

  static int
  coordinate(Cell cell, int field)
  {
    return static_cast<int>(cell >> (21 * field + fraction_bits)) & 63;
  }

  /** \brief delta / steps in fixed point, from delta and 2^30 / steps. */
  static std::int64_t
  fraction(int delta, int reciprocal)
  {
    return (static_cast<std::int64_t>(delta) * reciprocal) >> (30 - fraction_bits);
  }

  std::array<std::uint64_t, 64 * 64> rows_{};
  std::array<int, 64> reciprocals_{};
  Eigen::Vector3f origin_;
  float inverse_voxel_size_ = 0.0f;
  float largest_coordinate_ = 0.0f;
};

} // namespace pcl::indoor
