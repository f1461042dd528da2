/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

/** \file
 * The point types that the classes of pcl_indoor are compiled for, the same with every
 * PCL: lists of PCL's own have other members from version to version, and since 1.15
 * whoever builds PCL chooses them. For other types include the class's file in impl/.
 */

/** What scans come as. */
#define PCL_INDOOR_SCAN_POINT_TYPES                                                    \
  (pcl::PointXYZ)(pcl::PointXYZI)(pcl::PointXYZL)(pcl::PointXYZRGB)(                   \
      pcl::PointXYZRGBA)(pcl::PointXYZRGBL)(pcl::PointNormal)(pcl::PointXYZINormal)(   \
      pcl::PointXYZRGBNormal)

/** Those of them that carry no normals, for classes that take normals beside them. */
#define PCL_INDOOR_PLAIN_POINT_TYPES                                                   \
  (pcl::PointXYZ)(pcl::PointXYZI)(pcl::PointXYZRGB)(pcl::PointXYZRGBA)

/** Those that carry their normals. */
#define PCL_INDOOR_ORIENTED_POINT_TYPES (pcl::PointNormal)(pcl::PointXYZRGBNormal)

/** What normals are given in, or written to. */
#define PCL_INDOOR_NORMAL_TYPES (pcl::Normal)(pcl::PointNormal)
