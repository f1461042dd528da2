/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/voxel_map.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor::test {

/** \brief A map without rooms. */
inline PixelMap<std::int32_t>
emptyMap(int nx, int ny)
{
  return {nx, ny, std::vector<std::int32_t>(static_cast<std::size_t>(nx * ny), 0)};
}

} // namespace pcl::indoor::test
