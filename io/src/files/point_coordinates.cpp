/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/point_coordinates.h"

#include "files/field_value.h"
#include "formats/file_header.h" // for offsetText
#include "text/printable.h"

#include <cstdio>
#include <cstring>
#include <vector>

namespace pcl::indoor::tool {
namespace {

/** 0, 1, 2 for x, y, z; -1 for any other field. */
int
axisOf(const PCLPointField& field)
{
  return field.name.size() == 1 && field.name[0] >= 'x' && field.name[0] <= 'z'
             ? field.name[0] - 'x'
             : -1;
}

bool
hasDoubles(const PCLPointCloud2& cloud)
{
  for (const auto& field : cloud.fields)
    if (axisOf(field) >= 0 && field.datatype == PCLPointField::FLOAT64)
      return true;
  return false;
}

template <typename T>
void
store(double value, std::uint8_t* bytes)
{
  const T rounded = static_cast<T>(value);
  std::memcpy(bytes, &rounded, sizeof(rounded));
}

/** The cloud with x, y and z of another type, less \a shift. */
PCLPointCloud2
withCoordinates(const PCLPointCloud2& cloud,
                std::uint8_t datatype,
                const Eigen::Vector3d& shift)
{
  PCLPointCloud2 other;
  other.header = cloud.header;
  other.height = cloud.height;
  other.width = cloud.width;
  other.is_bigendian = cloud.is_bigendian;
  other.is_dense = cloud.is_dense;
  for (auto field : cloud.fields) {
    field.offset = other.point_step;
    if (axisOf(field) >= 0)
      field.datatype = datatype;
    other.point_step += static_cast<std::uint32_t>(byteCount(field));
    other.fields.push_back(field);
  }
  other.row_step = other.point_step * other.width;
  const auto point_count = static_cast<std::size_t>(cloud.width) * cloud.height;
  other.data.resize(point_count * other.point_step);
  for (std::size_t f = 0; f < cloud.fields.size(); ++f) {
    const auto& field = cloud.fields[f];
    const int axis = axisOf(field);
    const std::size_t size = byteCount(field);
    const auto* from = cloud.data.data() + field.offset;
    auto* to = other.data.data() + other.fields[f].offset;
    for (std::size_t i = 0; i < point_count;
         ++i, from += cloud.point_step, to += other.point_step) {
      if (axis < 0)
        std::memcpy(to, from, size);
      else if (datatype == PCLPointField::FLOAT64)
        store<double>(valueAt(from, field.datatype) - shift[axis], to);
      else
        store<float>(valueAt(from, field.datatype) - shift[axis], to);
    }
  }
  return other;
}

} // namespace

Eigen::Vector3d
PointCoordinates::offsetOf(const CloudFile& file) const
{
  if (doubles)
    return Eigen::Vector3d::Zero();
  return hasDoubles(file.cloud) ? file.offset : file.pose.offset;
}

void
PointCoordinates::apply(CloudFile& file, const std::string& output) const
{
  if (!doubles && !hasDoubles(file.cloud))
    return;
  const auto offset = offsetOf(file);
  const Eigen::Vector3d shift = offset - file.pose.offset;
  file.cloud = withCoordinates(
      file.cloud, doubles ? PCLPointField::FLOAT64 : PCLPointField::FLOAT32, shift);
  file.pose.origin.head<3>() =
      (file.pose.origin.head<3>().cast<double>() - shift).cast<float>();
  file.pose.offset = offset;
  if (doubles || output.empty())
    return;
  const std::string addend =
      offset.isZero(0.0) ? ""
                         : ", to which the " + offsetText(offset) + " has to be added";
  std::fprintf(stderr,
               "Note: %s: x, y, z are floats%s; -double writes doubles\n",
               printable(output).c_str(),
               addend.c_str());
}

} // namespace pcl::indoor::tool
