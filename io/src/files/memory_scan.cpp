/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/io/memory_scan.h>

#include "files/scan_content.h"
#include "text/printable.h"

#include <pcl/common/io.h> // for getFieldSize

#include <cstdint>
#include <memory>
#include <utility>

namespace pcl::indoor {
namespace {

/** What is read without a look at its bounds must be within them. */
void
requireLayout(const PCLPointCloud2& cloud, const std::string& name)
{
  const std::uint64_t step = cloud.point_step;
  for (const auto& field : cloud.fields) {
    const std::uint64_t size = getFieldSize(field.datatype);
    const std::uint64_t count = field.count == 0 ? 1 : field.count; // as PCL has it
    if (size == 0)
      throw InputError(name + ": the field " + tool::printable(field.name) +
                       " has the unknown type " + std::to_string(field.datatype));
    if (field.offset + size * count > step)
      throw InputError(name + ": the field " + tool::printable(field.name) +
                       " ends beyond the " + std::to_string(step) +
                       " bytes of a point");
  }
  // no product of these three is too large for 64 bits once the first is checked
  const auto points = static_cast<std::uint64_t>(cloud.width) * cloud.height;
  if (step == 0 || cloud.data.size() % step != 0 || cloud.data.size() / step != points)
    throw InputError(name + ": " + std::to_string(cloud.data.size()) +
                     " bytes are not those of " + std::to_string(cloud.width) + " x " +
                     std::to_string(cloud.height) + " points of " +
                     std::to_string(step) + " bytes");
  if (cloud.is_bigendian)
    throw InputError(name + ": the bytes of numbers are in the order of other machines "
                            "(big-endian)");
}

} // namespace

Scan
memoryScan(PCLPointCloud2 cloud, const std::string& name)
{
  requireLayout(cloud, name);
  auto content = std::make_shared<ScanContent>();
  content->file = tool::withPoints(name, std::move(cloud), tool::CloudPose());
  return Scan(std::move(content));
}

} // namespace pcl::indoor
