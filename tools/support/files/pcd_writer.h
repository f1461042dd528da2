/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_writer.h" // for CloudFrame

namespace pcl::indoor::tool {

/** \brief Write a cloud as PCD, in the way of cloudBeside().
 *
 * PCL's writer maps the file into memory: a full disk ends the program by a signal.
 */
void
writePcd(OutputFile& file, const PCLPointCloud2& cloud, const CloudFrame& frame);

} // namespace pcl::indoor::tool
