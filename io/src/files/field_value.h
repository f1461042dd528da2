/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/common/io.h> // for getFieldSize
#include <pcl/PCLPointCloud2.h>
#include <pcl/PCLPointField.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

namespace pcl::indoor::tool {

/** \brief Bytes of a field in a point; a count of 0, by old converters, is 1. */
inline std::size_t
byteCount(const PCLPointField& field)
{
  return static_cast<std::size_t>(getFieldSize(field.datatype)) *
         std::max(field.count, 1u);
}

/** \brief Append a field to the layout of points that have no bytes yet.
 * \return where in a point it is */
inline std::size_t
appendTo(PCLPointCloud2& layout,
         const std::string& name,
         std::uint8_t datatype,
         std::uint32_t count = 1)
{
  PCLPointField field;
  field.name = name;
  field.offset = layout.point_step;
  field.datatype = datatype;
  field.count = count;
  layout.point_step += static_cast<std::uint32_t>(byteCount(field));
  layout.fields.push_back(field);
  return field.offset;
}

/** \brief A field's value of one point as a double; every type a PCD can have. */
inline double
valueAt(const std::uint8_t* bytes, std::uint8_t datatype)
{
  const auto as = [bytes](auto value) {
    std::memcpy(&value, bytes, sizeof(value)); // fields need not be aligned
    return static_cast<double>(value);
  };
  switch (datatype) {
  case PCLPointField::INT8:
    return as(std::int8_t());
  case PCLPointField::UINT8:
    return as(std::uint8_t());
  case PCLPointField::INT16:
    return as(std::int16_t());
  case PCLPointField::UINT16:
    return as(std::uint16_t());
  case PCLPointField::INT32:
    return as(std::int32_t());
  case PCLPointField::UINT32:
    return as(std::uint32_t());
  case PCLPointField::INT64:
    return as(std::int64_t());
  case PCLPointField::UINT64:
    return as(std::uint64_t());
  case PCLPointField::FLOAT32:
    return as(float());
  case PCLPointField::FLOAT64:
    return as(double());
  default:
    return std::numeric_limits<double>::quiet_NaN();
  }
}

} // namespace pcl::indoor::tool
