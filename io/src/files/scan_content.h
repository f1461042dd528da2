/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cell_sample.h"
#include "files/cloud_file.h"
#include "files/cloud_stream.h"
#include "files/station_choice.h"
#include "formats/packed_file.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief A scan in memory; of a large one, what is needed to find its rooms. */
struct ScanContent {
  /** with all points, or, once they are drawn, those of the sample, and no fields */
  tool::CloudFile file;
  std::vector<std::unique_ptr<tool::UnpackedFiles>> unpacked; ///< that hold the stream
  std::unique_ptr<tool::CloudStream> stream; ///< of a large scan: all of its points
  std::vector<std::string> notes;            ///< of the files of a large scan
  std::optional<tool::CellSample> sample;    ///< of a large scan
  Eigen::Vector3d middle =
      Eigen::Vector3d::Zero();      ///< of a large scan, taken from its points
  std::string columns;              ///< that its tables were said to have
  std::uint64_t points_at_once = 0; ///< of a large scan
  tool::StationChoice stations;     ///< that was made for it

  /** \brief Points of the whole scan. */
  std::uint64_t
  pointCount() const
  {
    return stream ? stream->pointCount() : file.points->size();
  }
};

} // namespace pcl::indoor
