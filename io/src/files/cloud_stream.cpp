/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_stream.h"

#include "files/cloud_formats.h"
#include "files/tool_error.h"

#include <algorithm>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t points_of_part = 1 << 18;

} // namespace

PCLPointCloud2
emptyPart(const PCLPointCloud2& layout, std::size_t count)
{
  auto part = layout;
  part.width = static_cast<std::uint32_t>(count);
  part.height = 1;
  part.row_step = part.point_step * part.width;
  return part;
}

void
CloudStream::setStation(const std::string& name,
                        const Eigen::Vector3d& position,
                        const Eigen::Matrix3d& turn)
{
  constexpr double tolerance = 1e-3; // as text with three decimals has it
  stations_ = {{name, position}};
  const Eigen::Vector3f origin = position.cast<float>();
  if (!origin.allFinite() || !turn.isUnitary(tolerance) || turn.determinant() < 0)
    return;
  pose_.origin.head<3>() = origin;
  pose_.orientation = Eigen::Quaterniond(turn).cast<float>();
}

std::unique_ptr<CloudStream>
CloudStream::open(const std::string& path)
{
  try {
    const auto* const format = cloudFormatOf(path);
    return format != nullptr && format->open != nullptr ? format->open(path) : nullptr;
  } catch (const ToolError&) {
    return nullptr;
  }
}

void
CloudStream::forEachPart(
    const std::function<void(std::uint64_t first, PCLPointCloud2& part)>& visit)
{
  for (std::uint64_t first = 0; first < pointCount();) {
    const auto count = static_cast<std::size_t>(
        std::min<std::uint64_t>(points_of_part, pointCount() - first));
    auto part = read(first, count);
    visit(first, part);
    first += count;
  }
}

} // namespace pcl::indoor::tool
