/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "formats/json_text.h"

#include <pcl/segmentation/building_rooms.h>

#include <nlohmann/json.hpp>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief [x, y, z] to four decimals. */
nlohmann::ordered_json
positionJson(const Eigen::Vector3d& position);

/** \brief Number of points, box and centroid of a room or an object.
 * \param[in] offset from the frame of the thing to that of the file
 */
template <typename Thing>
void
addPlaceJson(nlohmann::ordered_json& json,
             const Thing& thing,
             const Eigen::Vector3d& offset)
{
  json["points"] = thing.point_count;
  json["box"] = {{"lower", positionJson(thing.lower + offset)},
                 {"upper", positionJson(thing.upper + offset)}};
  json["centroid"] = positionJson(thing.centroid + offset);
}

/** \brief One entry per room: number, storey, points, box, centroid, area, height,
 * volume, footprint and neighbours; positions in the frame and the unit of the file,
 * lengths, areas and volumes in metres. */
nlohmann::ordered_json
roomsJson(const std::vector<Room>& rooms,
          const std::vector<RoomOpening>& openings,
          const Eigen::Vector3d& offset);

/** \brief What is known of the input: file, unit, numbers of points.
 * \param[in] file with the offset of the cloud that is written
 * \param[in] room_of_point 0 = none
 */
nlohmann::ordered_json
inputJson(const CloudFile& file, const std::vector<std::uint32_t>& room_of_point);

} // namespace pcl::indoor::tool
