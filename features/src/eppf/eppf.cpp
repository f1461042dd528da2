/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/impl/eppf.hpp>

#ifndef PCL_NO_PRECOMPILE
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

// A scan with separate normals, or points that carry theirs.
PCL_INSTANTIATE_PRODUCT(EPPFEstimation,
                        ((pcl::PointXYZ)(pcl::PointXYZRGB)(pcl::PointXYZRGBA))(
                            (pcl::Normal))((pcl::EPPFSignature1200)(
                            pcl::EPPFSignature540)(pcl::PairHarmonicsSignature1200)))
PCL_INSTANTIATE_PRODUCT(EPPFEstimation,
                        ((pcl::PointNormal)(pcl::PointXYZRGBNormal))((pcl::PointNormal)(
                            pcl::PointXYZRGBNormal))((pcl::EPPFSignature1200)(
                            pcl::EPPFSignature540)(pcl::PairHarmonicsSignature1200)))
#endif
