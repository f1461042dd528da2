/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/options.h"
#include "simulation/room_capture.h"

#include <pcl/simulation/carried_lidar.h>

#include <string>

namespace pcl::indoor::tool {

/** \brief The scanner that is simulated, and how it goes through the building. */
struct ScannerOptions {
  std::string name = "sphere"; ///< or that of a scanner that is carried
  TrajectoryOptions trajectory;
  RangeSensorOptions sensor;
  CarriedLidarOptions lidar; ///< what it has in common with sensor is read into that
  PathOptions path;          ///< and what it has in common with trajectory into that
  RoomCapture rooms;         ///< the same of both, of the depth camera
  double lowest_ring = 0.0, highest_ring = 0.0; ///< degrees
  double field_width = 0.0, field_height = 0.0; ///< degrees
};

/** \brief The defaults of a scanner; of one that is not known, those of the sphere. */
ScannerOptions
scannerOptions(const std::string& name);

/** \brief Register the options of all scanners, apart for experts but those of the
 * path.
 */
void
addScannerOptions(OptionParser& parser, ScannerOptions& options);

/** \brief Check what was read, and give the lidar its part.
 * \throws ToolError if an option is given that does not count for the scanner, or two
 * contradict each other
 */
void
completeScanner(ScannerOptions& options, int argc, const char* const* argv);

} // namespace pcl::indoor::tool
