/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/packed_file.h"

#include <pcl/indoor/exports.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The files of the scans that were asked for. */
struct ScanFiles {
  std::vector<std::string> paths;
  std::vector<std::string> notes; ///< what of folders is left out, a line each
};

/** \brief Find the scans: each file that is named, and of each folder all that are read
 * by their endings, in the order of their names. Of other files a line says that they
 * are left out, one for all of an ending; what an earlier run has left is no scan.
 * \throws ToolError if a folder holds none
 */
PCL_INDOOR_EXPORTS ScanFiles
scanFiles(const std::vector<std::string>& inputs);

/** \brief Unpack what is packed: in its place come the scans in it, as those of a
 * folder; where there is none, the one mesh in it.
 * \return what holds them: they are removed with it
 * \throws ToolError if a file cannot be unpacked or holds no scan
 */
std::vector<std::unique_ptr<UnpackedFiles>>
unpackScans(ScanFiles& files);

/** \brief What a scan of such files is called. */
std::string
nameOfScan(const std::vector<std::string>& inputs,
           const std::vector<std::string>& files);

} // namespace pcl::indoor::tool
