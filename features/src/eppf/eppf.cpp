/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/impl/eppf.hpp>
#include <pcl/indoor/point_type_lists.h>

#ifndef PCL_NO_PRECOMPILE
// A scan with separate normals, or points that carry theirs.
PCL_INSTANTIATE_PRODUCT(
    EPPFEstimation,
    (PCL_INDOOR_PLAIN_POINT_TYPES)((pcl::Normal))((pcl::EPPFSignature1200)(
        pcl::EPPFSignature540)(pcl::PairHarmonicsSignature1200)))
PCL_INSTANTIATE_PRODUCT(
    EPPFEstimation,
    (PCL_INDOOR_ORIENTED_POINT_TYPES)(PCL_INDOOR_ORIENTED_POINT_TYPES)((
        pcl::EPPFSignature1200)(pcl::EPPFSignature540)(
        pcl::PairHarmonicsSignature1200)))
#endif
