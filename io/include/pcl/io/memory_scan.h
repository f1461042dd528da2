/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/io/scan_file.h>
#include <pcl/PCLPointCloud2.h>

#include <string>

namespace pcl::indoor {

/** \brief A scan of a cloud in memory, with the fields x, y and z of real numbers and
 * any others; bytes as this machine has them.
 * \param[in] cloud is kept by the scan
 * \param[in] name what it is called in messages and in the scene
 * \throws InputError if fields and bytes do not fit together, or if fewer than two
 * points are finite
 */
PCL_INDOOR_EXPORTS Scan
memoryScan(PCLPointCloud2 cloud, const std::string& name);

} // namespace pcl::indoor
