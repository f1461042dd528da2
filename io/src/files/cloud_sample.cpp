/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_sample.h"

#include <algorithm>
#include <utility>

namespace pcl::indoor::tool {

void
sampleBlocks(std::uint64_t point_count,
             const std::function<void(std::uint64_t, std::size_t)>& visit)
{
  constexpr std::uint64_t blocks = 256, block_size = 4096; // a million points
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const auto first = point_count * block / blocks;
    const auto next = point_count * (block + 1) / blocks;
    if (next > first)
      visit(first, static_cast<std::size_t>(std::min(block_size, next - first)));
  }
}

PCLPointCloud2
pointsFromAllOver(CloudStream& stream)
{
  PCLPointCloud2 cloud;
  sampleBlocks(stream.pointCount(), [&](std::uint64_t first, std::size_t count) {
    auto part = stream.read(first, count);
    if (part.data.empty())
      return;
    if (cloud.data.empty()) {
      cloud = std::move(part);
      return;
    }
    const auto size = cloud.data.size();
    cloud.data.resize(size + part.data.size());
    std::copy(part.data.begin(), part.data.end(), &cloud.data[size]);
    cloud.width += part.width;
  });
  return cloud;
}

} // namespace pcl::indoor::tool
