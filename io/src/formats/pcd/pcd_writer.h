/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_writer.h" // for CloudPose

#include <pcl/indoor/exports.h>

namespace pcl::indoor::tool {

/** \brief Write a cloud as PCD, in the way of cloudBeside().
 *
 * PCL's writer maps the file into memory: a full disk ends the program by a signal.
 */
void
writePcd(OutputFile& file,
         const PCLPointCloud2& cloud,
         const CloudPose& pose,
         int threads);

/** \brief Begin a PCD that is not compressed, whose points follow part by part.
 * \param[in] layout width, height and fields of the whole
 */
PCL_INDOOR_EXPORTS void
writePcdHeader(OutputFile& file, const PCLPointCloud2& layout, const CloudPose& pose);

/** \brief Write points with the same fields. */
PCL_INDOOR_EXPORTS void
writePcdPart(OutputFile& file, const PCLPointCloud2& part);

} // namespace pcl::indoor::tool
