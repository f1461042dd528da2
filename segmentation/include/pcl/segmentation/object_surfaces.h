/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>
#include <pcl/indoor/exports.h>
#include <pcl/segmentation/object_segmentation.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief The surface of an object and where it is in its room; z is up. */
struct ObjectSurface {
  /** One per voxel: the mean of its points, and a unit normal of either sign; voxels
   * without a normal are left out. Metres, in the frame of the segmentation. */
  std::vector<OrientedPoint> points;
  float floor_distance = 0.0f; ///< of the lowest point from the floor, metres
};

/** \brief The surfaces of a room's objects, as a classifier wants them.
 *
 * The floor is the lowest voxel of the whole room in the columns around the object.
 * Time: linear in voxels.
 * \param[in] room the segmentation of one room, z up
 * \param[in] object_of_point one per point of the segmentation: 0 ... object_count - 1;
 * other values are no object. Usually room.segment_of_point
 * \return one per object; one without voxels has no points
 * \throws pcl::BadArgumentException if there are not as many values as points
 */
PCL_INDOOR_EXPORTS std::vector<ObjectSurface>
objectSurfaces(const ObjectSegmentation& room,
               const std::vector<std::uint32_t>& object_of_point,
               std::uint32_t object_count);

} // namespace indoor
} // namespace pcl
