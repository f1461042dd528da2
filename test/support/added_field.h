/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/common/io.h> // for getFieldSize
#include <pcl/PCLPointCloud2.h>

#include <cstdint>
#include <string>

namespace pcl::indoor::test {

/** \brief Add a field behind those of a cloud that has no points yet. */
inline void
addField(PCLPointCloud2& cloud,
         const std::string& name,
         std::uint8_t type,
         std::uint32_t count = 1)
{
  PCLPointField field;
  field.name = name;
  field.datatype = type;
  field.count = count;
  field.offset = cloud.point_step;
  cloud.fields.push_back(field);
  cloud.point_step += static_cast<std::uint32_t>(getFieldSize(type)) * count;
}

} // namespace pcl::indoor::test
