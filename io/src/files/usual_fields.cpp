/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/usual_fields.h"

#include "files/cloud_file.h"
#include "files/cloud_sample.h" // for sampleBlocks
#include "files/field_value.h"
#include "files/tool_error.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace pcl::indoor::tool {
namespace {

using Names = std::vector<std::string>;

bool
isReal(std::uint8_t type)
{
  return type == PCLPointField::FLOAT32 || type == PCLPointField::FLOAT64;
}

/** Bytes of a point that stay as they are, those that follow each other together. */
class Spans {
public:
  void
  add(std::size_t from, std::size_t to, std::size_t size)
  {
    if (!spans_.empty() && spans_.back().from + spans_.back().size == from &&
        spans_.back().to + spans_.back().size == to)
      spans_.back().size += size;
    else
      spans_.push_back({from, to, size});
  }

  void
  copy(const PCLPointCloud2& from, PCLPointCloud2& to) const
  {
    const auto count = static_cast<std::size_t>(from.width) * from.height;
    for (std::size_t i = 0; i < count; ++i)
      for (const auto& span : spans_)
        std::memcpy(&to.data[i * to.point_step + span.to],
                    &from.data[i * from.point_step + span.from],
                    span.size);
  }

private:
  struct Span {
    std::size_t from, to, size;
  };
  std::vector<Span> spans_;
};

/** What a value of a colour is to be multiplied by to fit a byte; 0: it is no colour.
 * Real numbers mostly are from 0 to 1; whole ones of 16 bits may hold only 8. */
double
scaleOf(const std::vector<PCLPointField>& channels, const PCLPointCloud2& points)
{
  double highest = 0.0;
  bool is_color = true;
  const auto look = [&](std::uint64_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i)
      for (const auto& channel : channels) {
        const auto* at = &points.data[i * points.point_step + channel.offset];
        const double value = valueAt(at, channel.datatype);
        is_color &= !(value < 0.0);
        highest = std::isfinite(value) ? std::max(highest, value) : highest;
      }
  };
  sampleBlocks(static_cast<std::uint64_t>(points.width) * points.height, look);
  if (!is_color || highest > 65535.0)
    return 0.0;
  return highest > 255.0                                       ? 1.0 / 256.0
         : highest > 1.0 || !isReal(channels.front().datatype) ? 1.0
                                                               : 255.0;
}

std::string
rangeText(double scale)
{
  return scale == 255.0 ? "from 0 to 1" : scale == 1.0 ? "from 0 to 255" : "of 16 bits";
}

/** The fields of these names in letters of any size, or none if one is missing. */
template <typename Parts>
std::vector<std::size_t>
fieldsNamed(const Parts& parts, const Names& wanted)
{
  std::vector<std::size_t> found;
  for (const auto& name : wanted) {
    const auto is_it = [&](bool exactly) {
      return std::find_if(parts.begin(), parts.end(), [&](const auto& part) {
        return part.field.count == 1 &&
               (exactly ? part.field.name
                        : boost::algorithm::to_lower_copy(part.field.name)) == name;
      });
    };
    auto it = is_it(true);
    it = it == parts.end() ? is_it(false) : it;
    if (it == parts.end())
      return {};
    found.push_back(static_cast<std::size_t>(it - parts.begin()));
  }
  return found;
}

template <typename Parts>
Names
namesOf(const Parts& parts, const std::vector<std::size_t>& fields)
{
  Names names;
  for (const auto index : fields)
    names.push_back(parts[index].field.name);
  return names;
}

} // namespace

UsualFields::UsualFields(const PCLPointCloud2& layout,
                         const std::function<const PCLPointCloud2&()>& points)
{
  for (const auto& field : layout.fields)
    parts_.push_back({field, {field}, 0.0});
  nameAxes();
  nameNormals();
  nameColors(points);
  if (only_names_)
    return;
  std::uint32_t offset = 0;
  for (auto& part : parts_) {
    part.field.offset = offset;
    offset += static_cast<std::uint32_t>(byteCount(part.field));
  }
}

void
UsualFields::nameAxes()
{
  const Names axes = {"x", "y", "z"};
  const auto found = fieldsNamed(parts_, axes);
  if (found.empty())
    return;
  const auto names = namesOf(parts_, found);
  bool are_whole = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto& field = parts_[found[axis]].field;
    field.name = axes[axis];
    if (isReal(field.datatype))
      continue;
    field.datatype = PCLPointField::FLOAT64;
    only_names_ = false;
    are_whole = true;
  }
  if (names != axes)
    notes_.push_back("its fields " + boost::algorithm::join(names, ", ") +
                     " are taken as x, y, z");
  if (are_whole)
    notes_.emplace_back("its coordinates are whole numbers, they are read as doubles");
}

void
UsualFields::nameNormals()
{
  const Names usual = {"normal_x", "normal_y", "normal_z"};
  for (const Names& wanted :
       {usual, Names{"nx", "ny", "nz"}, Names{"normalx", "normaly", "normalz"}}) {
    const auto found = fieldsNamed(parts_, wanted);
    if (found.empty())
      continue;
    const auto names = namesOf(parts_, found);
    if (names != usual && names != Names{"nx", "ny", "nz"}) // as PLY has them
      notes_.push_back("its fields " + boost::algorithm::join(names, ", ") +
                       " are taken as normals");
    for (std::size_t axis = 0; axis < 3; ++axis)
      parts_[found[axis]].field.name = usual[axis];
    return;
  }
  for (auto& part : parts_) // not all three
    for (const char axis : {'x', 'y', 'z'})
      if (part.field.name == std::string("n") + axis)
        part.field.name = std::string("normal_") + axis;
}

void
UsualFields::nameColors(const std::function<const PCLPointCloud2&()>& points)
{
  for (const char* name : {"rgb", "rgba"})
    if (const auto packed = fieldsNamed(parts_, {name}); !packed.empty()) {
      parts_[packed[0]].field.name = name;
      return;
    }
  for (const std::array<std::string, 4>& wanted :
       {std::array<std::string, 4>{"blue", "green", "red", "alpha"},
        {"diffuse_blue", "diffuse_green", "diffuse_red", "diffuse_alpha"},
        {"b", "g", "r", "a"}}) {
    auto colors = fieldsNamed(parts_, {wanted[0], wanted[1], wanted[2]});
    if (colors.empty())
      continue;
    const auto type = parts_[colors[0]].field.datatype;
    if (std::any_of(colors.begin(), colors.end(), [&](std::size_t color) {
          return parts_[color].field.datatype != type;
        }))
      return;
    auto names = namesOf(parts_, colors);
    std::reverse(names.begin(), names.end());
    if (type != PCLPointField::UINT8)
      return addColors(colors, boost::algorithm::join(names, ", "), points());
    const auto alpha = fieldsNamed(parts_, {wanted[3]});
    if (!alpha.empty() && parts_[alpha[0]].field.datatype == type)
      colors.push_back(alpha[0]);
    return packColors(colors, boost::algorithm::join(names, ", "));
  }
}

void
UsualFields::packColors(const std::vector<std::size_t>& colors,
                        const std::string& names)
{
  Part packed;
  for (const auto color : colors)
    packed.from.push_back(parts_[color].field);
  packed.field.name = colors.size() == 4 ? "rgba" : "rgb";
  packed.field.datatype =
      colors.size() == 4 ? PCLPointField::UINT32 : PCLPointField::FLOAT32;
  packed.field.count = 1;
  packed.scale = 1.0;
  if (names != "red, green, blue") // as PLY has them
    notes_.push_back("its fields " + names + " are taken as colours, field rgb");
  const auto first = *std::min_element(colors.begin(), colors.end());
  parts_[first] = packed;
  auto others = colors;
  std::sort(others.rbegin(), others.rend());
  others.pop_back();
  for (const auto index : others)
    parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(index));
  only_names_ = false;
}

void
UsualFields::addColors(const std::vector<std::size_t>& colors,
                       const std::string& names,
                       const PCLPointCloud2& points)
{
  Part added;
  for (const auto color : colors)
    added.from.push_back(parts_[color].field);
  added.field.name = "rgb";
  added.field.datatype = PCLPointField::FLOAT32;
  added.field.count = 1;
  added.scale = scaleOf(added.from, points);
  if (added.scale == 0.0)
    return;
  notes_.push_back("its fields " + names + " (" + rangeText(added.scale) +
                   ") are taken as colours, too: field rgb");
  parts_.push_back(added);
  only_names_ = false;
}

PCLPointCloud2
UsualFields::of(PCLPointCloud2 cloud) const
{
  PCLPointCloud2 named;
  named.header = cloud.header;
  named.width = cloud.width;
  named.height = cloud.height;
  named.is_bigendian = cloud.is_bigendian;
  named.is_dense = cloud.is_dense;
  named.point_step = only_names_ ? cloud.point_step : 0;
  for (const auto& part : parts_) {
    named.fields.push_back(part.field);
    if (!only_names_)
      named.point_step += static_cast<std::uint32_t>(byteCount(part.field));
  }
  named.row_step = named.point_step * named.width;
  if (only_names_)
    named.data = std::move(cloud.data);
  else if (!cloud.data.empty()) {
    named.data.resize(static_cast<std::size_t>(named.width) * named.height *
                      named.point_step);
    Spans spans;
    for (const auto& part : parts_)
      if (const auto& first = part.from.front();
          part.scale == 0.0 && first.datatype == part.field.datatype)
        spans.add(first.offset, part.field.offset, byteCount(first));
      else if (first.datatype == PCLPointField::UINT8 && part.scale == 1.0)
        for (std::size_t k = 0; k < part.from.size(); ++k)
          spans.add(part.from[k].offset, part.field.offset + k, 1);
      else
        write(part, cloud, named);
    spans.copy(cloud, named);
  }
  return named;
}

void
UsualFields::write(const Part& part,
                   const PCLPointCloud2& from,
                   PCLPointCloud2& to) const
{
  const auto count = static_cast<std::size_t>(from.width) * from.height;
  const auto& first = part.from.front();
  const std::uint8_t* source = from.data.data();
  std::uint8_t* target = to.data.data() + part.field.offset;
  for (std::size_t i = 0; i < count;
       ++i, source += from.point_step, target += to.point_step) {
    if (part.scale == 0.0) { // a whole number
      const double value = valueAt(source + first.offset, first.datatype);
      std::memcpy(target, &value, sizeof(value));
      continue;
    }
    for (std::size_t k = 0; k < part.from.size(); ++k) {
      const auto& channel = part.from[k];
      const double value =
          part.scale * valueAt(source + channel.offset, channel.datatype);
      const double rounded = part.scale < 1.0 ? std::floor(value) : std::round(value);
      target[k] = // also of NaN
          static_cast<std::uint8_t>(rounded > 0.0 ? std::min(rounded, 255.0) : 0.0);
    }
  }
}

void
nameFields(CloudFile& file)
{
  auto& cloud = file.cloud;
  if (cloud.data.size() <
      static_cast<std::size_t>(cloud.width) * cloud.height * cloud.point_step)
    throw ToolError(file.path + ": the file is damaged, points are missing");
  const UsualFields fields(
      cloud, [&cloud]() -> const auto& { return cloud; });
  cloud = fields.of(std::move(cloud));
  file.notes.insert(file.notes.end(), fields.notes().begin(), fields.notes().end());
}

} // namespace pcl::indoor::tool
