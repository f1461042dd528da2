/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "formats/json_text.h"

#include <pcl/indoor/exports.h>
#include <pcl/scene/scene.h>

#include <nlohmann/json.hpp>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief [x, y, z] to four decimals. */
nlohmann::ordered_json
positionJson(const Eigen::Vector3d& position);

/** \brief Number of points, box and centroid of a room or an object.
 * \param[in] offset from the frame of the object to that of the file
 */
template <typename Object>
void
addPlaceJson(nlohmann::ordered_json& json,
             const Object& object,
             const Eigen::Vector3d& offset)
{
  json["points"] = object.point_count;
  json["box"] = {{"lower", positionJson(object.lower + offset)},
                 {"upper", positionJson(object.upper + offset)}};
  json["centroid"] = positionJson(object.centroid + offset);
}

/** \brief One entry per room: number, storey, points, box, centroid, area, height,
 * volume, footprint and neighbours; positions in the frame and the unit of the file,
 * lengths, areas and volumes in metres. */
PCL_INDOOR_EXPORTS nlohmann::ordered_json
roomsJson(const std::vector<Room>& rooms,
          const std::vector<RoomOpening>& openings,
          const Eigen::Vector3d& offset);

/** \brief The scan that a file holds. */
PCL_INDOOR_EXPORTS SceneInput
inputOf(const CloudFile& file);

/** \brief What is known of the input: file, stations, unit, offset of the cloud that is
 * written. */
PCL_INDOOR_EXPORTS nlohmann::ordered_json
inputJson(const SceneInput& input);

} // namespace pcl::indoor::tool
