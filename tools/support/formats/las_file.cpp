/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: ASPRS, LAS Specification 1.4, R15.
#include "formats/las_file.h"

#include "command_line/options.h" // for ToolError
#include "formats/file_header.h"  // for throwTruncated

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <vector>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t smallest_header = 227; // of LAS 1.0 to 1.2
constexpr std::size_t record_header = 54;    // of variable length records
constexpr std::size_t extra_description = 192;

/** A number at a place of the file, which is little-endian as this machine is. */
template <typename T>
T
numberAt(const char* bytes)
{
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

/** Where a point format has what; 0 = nowhere. */
struct PointFormat {
  std::size_t size, classification, source, gps_time, colors;
};

constexpr std::array<PointFormat, 11> point_formats = {{{20, 15, 18, 0, 0},
                                                        {28, 15, 18, 20, 0},
                                                        {26, 15, 18, 0, 20},
                                                        {34, 15, 18, 20, 28},
                                                        {57, 15, 18, 20, 0},
                                                        {63, 15, 18, 20, 28},
                                                        {30, 16, 20, 22, 0},
                                                        {36, 16, 20, 22, 30},
                                                        {38, 16, 20, 22, 30},
                                                        {59, 16, 20, 22, 0},
                                                        {67, 16, 20, 22, 30}}};
constexpr std::size_t first_long_format = 6; // whose classes have 8 bits, not 5

struct LasHeader {
  std::size_t header_size = 0, body_begin = 0, records = 0, format = 0, step = 0;
  std::uint64_t points = 0;
  std::array<double, 3> scales{}, offsets{};
};

/** Nothing if it contradicts itself. */
std::optional<LasHeader>
parseHeader(const std::string& bytes)
{
  if (bytes.size() < smallest_header || bytes.compare(0, 4, "LASF") != 0)
    return {};
  LasHeader header;
  header.header_size = numberAt<std::uint16_t>(&bytes[94]);
  header.body_begin = numberAt<std::uint32_t>(&bytes[96]);
  header.records = numberAt<std::uint32_t>(&bytes[100]);
  header.format = numberAt<std::uint8_t>(&bytes[104]);
  header.step = numberAt<std::uint16_t>(&bytes[105]);
  header.points = numberAt<std::uint32_t>(&bytes[107]);
  constexpr std::size_t long_count = 247; // of version 1.4
  if (header.header_size >= long_count + 8 && bytes.size() >= long_count + 8 &&
      header.points == 0)
    header.points = numberAt<std::uint64_t>(&bytes[long_count]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.scales[axis] = numberAt<double>(&bytes[131 + 8 * axis]);
    header.offsets[axis] = numberAt<double>(&bytes[155 + 8 * axis]);
  }
  if (bytes[24] != 1 || header.header_size < smallest_header ||
      header.body_begin < header.header_size || header.format >= point_formats.size() ||
      header.step < point_formats[header.format].size)
    return {};
  return header;
}

/** A field of the cloud: where its bytes are in a point of the file, and how they are
 * copied. */
struct LasField {
  std::string name;
  std::uint8_t type; ///< of PCLPointField, of what is written
  std::size_t size;  ///< bytes that are written
  std::function<void(const char* point, char* target)> copy;
};

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

LasField
colorField(std::size_t at)
{
  return {"rgb", PCLPointField::FLOAT32, 4, [at](const char* point, char* target) {
            std::uint32_t rgb = 0;
            for (std::size_t channel = 0; channel < 3; ++channel)
              rgb = rgb << 8 | numberAt<std::uint16_t>(point + at + 2 * channel) >> 8;
            std::memcpy(target, &rgb, sizeof(rgb));
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
    return scaledField<std::uint64_t>(name, at, is_scaled ? scale : 1, offset);
  case 8:
    return scaledField<std::int64_t>(name, at, is_scaled ? scale : 1, offset);
  case 9:
    return field(float(), PCLPointField::FLOAT32);
  case 10:
    return field(double(), PCLPointField::FLOAT64);
  default:
    return {};
  }
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

/** The dimensions that the record of extra bytes describes, as far as points are long
 * enough. */
void
addExtraFields(const std::string& bytes,
               const LasHeader& header,
               std::vector<LasField>& fields)
{
  constexpr std::size_t type_sizes[] = {0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  std::size_t place = header.header_size;
  for (std::size_t r = 0; r < header.records; ++r) {
    if (place + record_header > header.body_begin)
      return;
    const std::string user(&bytes[place + 2], strnlen(&bytes[place + 2], 16));
    const auto id = numberAt<std::uint16_t>(&bytes[place + 18]);
    const std::size_t length = numberAt<std::uint16_t>(&bytes[place + 20]);
    place += record_header;
    if (place + length > header.body_begin)
      return;
    std::size_t at = point_formats[header.format].size;
    if (user == "LASF_Spec" && id == 4)
      for (std::size_t d = 0; d + extra_description <= length; d += extra_description) {
        const char* about = &bytes[place + d];
        const int type = static_cast<unsigned char>(about[2]);
        const int flags = static_cast<unsigned char>(about[3]);
        // without a type the flags are a number of bytes
        const std::size_t size = type == 0    ? static_cast<std::size_t>(flags)
                                 : type <= 10 ? type_sizes[type]
                                              : 0;
        if (at + size > header.step || (type != 0 && size == 0))
          return;
        const double scale = (flags & 8) != 0 ? numberAt<double>(about + 112) : 1;
        const double offset = (flags & 16) != 0 ? numberAt<double>(about + 136) : 0;
        const auto name = fieldName(about + 4);
        const bool is_taken =
            name.empty() || std::any_of(fields.begin(),
                                        fields.end(),
                                        [&](const auto& f) { return f.name == name; });
        const auto field = extraField(name, type, at, (flags & 24) != 0, scale, offset);
        if (field && !is_taken)
          fields.push_back(*field);
        at += size;
      }
    place += length;
  }
}

std::vector<LasField>
fieldsOf(const std::string& bytes, const LasHeader& header)
{
  const auto& format = point_formats[header.format];
  std::vector<LasField> fields;
  const char* axes[] = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis)
    fields.push_back(scaledField<std::int32_t>(
        axes[axis], 4 * axis, header.scales[axis], header.offsets[axis]));
  fields.push_back(plainField<std::uint16_t>("intensity", PCLPointField::UINT16, 12));
  const std::uint8_t mask = header.format < first_long_format ? 0x1f : 0xff;
  const auto at = format.classification;
  fields.push_back({"classification",
                    PCLPointField::UINT8,
                    1,
                    [at, mask](const char* point, char* target) {
                      *target = static_cast<char>(point[at] & mask);
                    }});
  fields.push_back(plainField<std::uint16_t>(
      "point_source_id", PCLPointField::UINT16, format.source));
  if (format.gps_time > 0)
    fields.push_back(
        plainField<double>("gps_time", PCLPointField::FLOAT64, format.gps_time));
  if (format.colors > 0)
    fields.push_back(colorField(format.colors));
  addExtraFields(bytes, header, fields);
  return fields;
}

} // namespace

bool
isLas(const std::string& beginning)
{
  constexpr std::size_t format_place = 104; // whose highest bit says LAZ
  return beginning.compare(0, 4, "LASF") == 0 && beginning.size() > format_place &&
         (static_cast<unsigned char>(beginning[format_place]) & 0x80) == 0;
}

std::uint64_t
lasPointCount(const std::string& beginning)
{
  const auto header = parseHeader(beginning);
  return header ? header->points : 0;
}

LasRecords
lasRecords(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(512, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  const auto header = parseHeader(bytes);
  if (!header)
    throw ToolError(path + ": the header of this LAS file is damaged, or of a version "
                           "other than 1.0 to 1.4");
  stream.clear();
  stream.seekg(0, std::ios::end);
  const auto size = static_cast<std::uint64_t>(stream.tellg());
  if (header->body_begin > size)
    throwTruncated(path, header->body_begin, size, "bytes before its points");
  const std::uint64_t held = (size - header->body_begin) / header->step;
  if (held < header->points)
    throwTruncated(path, header->points, held, "points");
  if (header->points > 0x7fffffff)
    throw ToolError(path + ": more than 2^31 - 1 points");
  bytes.resize(header->body_begin);
  stream.seekg(0);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const auto fields = fieldsOf(bytes, *header);
  LasRecords records;
  records.body_begin = header->body_begin;
  records.record_size = header->step;
  records.copy = [fields](const char* record, char* point) {
    for (const auto& field : fields) {
      field.copy(record, point);
      point += field.size;
    }
  };
  auto& layout = records.layout;
  layout.width = static_cast<std::uint32_t>(header->points);
  layout.height = 1;
  for (const auto& field : fields) {
    PCLPointField about;
    about.name = field.name;
    about.offset = layout.point_step;
    about.datatype = field.type;
    about.count = 1;
    layout.fields.push_back(about);
    layout.point_step += static_cast<std::uint32_t>(field.size);
  }
  layout.row_step = layout.point_step * layout.width;
  return records;
}

PCLPointCloud2
readLas(const std::string& path)
{
  const auto records = lasRecords(path);
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  auto cloud = records.layout;
  if (bytes.size() < records.body_begin + records.record_size * cloud.width)
    throw ToolError(path + ": the file has become shorter");
  cloud.data.resize(static_cast<std::size_t>(cloud.point_step) * cloud.width);
  const char* record = bytes.data() + records.body_begin;
  auto* target = reinterpret_cast<char*>(cloud.data.data());
  for (std::uint32_t i = 0; i < cloud.width; ++i) {
    records.copy(record, target);
    record += records.record_size;
    target += cloud.point_step;
  }
  return cloud;
}

} // namespace pcl::indoor::tool
