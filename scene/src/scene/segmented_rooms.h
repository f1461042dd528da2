/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"

#include <pcl/indoor/exports.h>
#include <pcl/scene/scene_options.h>
#include <pcl/segmentation/room_segmentation.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The rooms of a scan, and what was found out about its points. */
struct SegmentedRooms {
  std::vector<std::uint32_t> room_of_point;
  ScanReport report;   ///< of the segmentation; its warnings are those of the file, too
  BuildingFrame frame; ///< with the offset of the file
};

/** \brief Find the rooms.
 * \param[in] found of the file's points with these options, if it is known
 * \param[in] looks_at_objects by the bundled voxel network, where neither furniture nor
 * passages clearly tell which end is up
 * \param[in,out] segmentation its parameters are set; coordinates and input are set
 * here
 * \param[in] warn is told what is implausible, a line each
 * \throws ToolError if no
 * point has been looked at
 */
PCL_INDOOR_EXPORTS SegmentedRooms
segmentRooms(const CloudFile& file,
             const CoordinateOptions& coordinates,
             const std::optional<ScanCoordinates>& found,
             bool looks_at_objects,
             RoomSegmentation<PointXYZ>& segmentation,
             const std::function<void(const std::string& line)>& warn);

/** \brief How many points are in a room. */
PCL_INDOOR_EXPORTS std::size_t
pointsInRooms(const std::vector<std::uint32_t>& room_of_point);

/** \brief What the tool says on a terminal: number of rooms, an automatic voxel size
 * that was raised, points that were left out. */
PCL_INDOOR_EXPORTS std::string
summaryOf(const RoomSegmentation<PointXYZ>& segmentation);

/** \brief Unit of the coordinates, voxel size, points left out and warnings.
 * \param[in] outside how many points were left out */
PCL_INDOOR_EXPORTS void
addReportJson(nlohmann::ordered_json& json,
              const ScanReport& report,
              std::uint64_t outside);

} // namespace pcl::indoor::tool
