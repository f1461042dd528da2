/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"

#include <pcl/indoor/exports.h>

#include <cstdint>
#include <string>

namespace pcl::indoor::tool {

/** \brief How the tools write x, y and z: the option -double.
 *
 * PCL's own readers and viewers take floats only: they show doubles as zeros.
 */
struct PCL_INDOOR_EXPORTS PointCoordinates {
  bool doubles = false;

  /** \brief The offset that apply() gives a file, which has its fields. */
  Eigen::Vector3d
  offsetOf(const CloudFile& file) const;

  /** \brief Make doubles floats relative to CloudFile::offset, which the file then
   * tells, and say so on stderr; floats stay as they are. With -double, make them
   * doubles without an offset. All other fields stay as they are.
   * \param[in] output name of the file that they go to, for the message; empty: there
   * is none
   */
  void
  apply(CloudFile& file, const std::string& output) const;
};

} // namespace pcl::indoor::tool
