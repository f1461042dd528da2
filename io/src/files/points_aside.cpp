/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/points_aside.h"

#include "files/tool_error.h"

#include <Eigen/Core>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t block_size = 1 << 16; // points

std::streamsize
sizeOf(const std::vector<Eigen::Vector3f>& block)
{
  return static_cast<std::streamsize>(block.size() * sizeof(Eigen::Vector3f));
}

} // namespace

PointsAside::PointsAside(PointCloud<PointXYZ>& points, const std::string& path)
: points_(points)
, path_(path)
, file_(path, std::ios::in | std::ios::out | std::ios::trunc | std::ios::binary)
{
  std::error_code error;
  std::filesystem::remove(path, error); // it is open, and ends with this
  std::vector<Eigen::Vector3f> block;
  for (std::size_t first = 0; first < points.size() && file_; first += block_size) {
    block.clear();
    const auto end = std::min(points.size(), first + block_size);
    for (std::size_t i = first; i < end; ++i)
      block.emplace_back(points[i].getVector3fMap());
    file_.write(reinterpret_cast<const char*>(block.data()), sizeOf(block));
  }
  if (!file_.flush())
    return;
  count_ = points.size();
  decltype(points.points)().swap(points.points);
}

void
PointsAside::bringBack()
{
  std::vector<Eigen::Vector3f> block;
  points_.points.reserve(points_.size() + count_);
  file_.seekg(0);
  for (; count_ > 0; count_ -= block.size()) {
    block.resize(std::min(count_, block_size));
    if (!file_.read(reinterpret_cast<char*>(block.data()), sizeOf(block)))
      throw ToolError(path_ + ": the points cannot be read back");
    for (const auto& point : block)
      points_.points.emplace_back(point.x(), point.y(), point.z());
  }
}

} // namespace pcl::indoor::tool
