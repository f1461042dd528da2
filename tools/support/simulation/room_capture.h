/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/options.h"

#include <pcl/simulation/hand_camera.h>
#include <pcl/simulation/trajectory.h>

namespace pcl::indoor::tool {

/** \brief What pcl_scan_simulation calls the camera in somebody's hand. */
const char* const hand_camera = "depth_camera";

/** \brief Which rooms are captured, and how. */
struct RoomCapture {
  HandCameraOptions camera;
  int room = 0; ///< number; 0: all
  int most_points = static_cast<int>(HandCameraOptions().most_points); ///< of a room
};

/** \brief Make the camera's the defaults of options that all scanners have. */
void
takeDefaults(const RoomCapture& rooms,
             RangeSensorOptions& sensor,
             TrajectoryOptions& trajectory);

/** \brief Add the options that only this camera has. */
void
addCaptureOptions(OptionParser& parser, RoomCapture& rooms);

/** \brief Give the camera what was read into the options that all scanners have. */
void
complete(RoomCapture& rooms,
         const RangeSensorOptions& sensor,
         const TrajectoryOptions& trajectory);

/** \brief Capture a room, with what is seen through its doors; or all rooms, each
 * without.
 * \throws ToolError if there is no such room */
SimulatedScan
captureRooms(const Building& building, const RoomCapture& rooms, Progress& progress);

} // namespace pcl::indoor::tool
