/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Bins of undirected directions (Sec. 2.1.5.2), in several rotated copies.
 *
 * A direction and its opposite are one. A copy has rings of bins around a pole, all
 * bins of about the same size. Since a direction may lie at the border of a bin, the
 * other copies are turned by random rotations. Which bins a direction falls into is
 * looked up in a table whose cells are about eight times finer than a bin, so bins have
 * slightly ragged borders, and a look-up needs no trigonometry.
 */
class PCL_INDOOR_EXPORTS HoughAccumulator {
public:
  /** \param[in] bin_angle_degrees edge of a bin, 1 to 45
   * \param[in] rotations number of copies, 1 to 16; the first is not turned
   * \param[in] seed of the rotations
   * \throws pcl::BadArgumentException if a parameter is out of range
   */
  HoughAccumulator(double bin_angle_degrees, unsigned rotations, std::uint32_t seed);

  /** \brief Get the number of copies. */
  unsigned
  rotations() const
  {
    return rotations_;
  }

  /** \brief Get the number of bins of one copy, M. */
  unsigned
  binCount() const
  {
    return bin_count_;
  }

  /** \brief Find the bin of a direction in each copy.
   * \param[in] direction not zero, of any length
   * \return the numbers of rotations() bins, each from 0 to binCount() - 1
   */
  const std::uint16_t*
  bins(const Eigen::Vector3f& direction) const
  {
    // The hemisphere as a square: a pyramid over the plane, turned by 45 degrees.
    const float scale = (direction.z() < 0 ? -half_ : half_) / direction.lpNorm<1>();
    const float x = direction.x() * scale, y = direction.y() * scale;
    const auto column = static_cast<std::size_t>(half_ + x + y);
    const auto row = static_cast<std::size_t>(half_ + x - y);
    return &table_[(row * stride_ + column) * rotations_];
  }

private:
  unsigned rotations_;
  unsigned bin_count_ = 0;
  float half_ = 0;         // of the square's edge, cells
  std::size_t stride_ = 0; // cells per row: one more than the edge, for its border
  std::vector<std::uint16_t> table_;
};

} // namespace pcl::indoor
