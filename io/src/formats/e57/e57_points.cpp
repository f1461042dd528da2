/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: ASTM E2807-11, section 8; normals: the libE57 extension "nor".
#include "formats/e57/e57_points.h"

#include "files/field_value.h" // for appendTo
#include "files/tool_error.h"
#include "formats/e57/e57_values.h"

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

namespace pcl::indoor::tool {
namespace {

using Kind = E57Field::Kind;

constexpr std::size_t points_at_once = 1024; // their values stay in the cache
constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

/** A value of a type, the nearest that it has; 0 for NaN. */
template <typename T>
T
nearest(double value)
{
  if constexpr (std::is_floating_point_v<T>)
    return static_cast<T>(value); // infinite where it is too large
  else {
    constexpr auto least = static_cast<double>(std::numeric_limits<T>::min());
    constexpr auto largest = static_cast<double>(std::numeric_limits<T>::max());
    return static_cast<T>(value >= largest ? largest : value > least ? value : least);
  }
}

/** Fields of the standard that have no name of two words here. */
const std::map<std::string, std::string> known_names = {
    {"rowIndex", "row"},
    {"columnIndex", "column"},
    {"returnIndex", "return_number"},
    {"returnCount", "number_of_returns"},
    {"timeStamp", "time"}};

/** The name of a field as a PCD has it: without the prefix of an extension, words
 * apart: point_source_id of las:pointSourceId. */
std::string
fieldName(const std::string& name)
{
  if (const auto found = known_names.find(name); found != known_names.end())
    return found->second;
  std::string text;
  for (const char letter : name.substr(name.find(':') + 1)) {
    const auto code = static_cast<unsigned char>(letter);
    if (std::isupper(code) != 0 && !text.empty())
      text += '_';
    text += std::isalnum(code) != 0 ? static_cast<char>(std::tolower(code)) : '_';
  }
  return text;
}

/** The limits of colours: as the scan tells them, else those of the values. */
E57Scan::Limits
limitsOf(const std::optional<E57Scan::Limits>& told, const E57Field& field)
{
  if (told)
    return *told;
  if (field.kind == Kind::Integer || field.kind == Kind::Scaled)
    return {static_cast<double>(field.minimum) * field.scale + field.offset,
            static_cast<double>(field.maximum) * field.scale + field.offset};
  return {0.0, 1.0};
}

} // namespace

E57Points::E57Points(const E57Scan& scan, const std::string& path)
: scan_(scan)
{
  layout_.width = static_cast<std::uint32_t>(scan.count);
  layout_.height = 1;
  addPlaces(path);
  addColors();
  addIntensity();
  addNormals();
  for (std::size_t f = 0; f < scan.fields.size(); ++f)
    if (std::count(used_.begin(), used_.end(), f) == 0)
      addOther(f);
  layout_.row_step = layout_.point_step * layout_.width;
  for (const auto f : used_)
    if (scan.fields[f].bits > 0)
      wanted_.push_back(f);
}

std::optional<std::size_t>
E57Points::find(const std::string& name) const
{
  const auto& fields = scan_.fields;
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const auto& field) {
    return field.name == name && field.kind != Kind::Other;
  });
  if (found == fields.end())
    return {};
  return static_cast<std::size_t>(found - fields.begin());
}

/** \return the place among the used ones */
std::size_t
E57Points::use(std::size_t field)
{
  used_.push_back(field);
  return used_.size() - 1;
}

/** \return none if not all are there */
std::vector<std::size_t>
E57Points::useAll(const std::vector<std::string>& names)
{
  std::vector<std::size_t> places;
  for (const auto& name : names)
    if (!find(name))
      return {};
  for (const auto& name : names)
    places.push_back(use(*find(name)));
  return places;
}

/** \return where in a point it is */
std::size_t
E57Points::append(const std::string& name, std::uint8_t type)
{
  return appendTo(layout_, name, type);
}

void
E57Points::addPlaces(const std::string& path)
{
  auto from = useAll({"cartesianX", "cartesianY", "cartesianZ"});
  const bool is_spherical = from.empty();
  if (is_spherical)
    from = useAll({"sphericalRange", "sphericalAzimuth", "sphericalElevation"});
  if (from.empty())
    throw ToolError(path + ": the points of '" + scan_.name +
                    "' have neither Cartesian nor spherical coordinates");
  is_at_station_ = is_spherical || (find("rowIndex") && find("columnIndex"));
  if (std::all_of(from.begin(), from.end(), [this](std::size_t place) {
        return scan_.fields[used_[place]].bits == 0;
      }))
    throw ToolError(path + ": the points of '" + scan_.name + "' are all one");
  flag_ = find(is_spherical ? "sphericalInvalidState" : "cartesianInvalidState");
  const auto flag = flag_ ? use(*flag_) : std::size_t{0};
  for (const char* axis : {"x", "y", "z"})
    append(axis, PCLPointField::FLOAT64);
  writes_.emplace_back([=, has_flag = flag_.has_value(), pose = scan_.pose, this](
                           const Values& values, std::size_t count, std::uint8_t* to) {
    const Eigen::Matrix3d turn = pose.linear();
    const Eigen::Vector3d shift = pose.translation();
    const double* const first = values[from[0]].data();
    const double* const second = values[from[1]].data();
    const double* const third = values[from[2]].data();
    const double* const flags = has_flag ? values[flag].data() : nullptr;
    for (std::size_t i = 0; i < count; ++i, to += layout_.point_step) {
      Eigen::Vector3d point(first[i], second[i], third[i]);
      if (is_spherical) {
        const double range = point.x(), azimuth = point.y(), elevation = point.z();
        point = range * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                        std::cos(elevation) * std::sin(azimuth),
                                        std::sin(elevation));
      }
      point = turn * point + shift;
      if (flags != nullptr && flags[i] != 0)
        point.setConstant(nowhere);
      std::memcpy(to, point.data(), 3 * sizeof(double));
    }
  });
}

/** Write to each point, from a place in it on, what a function makes of the values. */
template <typename ValueOf>
void
E57Points::writeEach(std::size_t at, const ValueOf& value_of)
{
  writes_.emplace_back([=](const Values& values, std::size_t count, std::uint8_t* to) {
    for (std::size_t i = 0; i < count; ++i, to += layout_.point_step) {
      const auto value = value_of(values, i);
      std::memcpy(to + at, &value, sizeof(value));
    }
  });
}

void
E57Points::addColors()
{
  const auto from = useAll({"colorRed", "colorGreen", "colorBlue"});
  if (from.empty())
    return;
  std::array<E57Scan::Limits, 3> limits;
  for (std::size_t c = 0; c < 3; ++c)
    limits[c] = limitsOf(scan_.colors[c], scan_.fields[used_[from[c]]]);
  writeEach(append("rgb", PCLPointField::FLOAT32),
            [=](const Values& values, std::size_t i) {
              std::uint32_t rgb = 0;
              for (std::size_t c = 0; c < 3; ++c) {
                const double share = (values[from[c]][i] - limits[c].least) /
                                     (limits[c].largest - limits[c].least);
                rgb = rgb << 8 | nearest<std::uint8_t>(256.0 * share);
              }
              return rgb;
            });
}

void
E57Points::addIntensity()
{
  const auto from = useAll({"intensity"});
  if (from.empty())
    return;
  const auto flag = useAll({"isIntensityInvalid"});
  writeEach(append("intensity", PCLPointField::FLOAT32),
            [=](const Values& values, std::size_t i) {
              const bool is_invalid = !flag.empty() && values[flag[0]][i] != 0;
              return static_cast<float>(is_invalid ? nowhere : values[from[0]][i]);
            });
}

void
E57Points::addNormals()
{
  const auto from = useAll({"nor:normalX", "nor:normalY", "nor:normalZ"});
  if (from.empty())
    return;
  const auto at = append("normal_x", PCLPointField::FLOAT32);
  append("normal_y", PCLPointField::FLOAT32);
  append("normal_z", PCLPointField::FLOAT32);
  const Eigen::Matrix3d turn = scan_.pose.linear();
  writeEach(at, [=](const Values& values, std::size_t i) {
    const Eigen::Vector3d normal(
        values[from[0]][i], values[from[1]][i], values[from[2]][i]);
    const Eigen::Vector3f turned = (turn * normal).cast<float>();
    return std::array<float, 3>{turned.x(), turned.y(), turned.z()};
  });
}

/** A field that stays as it is, with a type that has its values. */
void
E57Points::addOther(std::size_t field)
{
  const auto& [name, kind, bits, minimum, maximum, scale, offset] = scan_.fields[field];
  const auto own = fieldName(name);
  const bool is_flag = own.rfind("is_", 0) == 0 || own.find("invalid") != own.npos;
  const bool is_taken = std::any_of(layout_.fields.begin(),
                                    layout_.fields.end(),
                                    [&](const auto& f) { return f.name == own; });
  if (is_flag)
    return;
  if (kind == Kind::Other || own.empty() || is_taken ||
      (bits == 0 && known_names.count(name) == 0)) {
    left_out_.push_back(name);
    return;
  }
  constexpr double first_return = 1; // of LAS; here they count from 0
  const double added = name == "returnIndex" ? first_return : 0;
  if (kind == Kind::Single)
    addNumber<float>(field, own, PCLPointField::FLOAT32, added);
  else if (kind == Kind::Integer && minimum >= 0 && maximum < 0xffffffff)
    addNumber<std::uint32_t>(field, own, PCLPointField::UINT32, added);
  else if (kind == Kind::Integer &&
           minimum >= std::numeric_limits<std::int32_t>::min() &&
           maximum < std::numeric_limits<std::int32_t>::max())
    addNumber<std::int32_t>(field, own, PCLPointField::INT32, added);
  else
    addNumber<double>(field, own, PCLPointField::FLOAT64, added);
}

template <typename T>
void
E57Points::addNumber(std::size_t field,
                     const std::string& name,
                     std::uint8_t type,
                     double added)
{
  const auto from = use(field);
  writeEach(append(name, type), [=](const Values& values, std::size_t i) {
    return nearest<T>(values[from][i] + added);
  });
}

void
E57Points::convert(const std::vector<std::string>& streams,
                   std::uint64_t first,
                   std::size_t count,
                   std::uint8_t* points) const
{
  Values values(used_.size(), std::vector<double>(points_at_once));
  for (std::size_t done = 0; done < count; done += points_at_once) {
    const auto some = std::min(points_at_once, count - done);
    std::size_t stream = 0;
    for (std::size_t k = 0; k < used_.size(); ++k) {
      const auto& field = scan_.fields[used_[k]];
      static const std::string no_bytes(8, '\0');
      const auto& bytes = field.bits > 0 ? streams[stream++] : no_bytes;
      unpackE57Values(field,
                      bytes.data(),
                      first % 8 * field.bits % 8 + done * field.bits,
                      some,
                      values[k].data());
    }
    for (const auto& write : writes_)
      write(values, some, points + done * layout_.point_step);
  }
}

} // namespace pcl::indoor::tool
