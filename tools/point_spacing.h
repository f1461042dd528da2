/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl::indoor::tool {

/** \brief The typical distance between neighbours on a scanned surface, metres.
 *
 * From the number of points in cells of a size at which the median cell of the
 * surface holds several; so neither the order of the points nor a few dense or stray
 * parts matter. Linear but for one sort.
 * \return 0 if fewer than two points are finite
 */
double
pointSpacing(const PointCloud<PointXYZ>& points);

} // namespace pcl::indoor::tool
