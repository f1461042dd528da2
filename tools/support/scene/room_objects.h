/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/object_surfaces.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The objects of all rooms. */
struct RoomObjects {
  /** 1 ... n, in the order of the rooms, then those in no room; 0 = not finite */
  std::vector<std::uint32_t> object_of_point;
  /** one per point: 1 floor, 2 wall, 3 ceiling, 4 remainder, else 0; see StructureKind
   */
  std::vector<std::uint32_t> structure_of_point;
  std::vector<ObjectSurface> surfaces; ///< object i + 1 is the i-th
  /** per room, metres; the last is that of points in no room; 0 = no points */
  std::vector<double> voxel_sizes;
};

/** \brief Segment the points of each room, and those in no room, into objects; several
 * rooms at a time.
 * \param[in] normals one per point, or null to have them estimated
 * \param[in] room_of_point one per point, not empty; 0 = none
 * \param[in] threads rooms at a time, 0 = automatic; the result does not depend on it
 * \param[in] given objects that are known already, one per point, 0 = none; then these
 * are taken, an object in two rooms as two; empty: they are found
 * \param[in] report is told how many of all points are done, from one thread at a
 * time
 * \throws AlreadyReported if the segmentation of a room has printed why it failed
 */
RoomObjects
segmentRoomObjects(
    const PointCloud<PointXYZ>& points,
    const PointCloud<Normal>::ConstPtr& normals,
    const std::vector<std::uint32_t>& room_of_point,
    const ObjectSegmentationOptions& options,
    int threads,
    const std::vector<std::uint32_t>& given,
    const std::function<void(std::size_t done, std::size_t all)>& report);

} // namespace pcl::indoor::tool
