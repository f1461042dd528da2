/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/filters/impl/scan_outlier_removal.hpp>
#include <pcl/indoor/point_type_lists.h>

#ifndef PCL_NO_PRECOMPILE
PCL_INSTANTIATE(ScanOutlierRemoval, PCL_INDOOR_SCAN_POINT_TYPES)
#endif
