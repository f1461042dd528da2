/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_stream.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief How the points of a file lie in it: as records of one size. */
struct CloudRecords {
  PCLPointCloud2 layout; ///< fields, width and height; no points
  CloudPose pose;
  std::vector<std::string> notes; ///< see CloudFile::notes
  std::size_t body_begin = 0;     ///< bytes from the beginning of the file
  std::size_t record_size = 0;
  /** The points of some records, with the fields of the layout. */
  std::function<PCLPointCloud2(std::string records, std::size_t count)> points;
};

/** \brief Open a file of such records; its fields get their usual names.
 * \return null if it is shorter than they are, or has no points or no real x, y and z
 */
std::unique_ptr<CloudStream>
recordStream(const std::string& path, CloudRecords records);

} // namespace pcl::indoor::tool
