/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "rooms/scene_rooms.h"

#include <pcl/indoor/exports.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The objects of a building with their surfaces, to learn classes from. */
struct CollectedObjects {
  /** 1 ... n, in the order of the rooms, then the others; 0 = none */
  std::vector<std::uint32_t> object_of_point;
  std::vector<ObjectSurface> surfaces; ///< object i + 1 is the i-th
};

/** \brief Find the objects of all rooms, as a building is described, and keep their
 * surfaces.
 * \param[in] points z up, metres; those that are not finite are in no object
 * \param[in] room_of_point one per point; 0 = none
 * \param[in] given objects that are known already, one per point, 0 = none; then these
 * are taken, an object in two rooms as two; empty: they are found
 */
PCL_INDOOR_EXPORTS CollectedObjects
collectObjects(const PointCloud<PointXYZ>& points,
               const std::vector<std::uint32_t>& room_of_point,
               const std::vector<std::uint32_t>& given,
               RoomWork work,
               int threads,
               const PointsDone& report);

} // namespace pcl::indoor::tool
