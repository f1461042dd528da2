/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/range_sensor.h>

#include <cstring>

namespace pcl::indoor::test {

/** \brief Whether two scans are the same, byte by byte. */
inline bool
same(const SimulatedScan& a, const SimulatedScan& b)
{
  return a.points.size() == b.points.size() && a.poses == b.poses &&
         std::memcmp(a.points.data(),
                     b.points.data(),
                     a.points.size() * sizeof(PointXYZScene)) == 0;
}

} // namespace pcl::indoor::test
