/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "text/text_table.h"

#include "text/printable.h"

#include <algorithm>
#include <cassert>

namespace pcl::indoor::tool {
namespace {

/** How many letters a UTF-8 text has. */
std::size_t
widthOf(const std::string& text)
{
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

} // namespace

TextTable::TextTable(const std::vector<std::string>& header)
{
  std::vector<std::string> row;
  for (const auto& name : header) {
    on_the_right_.push_back(!name.empty() && name.back() == '>');
    row.push_back(on_the_right_.back() ? name.substr(0, name.size() - 1) : name);
  }
  rows_.push_back(std::move(row));
}

void
TextTable::add(std::vector<std::string> row)
{
  assert(row.size() == on_the_right_.size());
  for (auto& cell : row)
    cell = printable(cell);
  rows_.push_back(std::move(row));
}

std::string
TextTable::text() const
{
  std::vector<std::size_t> widths(on_the_right_.size(), 0);
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], widthOf(row[i]));
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(widths[i] - widthOf(row[i]), ' ');
      line +=
          (i > 0 ? "  " : "") + (on_the_right_[i] ? space + row[i] : row[i] + space);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

} // namespace pcl::indoor::tool
