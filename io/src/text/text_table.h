/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Rows of text with aligned columns, for a terminal. */
class PCL_INDOOR_EXPORTS TextTable {
public:
  /** \param[in] header one word per column; those that end in '>' have their cells on
   * the right, for numbers */
  explicit TextTable(const std::vector<std::string>& header);

  /** \brief Add a row with as many cells as the header; they are made printable. */
  void
  add(std::vector<std::string> row);

  /** \brief Header and rows, each with a line feed; two blanks between columns. */
  std::string
  text() const;

private:
  std::vector<bool> on_the_right_;
  std::vector<std::vector<std::string>> rows_; ///< the first is the header
};

} // namespace pcl::indoor::tool
