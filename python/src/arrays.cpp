/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "arrays.h"

#include "files/field_value.h" // for appendTo

#include <pcl/io/input_error.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

namespace py = pybind11;

namespace pcl::indoor::python {
namespace {

std::string
shapeText(const py::array& array)
{
  return py::str(array.attr("shape")).cast<std::string>();
}

std::string
typeText(const py::array& array)
{
  return py::str(array.dtype()).cast<std::string>();
}

/** One array with a row per point. */
struct Rows {
  const char* bytes = nullptr;
  std::size_t count = 0, value_size = 0;
  py::ssize_t row_stride = 0, column_stride = 0;
};

Rows
rowsOf(const std::string& name,
       const py::array& array,
       bool is_legal,
       const char* types)
{
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw InputError(name + ": the shape is " + shapeText(array) +
                     ", it must be (N, 3)");
  if (!is_legal)
    throw InputError(name + ": the dtype is " + typeText(array) + ", it must be " +
                     types);
  Rows rows;
  rows.bytes = static_cast<const char*>(array.data());
  rows.count = static_cast<std::size_t>(array.shape(0));
  rows.value_size = static_cast<std::size_t>(array.itemsize());
  rows.row_stride = array.strides(0);
  rows.column_stride = array.strides(1);
  return rows;
}

Rows
realRows(const std::string& name, const py::array& array)
{
  return rowsOf(name,
                array,
                py::isinstance<py::array_t<float>>(array) ||
                    py::isinstance<py::array_t<double>>(array),
                "float32 or float64");
}

Rows
byteRows(const std::string& name, const py::array& array)
{
  return rowsOf(name, array, py::isinstance<py::array_t<std::uint8_t>>(array), "uint8");
}

void
requireAsMany(const std::string& name, const Rows& rows, const Rows& points)
{
  if (rows.count != points.count)
    throw InputError(name + ": there are " + std::to_string(rows.count) + " for " +
                     std::to_string(points.count) + " points");
}

/** Adds fields for the three columns.
 * \return where they begin in a point */
std::size_t
addFields(const char* const (&names)[3], const Rows& rows, PCLPointCloud2& cloud)
{
  const auto begin = cloud.point_step;
  const auto type = rows.value_size == sizeof(float) ? PCLPointField::FLOAT32
                                                     : PCLPointField::FLOAT64;
  for (const char* const name : names)
    tool::appendTo(cloud, name, type);
  return begin;
}

/** Copies with the size of a value known, so that no call is made for each. */
template <typename Real>
void
copyAs(const Rows& rows, std::size_t begin, PCLPointCloud2& cloud)
{
  auto* to = cloud.data.data() + begin;
  const char* row = rows.bytes;
  for (std::size_t i = 0; i < rows.count; ++i) {
    for (int k = 0; k < 3; ++k)
      std::memcpy(to + static_cast<std::size_t>(k) * sizeof(Real),
                  row + k * rows.column_stride,
                  sizeof(Real));
    to += cloud.point_step;
    row += rows.row_stride;
  }
}

void
copyReals(const Rows& rows, std::size_t begin, PCLPointCloud2& cloud)
{
  const auto value = static_cast<py::ssize_t>(rows.value_size);
  if (rows.column_stride == value && rows.row_stride == 3 * value &&
      cloud.point_step == 3 * rows.value_size)
    std::memcpy(cloud.data.data(), rows.bytes, cloud.data.size()); // as they lie
  else if (rows.value_size == sizeof(float))
    copyAs<float>(rows, begin, cloud);
  else
    copyAs<double>(rows, begin, cloud);
}

/** Colours as PCL has them: in the bits of a float. */
void
copyColors(const Rows& rows, std::size_t begin, PCLPointCloud2& cloud)
{
  auto* to = cloud.data.data() + begin;
  const char* row = rows.bytes;
  for (std::size_t i = 0; i < rows.count; ++i) {
    std::uint32_t bits = 0;
    for (int k = 0; k < 3; ++k)
      bits = bits << 8 | static_cast<std::uint8_t>(row[k * rows.column_stride]);
    std::memcpy(to, &bits, sizeof(bits));
    to += cloud.point_step;
    row += rows.row_stride;
  }
}

} // namespace

PCLPointCloud2
cloudOf(const ScanArrays& arrays)
{
  const auto points = realRows("points", arrays.points);
  if (points.count > std::numeric_limits<std::uint32_t>::max())
    throw InputError("points: more than 2^32 - 1 points");
  PCLPointCloud2 cloud;
  cloud.point_step = 0;
  const auto points_begin = addFields({"x", "y", "z"}, points, cloud);
  Rows normals, colors;
  std::size_t normals_begin = 0, colors_begin = 0;
  if (!arrays.normals.is_none()) {
    normals = realRows("point_normals", arrays.normals.cast<py::array>());
    requireAsMany("point_normals", normals, points);
    normals_begin = addFields({"normal_x", "normal_y", "normal_z"}, normals, cloud);
  }
  if (!arrays.colors.is_none()) {
    colors = byteRows("point_colors", arrays.colors.cast<py::array>());
    requireAsMany("point_colors", colors, points);
    colors_begin = tool::appendTo(cloud, "rgb", PCLPointField::FLOAT32);
  }
  cloud.width = static_cast<std::uint32_t>(points.count);
  cloud.height = 1;
  cloud.data.resize(points.count * cloud.point_step);
  cloud.row_step = static_cast<std::uint32_t>(cloud.data.size());
  const py::gil_scoped_release release;
  copyReals(points, points_begin, cloud);
  copyReals(normals, normals_begin, cloud);
  copyColors(colors, colors_begin, cloud);
  return cloud;
}

py::array
readOnly(py::array array)
{
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

} // namespace pcl::indoor::python
