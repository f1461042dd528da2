/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: ASPRS, LAS Specification 1.4, R15.
#include "formats/las/las_fields.h"

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t extra_description = 192;
constexpr std::size_t returns_place = 14;
constexpr std::size_t flags_place = 15; // beside a class of 5 bits, or of long formats

template <typename T>
LasField
plainField(const std::string& name, std::uint8_t type, std::size_t at)
{
  return {name, type, sizeof(T), [at](const char* point, char* target) {
            std::memcpy(target, point + at, sizeof(T));
          }};
}

template <typename T>
LasField
scaledField(const std::string& name, std::size_t at, double scale, double offset)
{
  return {name,
          PCLPointField::FLOAT64,
          sizeof(double),
          [=](const char* point, char* target) {
            const double value =
                static_cast<double>(numberAt<T>(point + at)) * scale + offset;
            std::memcpy(target, &value, sizeof(value));
          }};
}

/** Some bits of a byte. */
LasField
bitsField(const std::string& name, std::size_t at, unsigned shift, unsigned mask)
{
  return {name, PCLPointField::UINT8, 1, [=](const char* point, char* target) {
            const auto byte = static_cast<unsigned char>(point[at]);
            *target = static_cast<char>(byte >> shift & mask);
          }};
}

LasField
colorField(std::size_t at, const LasColors& colors)
{
  return {"rgb", PCLPointField::FLOAT32, 4, [=](const char* point, char* target) {
            std::array<std::uint16_t, 3> channels;
            std::memcpy(channels.data(), point + at, sizeof(channels));
            const auto most = *std::max_element(channels.begin(), channels.end());
            const unsigned shift = colors.are_mixed && most <= 255 ? 0 : colors.shift;
            std::uint32_t rgb = 0;
            for (const auto channel : channels)
              rgb = rgb << 8 | (channel >> shift & 0xff);
            std::memcpy(target, &rgb, sizeof(rgb));
          }};
}

/** The angle of the ray in degrees. */
LasField
angleField(bool is_long)
{
  return {"scan_angle",
          PCLPointField::FLOAT32,
          sizeof(float),
          [is_long](const char* point, char* target) {
            const float angle =
                is_long
                    ? 0.006f * static_cast<float>(numberAt<std::int16_t>(point + 18))
                    : static_cast<float>(numberAt<std::int8_t>(point + 16));
            std::memcpy(target, &angle, sizeof(angle));
          }};
}

/** One dimension of extra bytes; the type is a number of the specification. */
std::optional<LasField>
extraField(const std::string& name,
           int type,
           std::size_t at,
           bool is_scaled,
           double scale,
           double offset)
{
  const auto field = [&](auto value, std::uint8_t own) {
    using T = decltype(value);
    return is_scaled ? scaledField<T>(name, at, scale, offset)
                     : plainField<T>(name, own, at);
  };
  switch (type) {
  case 1:
    return field(std::uint8_t(), PCLPointField::UINT8);
  case 2:
    return field(std::int8_t(), PCLPointField::INT8);
  case 3:
    return field(std::uint16_t(), PCLPointField::UINT16);
  case 4:
    return field(std::int16_t(), PCLPointField::INT16);
  case 5:
    return field(std::uint32_t(), PCLPointField::UINT32);
  case 6:
    return field(std::int32_t(), PCLPointField::INT32);
  case 7:
    return scaledField<std::uint64_t>(name, at, scale, offset);
  case 8:
    return scaledField<std::int64_t>(name, at, scale, offset);
  case 9:
    return field(float(), PCLPointField::FLOAT32);
  case 10:
    return field(double(), PCLPointField::FLOAT64);
  default:
    return {};
  }
}

/** The bytes of a dimension; 0 if its type is not known. Those without a type have
 * flags for it, and older ones have up to three values. */
std::size_t
extraSize(int type, int flags)
{
  constexpr int types = 10;
  constexpr std::size_t sizes[] = {8, 1, 1, 2, 2, 4, 4, 8, 8, 4};
  if (type == 0)
    return static_cast<std::size_t>(flags);
  return type > 3 * types
             ? 0
             : sizes[type % types] * static_cast<std::size_t>((type - 1) / types + 1);
}

/** A name that a PCD header can hold. */
std::string
fieldName(const char* text)
{
  std::string name(text, strnlen(text, 32));
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0)
      letter = '_';
  return name;
}

/** The dimension that a description tells, unless there is a field of its name. */
void
addExtraField(const char* about, std::size_t at, std::vector<LasField>& fields)
{
  const int type = static_cast<unsigned char>(about[2]);
  const int flags = static_cast<unsigned char>(about[3]);
  const double scale = (flags & 8) != 0 ? numberAt<double>(about + 112) : 1;
  const double offset = (flags & 16) != 0 ? numberAt<double>(about + 136) : 0;
  const auto name = fieldName(about + 4);
  const bool is_taken =
      name.empty() || std::any_of(fields.begin(), fields.end(), [&](const auto& field) {
        return field.name == name;
      });
  const auto field = extraField(name, type, at, (flags & 24) != 0, scale, offset);
  if (field && !is_taken)
    fields.push_back(*field);
}

/** The dimensions that the record of extra bytes describes, as far as points are long
 * enough.
 * \param[in,out] notes one is added if they are not */
void
addExtraFields(const std::string& bytes,
               const LasHeader& header,
               std::vector<LasField>& fields,
               std::vector<std::string>& notes)
{
  const auto record = lasRecord(bytes, header, "LASF_Spec", 4); // there is one
  std::size_t at = header.places().size;
  for (std::size_t d = 0; d + extra_description <= record.size();
       d += extra_description) {
    const char* about = &record[d];
    const int type = static_cast<unsigned char>(about[2]);
    const int flags = static_cast<unsigned char>(about[3]);
    const auto size = extraSize(type, flags);
    if (at + size > header.step) {
      notes.push_back("it describes more extra bytes than its points have: from '" +
                      fieldName(about + 4) + "' on they are left out");
      return;
    }
    if (size == 0)
      return;
    addExtraField(about, at, fields);
    at += size;
  }
}

/** Returns, flags and angle of the ray. */
void
addRayFields(const LasHeader& header, std::vector<LasField>& fields)
{
  const bool is_long = header.isLong();
  const auto bits =
      [&](const char* name, std::size_t at, unsigned shift, unsigned mask) {
        fields.push_back(bitsField(name, at, shift, mask));
      };
  const unsigned most_returns = is_long ? 15 : 7;
  bits("return_number", returns_place, 0, most_returns);
  bits("number_of_returns", returns_place, is_long ? 4 : 3, most_returns);
  bits("scan_direction_flag", is_long ? flags_place : returns_place, 6, 1);
  bits("edge_of_flight_line", is_long ? flags_place : returns_place, 7, 1);
  bits("classification_flags", flags_place, is_long ? 0 : 5, is_long ? 15 : 7);
  if (is_long)
    bits("scanner_channel", flags_place, 4, 3);
  bits("user_data", 17, 0, 0xff);
  fields.push_back(angleField(is_long));
}

void
addColorFields(std::size_t at, const LasColors& colors, std::vector<LasField>& fields)
{
  fields.push_back(colorField(at, colors));
  if (colors.are_fine)
    for (const char* name : {"red_16", "green_16", "blue_16"}) {
      fields.push_back(plainField<std::uint16_t>(name, PCLPointField::UINT16, at));
      at += sizeof(std::uint16_t);
    }
}

} // namespace

std::vector<LasField>
lasFields(const std::string& bytes,
          const LasHeader& header,
          const LasColors& colors,
          std::vector<std::string>& notes)
{
  const auto& format = header.places();
  std::vector<LasField> fields;
  const char* axes[] = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis)
    fields.push_back(scaledField<std::int32_t>(
        axes[axis], 4 * axis, header.scales[axis], header.offsets[axis]));
  fields.push_back(plainField<std::uint16_t>("intensity", PCLPointField::UINT16, 12));
  fields.push_back(bitsField(
      "classification", format.classification, 0, header.isLong() ? 0xff : 0x1f));
  fields.push_back(plainField<std::uint16_t>(
      "point_source_id", PCLPointField::UINT16, format.source));
  addRayFields(header, fields);
  if (format.gps_time > 0)
    fields.push_back(
        plainField<double>("gps_time", PCLPointField::FLOAT64, format.gps_time));
  if (format.colors > 0)
    addColorFields(format.colors, colors, fields);
  if (format.infrared > 0)
    fields.push_back(
        plainField<std::uint16_t>("nir", PCLPointField::UINT16, format.infrared));
  addExtraFields(bytes, header, fields, notes);
  return fields;
}

} // namespace pcl::indoor::tool
