/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/scan_content.h"
#include "formats/packed_file.h"

#include <pcl/indoor/exports.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The files of a scan before their points are read. */
struct OpenedScan {
  std::string name; ///< of the scan
  std::vector<std::string> files;
  std::vector<std::string> notes; ///< what of folders is left out, a line each
  std::vector<std::unique_ptr<UnpackedFiles>> unpacked; ///< what holds some of them
  /** of each file; null if it cannot be read in parts, or is small and the only one */
  std::vector<std::unique_ptr<CloudStream>> streams;
  std::uint64_t count = 0, in_memory = 0; ///< points of all, of those that are null

  /** \brief Are there more points than are to be read at once (0 = all)? */
  bool
  isLargerThan(std::uint64_t points_at_once) const
  {
    return points_at_once > 0 && count > in_memory && count > points_at_once;
  }
};

/** \brief Find the files, see scanFiles(), unpack and open them.
 * \param[in] points_at_once see OpenedScan::isLargerThan() */
PCL_INDOOR_EXPORTS OpenedScan
openScan(const std::vector<std::string>& inputs, std::uint64_t points_at_once);

/** \brief Read all points.
 * \param[in] columns of tables
 * \throws ToolError see loadCloud() */
PCL_INDOOR_EXPORTS ScanContent
readWhole(OpenedScan scan, const TableColumns& columns);

/** \brief Leave the points in their files: the scan has its fields, pose and notes.
 * \param[in] scan is larger than its points_at_once */
PCL_INDOOR_EXPORTS ScanContent
readLater(OpenedScan scan, const TableColumns& columns);

/** \brief Open the scans of one building as one, see joinedStream(). Those that cannot
 * be read in parts are read into memory.
 * \param[in] opened of each file, null if it cannot be read in parts
 */
std::unique_ptr<CloudStream>
joinedScans(const std::vector<std::string>& files,
            std::vector<std::unique_ptr<CloudStream>> opened,
            const TableColumns& columns);

} // namespace pcl::indoor::tool
