/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"

#include <pcl/indoor/exports.h>
#include <pcl/io/station.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What is said of the places where the scanner stood. */
struct StationChoice {
  std::string file;        ///< with their positions; empty: as the scan tells
  bool is_ignored = false; ///< where it stood does not matter
};

/** \brief Read where the scanner stood, one station after the other: a table with x, y
 * and z in each line, or any other cloud. They are named "1", "2", ...
 * \throws ToolError as loadCloud(), and if a position is not finite */
std::vector<Station>
readStations(const std::string& path);

/** \brief Give a scan the stations of a choice, or take the positions of its own away.
 * The positions of a file stand in for those that the scan tells. Its field station
 * tells which of them measured a point if it fits their number, and it is noted if it
 * does not.
 * \throws ToolError as readStations(), and if the scan has stations of another number
 */
PCL_INDOOR_EXPORTS void
choose(const StationChoice& choice, CloudFile& file);

/** \brief The positions of the stations, in the frame of the file's points; empty
 * unless all are known: what is seen from the others would seem to be seen from
 * nowhere. */
PCL_INDOOR_EXPORTS std::vector<Eigen::Vector3d>
stationPositions(const CloudFile& file);

/** \brief The station that measured each point, from 1; 0 = not known; empty if of no
 * point it is, or if not all positions are known. */
PCL_INDOOR_EXPORTS std::vector<std::uint32_t>
stationsOfPoints(const CloudFile& file);

} // namespace pcl::indoor::tool
