/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/output_file.h"
#include "formats/cloud_pose.h"

#include <pcl/indoor/exports.h>
#include <pcl/PCLPointCloud2.h>

#include <string>

namespace pcl::indoor::tool {

/** \brief Find out, before the long work, that a cloud cannot be written there.
 * \param[in] pcd_only the cloud is none of points, which PLY is for
 * \throws ToolError as requireWritable() or if the name ends neither in .pcd nor in
 * .ply; a name without an extension means PCD
 */
PCL_INDOOR_EXPORTS void
requireWritableCloud(const std::string& path, bool pcd_only = false);

/** \brief Write all fields of a cloud but do not put the file in place: binary PLY if
 * the name ends in .ply, otherwise compressed PCD (not compressed if it does not
 * shrink or is above 4 GB).
 *
 * The fields have the names and types that PCL's readers give them back as. The file
 * does not depend on the number of threads.
 * \param[in] threads that compress, 0 = as many as the machine offers
 * \throws ToolError if it cannot be written, or if a field has integers of 64 bits,
 * which PLY has not
 */
PCL_INDOOR_EXPORTS OutputFile
cloudBeside(const std::string& path,
            const PCLPointCloud2& cloud,
            const CloudPose& pose,
            int threads = 1);

/** \brief Write a cloud and put it in place. */
PCL_INDOOR_EXPORTS void
saveCloud(const std::string& path,
          const PCLPointCloud2& cloud,
          const CloudPose& pose = {});

} // namespace pcl::indoor::tool
