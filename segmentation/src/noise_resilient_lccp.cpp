/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/indoor/point_type_lists.h>
#include <pcl/segmentation/impl/noise_resilient_lccp.hpp>

#ifndef PCL_NO_PRECOMPILE
PCL_INSTANTIATE(NoiseResilientLCCP, PCL_INDOOR_SCAN_POINT_TYPES)
#endif
