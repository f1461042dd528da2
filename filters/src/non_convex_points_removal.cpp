/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/filters/impl/non_convex_points_removal.hpp>
#include <pcl/indoor/point_type_lists.h>

#ifndef PCL_NO_PRECOMPILE
PCL_INSTANTIATE_PRODUCT(NonConvexPointsRemoval,
                        (PCL_INDOOR_SCAN_POINT_TYPES)(PCL_INDOOR_NORMAL_TYPES))
#endif
