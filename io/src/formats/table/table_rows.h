/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/table/table_columns.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::indoor::tool {

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

  /** \brief The numbers of points of parts that follow each other, each behind its
   * number; none if there are no such lines. */
  const std::vector<std::uint64_t>&
  parts() const
  {
    return parts_;
  }

  /** \brief How the table was taken, see CloudFile::notes. */
  const std::vector<std::string>&
  notes() const
  {
    return notes_;
  }

private:
  struct Header {
    std::vector<std::string> names;
    std::uint64_t line = 0;
  };

  std::string
  place(std::uint64_t line) const;

  [[noreturn]] void
  refuse(const std::string& problem) const;

  [[noreturn]] void
  refuseWord(std::string_view word) const;

  [[noreturn]] void
  refusePlace(const Header& header, const std::vector<bool>& are_numbers) const;

  std::string
  withoutControls(std::string_view line);

  bool
  readCount();

  void
  addBeforeRows(std::string_view line);

  void
  addText();

  void
  chooseColumns();

  void
  takeOption();

  void
  takeHeader(Header header);

  void
  requireAsMany(std::size_t count, const std::string& what) const;

  double
  numberOf(std::size_t column);

  bool
  readWord(std::string_view word, double& value);

  void
  requireFitting(const TableColumn& column, std::string_view word, double value) const;

  void
  addRow();

  void
  makeNotes(const std::string& scaled);

  std::string path_;
  std::vector<std::string> option_names_, left_out_, units_, notes_;
  Header header_, comment_;
  std::uint64_t line_ = 0, rows_ = 0, promised_ = 0;
  std::uint64_t damaged_lines_ = 0, first_damaged_line_ = 0;
  std::uint64_t fraction_line_ = 0; ///< first with a whole number such as 05
  std::vector<std::uint64_t> parts_;
  bool has_count_ = false, has_names_ = false, are_names_plain_ = true;
  char separator_ = ' ';
  char decimal_ = '\0'; ///< until a decimal was seen
  std::vector<std::string_view> words_;
  std::vector<TableColumn> columns_; ///< empty before the first row
  std::vector<double> values_;
};

} // namespace pcl::indoor::tool
