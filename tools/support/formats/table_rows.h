/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/table_columns.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What separates the words of a line: ';' or ',' if it holds one, else ' ' for
 * blanks and tabs. */
char
separatorOf(std::string_view line);

/** \brief The words of a line, without quotes; a separator at its end separates
 * nothing. */
void
splitLine(std::string_view line, char separator, std::vector<std::string_view>& words);

/** \brief The value of a word; nan and inf are values, too.
 * \return whether all of it is a number
 */
bool
readNumber(std::string_view word, double& value);

/** \brief The rows of a table, line by line. */
class TableRows {
public:
  TableRows(std::string path, const TableColumns& columns);

  /** \brief Take the next line, without its end.
   * \throws ToolError if it cannot be read */
  void
  add(std::string_view line);

  /** \brief Find out what is missing after the last line.
   * \throws ToolError if rows are missing */
  void
  finish();

  /** \brief What becomes of the columns. */
  const std::vector<TableColumn>&
  columns() const
  {
    return columns_;
  }

  /** \brief The values, row by row. */
  const std::vector<double>&
  values() const
  {
    return values_;
  }

  std::uint64_t
  count() const
  {
    return rows_;
  }

private:
  std::string
  place() const;

  [[noreturn]] void
  refuse(const std::string& problem) const;

  [[noreturn]] void
  refuseWord(std::string_view word) const;

  void
  readNames(std::string_view comment);

  bool
  readCount();

  void
  addFirstRow(std::string_view line);

  void
  addRow();

  std::string path_;
  std::vector<std::string> option_names_, header_names_, comment_names_;
  std::uint64_t line_ = 0, header_line_ = 0, comment_line_ = 0, rows_ = 0;
  std::uint64_t promised_ = 0;
  bool has_count_ = false, has_names_ = false, could_be_colors_ = true;
  char separator_ = ' ';
  std::vector<std::string_view> words_;
  std::vector<TableColumn> columns_; ///< empty before the first row
  std::vector<double> values_;
};

} // namespace pcl::indoor::tool
