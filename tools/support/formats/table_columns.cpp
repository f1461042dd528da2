/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/table_columns.h"

#include "command_line/options.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace pcl::indoor::tool {
namespace {

using Kind = TableColumn::Kind;

const std::map<std::string, TableColumn> known_names = {
    {"x", {"x", Kind::Coordinate}},
    {"y", {"y", Kind::Coordinate}},
    {"z", {"z", Kind::Coordinate}},
    {"r", {"r", Kind::Color}},
    {"g", {"g", Kind::Color}},
    {"b", {"b", Kind::Color}},
    {"red", {"r", Kind::Color}},
    {"green", {"g", Kind::Color}},
    {"blue", {"b", Kind::Color}},
    {"i", {"intensity", Kind::Real}},
    {"nx", {"normal_x", Kind::Real}},
    {"ny", {"normal_y", Kind::Real}},
    {"nz", {"normal_z", Kind::Real}},
    {"label", {"label", Kind::Label}},
    {"_", {"", Kind::Skipped}}};

/** Small letters and digits; what a PCD header cannot hold becomes a stroke. */
std::string
plainName(const std::string& name)
{
  std::string plain;
  for (const char letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    plain += std::isalnum(byte) != 0 ? static_cast<char>(std::tolower(byte)) : '_';
  }
  return plain;
}

std::string
numberedName(std::size_t column)
{
  return "column_" + std::to_string(column + 1);
}

bool
isPlaceOf(const TableColumn& column, const std::string& field)
{
  return column.kind != Kind::Skipped && column.field == field;
}

std::size_t
countOf(const std::vector<TableColumn>& columns, const std::string& field)
{
  return static_cast<std::size_t>(
      std::count_if(columns.begin(), columns.end(), [&](const auto& column) {
        return isPlaceOf(column, field);
      }));
}

/** A field once; colours all or none. Fields that this would break get numbers. */
void
numberTheRest(std::vector<TableColumn>& columns)
{
  const bool has_colors = countOf(columns, "r") == 1 && countOf(columns, "g") == 1 &&
                          countOf(columns, "b") == 1;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    auto& column = columns[c];
    if (column.kind == Kind::Color && !has_colors)
      column.kind = Kind::Real;
    const bool is_known = column.kind == Kind::Coordinate || column.kind == Kind::Color;
    const bool is_packed = column.field == "rgb" || column.field == "rgba";
    const bool is_again =
        std::any_of(columns.begin(), columns.begin() + c, [&](const auto& before) {
          return isPlaceOf(before, column.field);
        });
    if (!is_known && (column.field.empty() || is_packed || is_again))
      column.field = numberedName(c);
  }
}

} // namespace

void
TableColumns::addOption(OptionParser& parser)
{
  parser.text(
      "-columns",
      names,
      "columns of a table (XYZ, CSV, PTS), such as x,y,z,_,r,g,b, of which _ is "
      "left out; without, as its header says, or by their number");
}

std::vector<TableColumn>
columnsOf(const std::vector<std::string>& names, const std::string& where)
{
  std::vector<TableColumn> columns;
  for (const auto& name : names) {
    const auto plain = plainName(name);
    const auto known = known_names.find(plain);
    columns.push_back(known != known_names.end() ? known->second
                                                 : TableColumn{plain, Kind::Real});
  }
  for (const char* axis : {"x", "y", "z"})
    if (const auto count = countOf(columns, axis); count != 1)
      throw ToolError(where + (count == 0 ? " names no column '" : " names columns '") +
                      axis + (count == 0 ? "'" : "' twice"));
  numberTheRest(columns);
  return columns;
}

std::vector<TableColumn>
columnsByNumber(std::size_t count, bool colors)
{
  std::vector<std::string> names = {"x", "y", "z"};
  if (count == 4 || (count == 7 && colors))
    names.emplace_back("intensity");
  if (count == 6 && !colors)
    for (const char* name : {"normal_x", "normal_y", "normal_z"})
      names.emplace_back(name);
  if ((count == 6 || count == 7) && colors)
    for (const char* name : {"r", "g", "b"})
      names.emplace_back(name);
  while (names.size() < count)
    names.push_back(numberedName(names.size()));
  return columnsOf(names, "");
}

std::vector<std::string>
listedNames(const std::string& list)
{
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= list.size();) {
    const auto end = std::min(list.find(',', begin), list.size());
    names.push_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

} // namespace pcl::indoor::tool
