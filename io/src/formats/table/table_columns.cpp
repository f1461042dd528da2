/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/table/table_columns.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string_view>
#include <utility>

namespace pcl::indoor::tool {
namespace {

using Kind = TableColumn::Kind;

constexpr std::array<const char*, 3> axes = {"x", "y", "z"};

const std::map<std::string, TableColumn> known_names = {
    {"r", {"r", Kind::Color}},
    {"g", {"g", Kind::Color}},
    {"b", {"b", Kind::Color}},
    {"i", {"intensity", Kind::Real}},
    {"nx", {"normal_x", Kind::Real}},
    {"ny", {"normal_y", Kind::Real}},
    {"nz", {"normal_z", Kind::Real}},
    {"label", {"label", Kind::Label}},
    {"_", {"", Kind::Skipped}}};

/** Other words of these, small letters and digits alone. */
const std::map<std::string, std::string> other_words = {
    {"red", "r"},        {"green", "g"},        {"blue", "b"},
    {"rf", "r"},         {"gf", "g"},           {"bf", "b"}, // CloudCompare
    {"rot", "r"},        {"gruen", "g"},        {"grn", "g"},
    {"blau", "b"},       {"rouge", "r"},        {"vert", "g"},
    {"bleu", "b"},       {"rojo", "r"},         {"verde", "g"},
    {"azul", "b"},       {"rosso", "r"},        {"blu", "b"},
    {"colorred", "r"},   {"colorgreen", "g"},   {"colorblue", "b"}, // E57
    {"diffusered", "r"}, {"diffusegreen", "g"}, {"diffuseblue", "b"},
    {"normalx", "nx"},   {"normaly", "ny"},     {"normalz", "nz"},
    {"normalsx", "nx"},  {"normalsy", "ny"},    {"normalsz", "nz"}};

/** What exporters call x, y and z. */
const std::map<std::string, std::string> axis_words = {
    {"easting", "x"},    {"east", "x"},        {"e", "x"},           {"northing", "y"},
    {"north", "y"},      {"n", "y"},           {"elevation", "z"},   {"elev", "z"},
    {"height", "z"},     {"h", "z"},           {"altitude", "z"},    {"alt", "z"},
    {"up", "z"},         {"rechtswert", "x"},  {"hochwert", "y"},    {"hoehe", "z"},
    {"hhe", "z"}, // its umlaut is no letter

    {"ost", "x"},        {"est", "x"},         {"este", "x"},        {"oost", "x"},
    {"nord", "y"},       {"norte", "y"},       {"noord", "y"},       {"abscisse", "x"},
    {"ordonne", "y"}, // its accent is no letter, either

    {"hauteur", "z"},    {"cota", "z"},        {"quota", "z"},       {"hoogte", "z"},

    {"points0", "x"},    {"points1", "y"},                           // ParaView
    {"points2", "z"},    {"pointsmxyz0", "x"}, {"pointsmxyz1", "y"}, // VeloView
    {"pointsmxyz2", "z"}};

const std::map<std::string, std::string> unit_words = {{"m", "m"},
                                                       {"metre", "m"},
                                                       {"metres", "m"},
                                                       {"meter", "m"},
                                                       {"meters", "m"},
                                                       {"cm", "cm"},
                                                       {"centimetres", "cm"},
                                                       {"centimeters", "cm"},
                                                       {"mm", "mm"},
                                                       {"millimetres", "mm"},
                                                       {"millimeters", "mm"},
                                                       {"ft", "ft"},
                                                       {"foot", "ft"},
                                                       {"feet", "ft"},
                                                       {"usft", "ft"},
                                                       {"sft", "ft"},
                                                       {"ftus", "ft"},
                                                       {"ussurveyft", "ft"},
                                                       {"ussurveyfeet", "ft"},
                                                       {"ussurveyfoot", "ft"},
                                                       {"surveyfeet", "ft"},
                                                       {"in", "in"},
                                                       {"inch", "in"},
                                                       {"inches", "in"},
                                                       {"km", "km"},
                                                       {"yd", "yd"},
                                                       {"yards", "yd"},
                                                       {"deg", "deg"},
                                                       {"degrees", "deg"},
                                                       {"rad", "rad"}};

/** Small letters and digits; what a PCD header cannot hold becomes a stroke. */
std::string
plainName(const std::string& name)
{
  auto plain = boost::algorithm::to_lower_copy(name);
  for (char& letter : plain)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0)
      letter = '_';
  return plain;
}

/** Small letters and digits alone. */
std::string
keyOf(const std::string& name)
{
  auto key = plainName(name);
  key.erase(std::remove(key.begin(), key.end(), '_'), key.end());
  return key;
}

/** "x" of "Easting", "x_coordinate" or "pos_x"; empty if it is another name. */
std::string
axisOf(const std::string& name)
{
  auto key = keyOf(name);
  if (const auto word = axis_words.find(key); word != axis_words.end())
    return word->second;
  for (const char* more : {"koordinate",
                           "coordonne", // without its accent
                           "coordenada",
                           "coordinata",
                           "coordinaat",
                           "coordinates",
                           "coordinate",
                           "coord",
                           "position",
                           "pos",
                           "point",
                           "location",
                           "cartesian"})
    if (const auto at = key.find(more); at != key.npos) {
      key.erase(at, std::string_view(more).size());
      break;
    }
  return key.size() == 1 && key[0] >= 'x' && key[0] <= 'z' ? key : "";
}

/** A name without its unit: "X" and "ft" of "X (ft)" and "X_ft". */
struct NameAndUnit {
  std::string name, unit;
};

NameAndUnit
withoutUnit(const std::string& name)
{
  const auto bracket = name.find_first_of("[(");
  if (bracket != name.npos && bracket > 0) {
    const auto end = name.find_first_of("])", bracket);
    auto before = name.substr(0, bracket);
    before.erase(before.find_last_not_of(" \t_") + 1);
    if (!before.empty())
      return {before, name.substr(bracket + 1, end - bracket - 1)};
  }
  const auto stroke = name.find_last_of("_ /,");
  const auto before = name.substr(0, std::min(stroke, name.size()));
  if (stroke != name.npos && isUnit(name.substr(stroke + 1)) && !axisOf(before).empty())
    return {before, name.substr(stroke + 1)};
  return {name, ""};
}

TableColumn
columnOf(const std::string& name)
{
  const auto plain = plainName(name);
  const auto other = other_words.find(keyOf(name));
  const auto known =
      known_names.find(other != other_words.end() ? other->second : plain);
  return known != known_names.end() ? known->second : TableColumn{plain, Kind::Real};
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

std::string
numberedName(std::size_t column)
{
  return "column_" + std::to_string(column + 1);
}

bool
isUnit(const std::string& text)
{
  return unit_words.count(keyOf(text)) > 0;
}

NamedColumns
columnsOf(const std::vector<std::string>& names)
{
  NamedColumns result;
  auto& columns = result.columns;
  std::vector<NameAndUnit> parts;
  for (const auto& name : names) {
    parts.push_back(withoutUnit(name));
    columns.push_back(columnOf(parts.back().name));
  }
  for (const char* axis : axes) {
    const auto is_plain = [axis](const auto& part) {
      return plainName(part.name) == axis;
    };
    const bool has_plain = std::any_of(parts.begin(), parts.end(), is_plain);
    result.are_plain = result.are_plain && has_plain;
    for (std::size_t c = 0; c < parts.size(); ++c) {
      if (has_plain ? !is_plain(parts[c]) : axisOf(parts[c].name) != axis)
        continue;
      columns[c] = {axis, Kind::Coordinate};
      auto& units = result.units;
      const auto unit = unit_words.find(keyOf(parts[c].unit));
      if (unit != unit_words.end() &&
          std::find(units.begin(), units.end(), unit->second) == units.end())
        units.push_back(unit->second);
    }
  }
  numberTheRest(columns);
  return result;
}

std::string
placeProblem(const std::vector<TableColumn>& columns)
{
  for (const char* angle : {"latitude", "lat", "longitude", "lon", "long", "lng"})
    if (countOf(columns, angle) > 0 && countOf(columns, "x") == 0)
      return std::string(" names the column '") + angle +
             "': angles are no coordinates, project them first";
  for (const std::string axis : axes)
    if (const auto count = countOf(columns, axis); count != 1)
      return count == 0 ? " names no column '" + axis + "'"
                        : " names columns '" + axis + "' twice";
  return "";
}

std::string
columnsProposal(const std::vector<TableColumn>& columns,
                const std::vector<bool>& are_numbers)
{
  auto proposed = columns;
  std::vector<std::string> missing;
  for (const char* axis : axes) {
    if (countOf(columns, axis) == 0)
      missing.emplace_back(axis);
    bool is_there = false;
    for (auto& column : proposed)
      if (isPlaceOf(column, axis) && std::exchange(is_there, true))
        column = {"", Kind::Skipped};
  }
  auto next = missing.begin();
  for (std::size_t c = 0; c < proposed.size(); ++c) {
    const bool is_number = c >= are_numbers.size() || are_numbers[c];
    if (!is_number)
      proposed[c] = {"", Kind::Skipped};
    else if (proposed[c].kind == Kind::Real && next != missing.end())
      proposed[c] = {*next++, Kind::Coordinate};
  }
  return next == missing.end() ? listOf(proposed) : "";
}

std::string
listOf(const std::vector<TableColumn>& columns)
{
  std::vector<std::string> names;
  for (const auto& column : columns)
    names.push_back(column.kind == Kind::Skipped ? "_" : column.field);
  return boost::algorithm::join(names, ",");
}

std::string
unitNote(const std::vector<std::string>& units)
{
  if (units.empty() || units == std::vector<std::string>{"m"})
    return "";
  const auto names = boost::algorithm::join(units, " and ");
  if (units.size() > 1)
    return "its header names the units " + names +
           " for coordinates, which are taken as one: make them one";
  if (names == "km" || names == "yd" || names == "deg" || names == "rad")
    return "its header names the unit '" + names + "', which -unit does not know";
  return "its header names the unit of its coordinates: -unit " + names;
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
