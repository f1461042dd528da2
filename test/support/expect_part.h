/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_stream.h"

#include <gtest/gtest.h>

#include <cstring>

namespace pcl::indoor::test {

/** Some points of a stream are those of the whole cloud, bit for bit. */
inline void
expectPart(tool::CloudStream& stream,
           const PCLPointCloud2& whole,
           std::uint64_t first,
           std::size_t count)
{
  const auto part = stream.read(first, count);
  const auto step = whole.point_step;
  ASSERT_EQ(part.data.size(), count * step);
  ASSERT_EQ(std::memcmp(part.data.data(), &whole.data[first * step], count * step), 0)
      << count << " points from " << first;
}

} // namespace pcl::indoor::test
