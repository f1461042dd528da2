/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** An upright section through a segment, in square cells: which of them hold points of
 * the sheet in the section, and which of the segment on either side. The first
 * coordinate is level, the second height.
 */
class SeamSection {
public:
  enum Part { Before, Behind, Sheet };

  /** REQUIRES: a box that is not empty, cell > 0. */
  SeamSection(const Eigen::AlignedBox2f& box, float cell);

  void
  add(Part part, const Eigen::Vector2f& place);

  /** Find the inside; call once, after all points. */
  void
  close();

  /** Whether neither side has points in the cell of a place, but both have some above
   * it or both below, and both before it or both behind. */
  bool
  isInside(const Eigen::Vector2f& place) const
  {
    return inside_[cellOf(place)] != 0;
  }

  /** Inside cells in which the sheet has points: filled. */
  std::size_t
  filled() const
  {
    return filled_;
  }

  /** Filled over all inside cells, from 0 to 1. */
  double
  cover() const;

  /** Mean place of the filled cells, in the coordinates of the points. */
  Eigen::Vector2f
  middle() const;

private:
  /** From where to where a part has points, in each row and column. */
  struct Outline {
    std::vector<int> first_column, last_column; // of each row
    std::vector<int> first_row, last_row;       // of each column
  };

  std::size_t
  cellOf(const Eigen::Vector2f& place) const;

  Outline
  outlineOf(Part side) const;

  bool
  holds(Part part, std::size_t cell) const
  {
    return (parts_[cell] & (1u << part)) != 0;
  }

  Eigen::Vector2f low_;
  float cell_;
  int columns_, rows_;
  std::vector<std::uint8_t> parts_; // one bit each
  std::vector<std::uint8_t> inside_;
  std::size_t filled_ = 0, enclosed_ = 0;
  Eigen::Vector2f filled_sum_ = Eigen::Vector2f::Zero();
};

} // namespace pcl::indoor
