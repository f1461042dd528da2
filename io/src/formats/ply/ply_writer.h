/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_writer.h" // for CloudPose

namespace pcl::indoor::tool {

/** \brief Write a cloud as PLY, little endian, in the way of cloudBeside().
 *
 * Normals are nx, ny, nz, colours are red, green, blue (and alpha), fields of several
 * values are lists; the pose and the arrangement in rows are the element camera. All
 * are read back by loadPly() and by PCL, but for lists.
 * \throws ToolError if a field has integers of 64 bits
 */
void
writePly(OutputFile& file,
         const std::string& path,
         const PCLPointCloud2& cloud,
         const CloudPose& pose);

} // namespace pcl::indoor::tool
