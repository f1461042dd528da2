/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "files/cloud_stream.h"
#include "scan/cell_sample.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A scan in memory; of a large one, what is needed to find its rooms. */
struct Scan {
  CloudFile file; ///< with all points, or with those of the sample and no fields
  std::unique_ptr<CloudStream> stream; ///< of a large scan: all of its points
  std::optional<CellSample> sample;    ///< of a large scan
  Eigen::Vector3d middle =
      Eigen::Vector3d::Zero(); ///< of a large scan, taken from its points

  /** \brief Points of the whole scan. */
  std::uint64_t
  pointCount() const
  {
    return stream ? stream->pointCount() : file.points->size();
  }
};

/** \brief Open the scans of one building as one, see joinedStream(). Those that cannot
 * be read in parts are read into memory.
 * \param[in] opened of each file, null if it cannot be read in parts
 * \param[in] columns of tables
 */
std::unique_ptr<CloudStream>
joinedScans(const std::vector<std::string>& files,
            std::vector<std::unique_ptr<CloudStream>> opened,
            const TableColumns& columns);

/** \brief The unit that the points seem to be in, metres: see RoomSegmentation. */
double
metresPerUnitOf(CloudStream& stream);

/** \brief Read a scan part by part, keeping a point per cell.
 * \param[in] cell_size in the unit of the file
 * \param[in] most_points from which on cells become larger
 */
Scan
readScan(const std::string& path,
         std::unique_ptr<CloudStream> stream,
         double cell_size,
         std::size_t most_points,
         const std::function<void(std::size_t done, std::size_t all)>& report);

/** \brief Read no more of a large scan than points from all over it.
 * \return its file has no more points than these
 */
Scan
readSample(const std::string& path, std::unique_ptr<CloudStream> stream);

/** \brief A part of a scan that is read in parts, in the frame of its sample. */
CloudFile
partOf(const Scan& scan, PCLPointCloud2 part);

} // namespace pcl::indoor::tool
