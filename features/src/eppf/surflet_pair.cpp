/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/impl/surflet_pair.hpp>

#ifndef PCL_NO_PRECOMPILE
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

// A scan with separate normals, or points that carry theirs.
PCL_INSTANTIATE_PRODUCT(
    SurfletPairEstimation,
    ((pcl::PointXYZ)(pcl::PointXYZRGB)(pcl::PointXYZRGBA))((pcl::Normal))(
        (pcl::SurfletPairSignature625)(pcl::SurfletPairSignature1296)))
PCL_INSTANTIATE_PRODUCT(SurfletPairEstimation,
                        ((pcl::PointNormal)(pcl::PointXYZRGBNormal))((pcl::PointNormal)(
                            pcl::PointXYZRGBNormal))((pcl::SurfletPairSignature625)(
                            pcl::SurfletPairSignature1296)))
#endif
