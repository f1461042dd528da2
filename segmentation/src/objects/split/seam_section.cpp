/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/split/seam_section.h"

#include <algorithm>
#include <array>

namespace pcl::indoor {

SeamSection::SeamSection(const Eigen::AlignedBox2f& box, float cell)
: low_(box.min())
, cell_(cell)
, columns_(static_cast<int>(box.sizes().x() / cell) + 1)
, rows_(static_cast<int>(box.sizes().y() / cell) + 1)
, parts_(static_cast<std::size_t>(columns_) * rows_, 0)
, inside_(parts_.size(), 0)
{}

std::size_t
SeamSection::cellOf(const Eigen::Vector2f& place) const
{
  const Eigen::Vector2f cells = (place - low_) / cell_;
  const auto column = std::min(static_cast<int>(cells.x()), columns_ - 1);
  const auto row = std::min(static_cast<int>(cells.y()), rows_ - 1);
  return static_cast<std::size_t>(row) * columns_ + column;
}

void
SeamSection::add(Part part, const Eigen::Vector2f& place)
{
  parts_[cellOf(place)] |= static_cast<std::uint8_t>(1u << part);
}

SeamSection::Outline
SeamSection::outlineOf(Part side) const
{
  Outline outline;
  outline.first_column.assign(rows_, columns_);
  outline.last_column.assign(rows_, -1);
  outline.first_row.assign(columns_, rows_);
  outline.last_row.assign(columns_, -1);
  std::size_t cell = 0;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column, ++cell) {
      if (!holds(side, cell))
        continue;
      outline.first_column[row] = std::min(outline.first_column[row], column);
      outline.last_column[row] = column;
      outline.first_row[column] = std::min(outline.first_row[column], row);
      outline.last_row[column] = row;
    }
  return outline;
}

void
SeamSection::close()
{
  const std::array<Outline, 2> sides{outlineOf(Before), outlineOf(Behind)};
  std::size_t cell = 0;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column, ++cell) {
      std::array<bool, 4> both{true, true, true, true};
      for (const auto& outline : sides) {
        both[0] &= outline.first_row[column] < row;
        both[1] &= outline.last_row[column] > row;
        both[2] &= outline.first_column[row] < column;
        both[3] &= outline.last_column[row] > column;
      }
      if (holds(Before, cell) || holds(Behind, cell) || !(both[0] || both[1]) ||
          !(both[2] || both[3]))
        continue;
      inside_[cell] = 1;
      ++enclosed_;
      if (!holds(Sheet, cell))
        continue;
      ++filled_;
      filled_sum_ += Eigen::Vector2f(static_cast<float>(column) + 0.5f,
                                     static_cast<float>(row) + 0.5f);
    }
}

double
SeamSection::cover() const
{
  return enclosed_ == 0 ? 0
                        : static_cast<double>(filled_) / static_cast<double>(enclosed_);
}

Eigen::Vector2f
SeamSection::middle() const
{
  const auto count = static_cast<float>(std::max<std::size_t>(filled_, 1));
  return low_ + filled_sum_ / count * cell_;
}

} // namespace pcl::indoor
