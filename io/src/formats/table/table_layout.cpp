/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/table/table_layout.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::indoor::tool {
namespace {

using Kind = TableColumn::Kind;

constexpr std::size_t enough_rows = 10; // to tell what a column counts

/** Three columns of a table, by their places in a row. */
struct Triple {
  const std::vector<double>& values;
  std::size_t width;
  std::size_t places[3];

  std::size_t
  rows() const
  {
    return values.size() / width;
  }

  double
  at(std::size_t row, std::size_t k) const
  {
    return values[row * width + places[k]];
  }
};

bool
areNormals(const Triple& triple)
{
  constexpr double tolerance = 0.05;  // of their length, as if rounded to two digits
  constexpr double nearly_all = 0.95; // some points of every scan have none
  std::size_t count = 0;
  for (std::size_t row = 0; row < triple.rows(); ++row)
    count +=
        std::abs(std::hypot(triple.at(row, 0), triple.at(row, 1), triple.at(row, 2)) -
                 1.0) <= tolerance;
  return static_cast<double>(count) >= nearly_all * static_cast<double>(triple.rows());
}

enum class ColorRange { None, Fractions, Bytes, Words };

/** \param[in] are_named so that one of 0 to 255 may be a fraction, too */
ColorRange
colorRange(const Triple& triple, bool are_named)
{
  double largest = 0;
  bool are_whole = true;
  for (std::size_t row = 0; row < triple.rows(); ++row)
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = triple.at(row, k);
      if (!(value >= 0 && value <= 65535))
        return ColorRange::None;
      largest = std::max(largest, value);
      are_whole = are_whole && value == std::floor(value);
    }
  if (largest <= 1 && !are_whole)
    return ColorRange::Fractions;
  if (!are_whole && !are_named)
    return ColorRange::None;
  return largest <= 255 ? ColorRange::Bytes : ColorRange::Words;
}

/** n: normals, c: colours, i: intensity, _: unknown; the first that fits holds. */
const std::map<std::size_t, std::vector<std::string>> layouts = {
    {1, {"i"}},
    {3, {"nnn", "ccc"}},
    {4, {"innn", "nnn_", "iccc", "ccci"}},
    {6, {"nnnccc", "cccnnn"}},
    {7, {"innnccc", "icccnnn", "nnnccci", "cccnnni"}}};

/** What follows x, y and z.
 * \param[in] places of these columns in a row */
std::string
layoutOf(const std::vector<double>& values,
         std::size_t width,
         const std::vector<std::size_t>& places)
{
  const auto fits = [&](const std::string& layout, ColorRange widest) {
    for (std::size_t k = 0; k < layout.size(); k += layout[k] == 'i' ? 1 : 3) {
      if (layout[k] == 'i' || layout[k] == '_')
        continue;
      const Triple triple{values, width, {places[k], places[k + 1], places[k + 2]}};
      if (layout[k] == 'n' && !areNormals(triple))
        return false;
      const auto range = colorRange(triple, false);
      if (layout[k] == 'c' && (range == ColorRange::None || range > widest))
        return false;
    }
    return true;
  };
  const auto known = layouts.find(places.size());
  if (known != layouts.end())
    for (const auto widest : {ColorRange::Bytes, ColorRange::Words})
      for (const auto& layout : known->second)
        if (fits(layout, widest))
          return layout;
  return std::string(places.size(), '_');
}

/** Is each value by one larger than that above? Ten rows are enough to be sure. */
bool
countsRows(const std::vector<double>& values, std::size_t width, std::size_t place)
{
  for (std::size_t at = place + width; at < values.size(); at += width)
    if (values[at] != values[at - width] + 1 || values[at] != std::floor(values[at]))
      return false;
  return values.size() >= enough_rows * width;
}

/** Does a column rise and never fall, as times do? */
bool
onlyRises(const std::vector<double>& values, std::size_t width, std::size_t place)
{
  for (std::size_t at = place + width; at < values.size(); at += width)
    if (!(values[at] >= values[at - width]))
      return false;
  return values.size() >= enough_rows * width &&
         values[values.size() - width + place] > values[place];
}

/** Seconds since 1970 or 1980 are larger than coordinates, those of the Earth, too. */
bool
isClock(const std::vector<double>& values, std::size_t width, std::size_t place)
{
  constexpr double largest_coordinate = 1e8;
  return onlyRises(values, width, place) && values[place] > largest_coordinate;
}

/** How many columns of whole numbers stand before coordinates with fractions: numbers
 * of scans, rows and columns of a scanner, colours. Three of them are coordinates, such
 * as millimetres, where normals or colours of 0 to 1 follow. */
std::size_t
wholeColumnsBefore(const std::vector<double>& values,
                   std::size_t width,
                   const std::vector<std::size_t>& places)
{
  const auto isWholeColumn = [&](std::size_t place) {
    for (std::size_t at = place; at < values.size(); at += width)
      if (values[at] != std::floor(values[at]))
        return false;
    return true;
  };
  std::size_t count = 0;
  while (count + 3 < places.size() && isWholeColumn(places[count]))
    ++count;
  if (count == 0 || values.size() < enough_rows * width)
    return 0;
  const Triple next{
      values, width, {places[count], places[count + 1], places[count + 2]}};
  const bool are_places = std::none_of(next.places, next.places + 3, isWholeColumn) &&
                          !areNormals(next) &&
                          colorRange(next, false) != ColorRange::Fractions;
  return are_places ? count : 0;
}

} // namespace

std::vector<TableColumn>
columnsByValues(const std::vector<TableColumn>& columns,
                const std::vector<double>& values)
{
  const auto width = columns.size();
  std::vector<std::size_t> places;
  for (std::size_t c = 0; c < width; ++c)
    if (columns[c].kind != Kind::Skipped)
      places.push_back(c);
  auto result = columns;
  if (places.size() > 3 &&
      (countsRows(values, width, places[0]) || isClock(values, width, places[0]))) {
    result[places[0]].kind = Kind::Skipped;
    places.erase(places.begin());
  }
  const auto before = wholeColumnsBefore(values, width, places);
  for (std::size_t k = 0; k < before; ++k)
    result[places[k]].kind = Kind::Skipped;
  places.erase(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(before));
  for (std::size_t axis = 0; axis < 3; ++axis)
    result[places[axis]] = {std::string(1, static_cast<char>('x' + axis)),
                            Kind::Coordinate};
  places.erase(places.begin(), places.begin() + 3);
  const auto layout = layoutOf(values, width, places);
  const std::string colors = "rgb";
  for (std::size_t k = 0, normal = 0, color = 0; k < places.size(); ++k)
    result[places[k]] =
        layout[k] == 'n'
            ? TableColumn{"normal_" + std::string(1, "xyz"[normal++]), Kind::Real}
        : layout[k] == 'c' ? TableColumn{std::string(1, colors[color++]), Kind::Color}
        : layout[k] == 'i' ? TableColumn{"intensity", Kind::Real}
                           : TableColumn{numberedName(places[k]), Kind::Real};
  return result;
}

bool
isFirstLikeTime(const std::vector<TableColumn>& columns,
                const std::vector<double>& values)
{
  return columns.size() > 3 && columns[0].kind == Kind::Coordinate &&
         columns[3].kind == Kind::Real && columns[3].field != "normal_x" &&
         onlyRises(values, columns.size(), 0);
}

std::string
scaleColors(const std::vector<TableColumn>& columns, std::vector<double>& values)
{
  Triple triple{values, columns.size(), {0, 0, 0}};
  std::size_t channels = 0;
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].kind == Kind::Color && channels < 3)
      triple.places[channels++] = c;
  if (channels < 3)
    return "";
  const auto range = colorRange(triple, true);
  for (std::size_t row = 0; row < triple.rows(); ++row)
    for (const auto place : triple.places) {
      double& value = values[row * columns.size() + place];
      value = range == ColorRange::Fractions ? std::round(255 * value)
              : range == ColorRange::Words   ? std::floor(value / 256)
                                             : std::round(value);
    }
  return range == ColorRange::Fractions ? "colours of 0 to 1"
         : range == ColorRange::Words   ? "colours of 0 to 65535"
                                        : "";
}

} // namespace pcl::indoor::tool
