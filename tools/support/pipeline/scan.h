/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "files/cloud_stream.h"
#include "pipeline/cell_sample.h"

#include <memory>
#include <optional>
#include <string>

namespace pcl::indoor::tool {

/** \brief A scan in memory; of a large one, what is needed to find its rooms. */
struct Scan {
  CloudFile file; ///< with all points, or with those of the sample and no fields
  std::unique_ptr<CloudStream> stream; ///< of a large scan: all of its points
  std::optional<CellSample> sample;    ///< of a large scan
};

/** \brief How a scan is read, from its header alone: null if it has at most so many
 * points, or cannot be read in parts. */
std::unique_ptr<CloudStream>
streamOf(const std::string& path, std::uint64_t most_points);

/** \brief Read a scan: a stream part by part, keeping a point per cell.
 * \param[in] stream null: all points are loaded
 * \param[in] cell_size in the unit of the file
 * \param[in] most_points from which on cells become larger
 */
Scan
readScan(const std::string& path,
         std::unique_ptr<CloudStream> stream,
         double cell_size,
         std::size_t most_points,
         const std::function<void(std::size_t done, std::size_t all)>& report);

/** \brief A part of a scan that is read in parts, in the frame of its sample. */
CloudFile
partOf(const Scan& scan, PCLPointCloud2 part);

} // namespace pcl::indoor::tool
