/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>
#include <pcl/indoor/exports.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/object_segmentation.h>
#include <pcl/types.h> // for Indices

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

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

/** \brief The points of one room, z up, metres. */
struct RoomPoints {
  std::vector<Eigen::Vector3f> positions; ///< finite
  std::vector<Eigen::Vector3f> normals; ///< one per point; empty to have them estimated
  /** Objects that are known already, one per point, 0 = none; empty: they are found. */
  std::vector<std::uint32_t> given;
};

/** \brief The objects of one room. */
struct RoomObjects {
  /** one per point: 1 ... n in the order of their first points; 0 = none, also of what
   * lies kilometres away from the others */
  std::vector<std::uint32_t> object_of_point;
  std::vector<std::uint32_t> structure_of_point; ///< one per point: a StructureKind
  std::vector<ObjectSurface> surfaces;           ///< object i + 1 is the i-th
  double voxel_size = 0.0; ///< that was used, metres; 0 = there are no points
  /** what the points of objects were taken for; empty if nobody was asked */
  VoxelClasses votes;
};

/** \brief Segment the points of one room, or those in no room, into objects.
 *
 * The result depends on nothing but the room: rooms can be done one after the other, at
 * the same time, or on several machines. Time and memory are linear in the points.
 * \param[in] room taken by value: it is emptied on the way; without points there are no
 * objects
 * \param[in] options what has less than fewest_points is the remainder, see
 * separateRemainder()
 * \param[in] voter what the points are part of, also in given objects
 * \throws pcl::BadArgumentException if an option is out of range, or sizes differ
 */
PCL_INDOOR_EXPORTS RoomObjects
segmentRoomObjects(RoomPoints room,
                   const ObjectSegmentationOptions& options = {},
                   const VoxelVoter& voter = {});

/** \brief Make what is too small to be an object the remainder of its room: segments of
 * fewer points, and those that are smaller than a supervoxel.
 *
 * Their points get object 0 and StructureKind::Remainder; the other objects are
 * numbered again, in the same order.
 * \param[in] fewest points of an object
 */
PCL_INDOOR_EXPORTS void
separateRemainder(RoomObjects& objects, std::size_t fewest);

/** \brief A box that stands upright, turned about the vertical. */
struct UprightBox {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d size = Eigen::Vector3d::Zero(); ///< length >= width, and height
  double yaw = 0.0; ///< of the length, radians counter-clockwise from x, in [0, pi)
};

/** \brief The upright box of the least ground area around some points; z is up.
 *
 * One of its sides touches the convex hull along an edge. Time: n log n.
 * \param[in] points finite; of none, the box is all zero
 */
PCL_INDOOR_EXPORTS UprightBox
uprightBox(const std::vector<Eigen::Vector3d>& points);

/** \brief The distance of a place from a box, 0 inside. */
PCL_INDOOR_EXPORTS double
distanceTo(const UprightBox& box, const Eigen::Vector3d& place);

/** \brief Place and size of an object. */
struct ObjectMeasures {
  std::uint32_t structure = 0; ///< a StructureKind
  std::size_t point_count = 0;
  Eigen::Vector3d lower = Eigen::Vector3d::Zero(); ///< corner of the box
  Eigen::Vector3d upper = Eigen::Vector3d::Zero();
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  UprightBox upright; ///< z up, metres
};

/** \brief Measure the objects of a room.
 * \param[in] positions in the frame in which boxes and centres are wanted
 * \param[in] upright the same points, z up, metres
 * \return one per object
 * \throws pcl::BadArgumentException if there are not as many of each as points of the
 * objects
 */
PCL_INDOOR_EXPORTS std::vector<ObjectMeasures>
measureObjects(const std::vector<Eigen::Vector3f>& positions,
               const std::vector<Eigen::Vector3f>& upright,
               const RoomObjects& objects);

/** \brief The room with whose points the objects of each point are looked for: its own,
 * and for a point in none that to which half a metre of surface leads, or 0.
 *
 * A room ends where nothing shows that it goes on: without its surroundings, objects in
 * niches and windows, and what stands where little was seen, would be cut.
 * \param[in] positions finite, z up, metres
 * \param[in] room_of_point one per position; 0 = none
 */
PCL_INDOOR_EXPORTS std::vector<std::uint32_t>
withSurroundings(const std::vector<Eigen::Vector3f>& positions,
                 std::vector<std::uint32_t> room_of_point);

/** \brief The finite points of room 1 with its surroundings, room 2 and so on; last,
 * the others.
 * What lies kilometres away from the others is in none of these, see strayPoints().
 * \param[in] room_of_point one per point; 0 = none
 * \param[in] room_count no room has a greater number
 * \return room_count + 1 lists
 * \throws pcl::BadArgumentException if there are not as many rooms as points
 */
PCL_INDOOR_EXPORTS std::vector<Indices>
pointsOfRooms(const PointCloud<PointXYZ>& points,
              const std::vector<std::uint32_t>& room_of_point,
              std::size_t room_count);

/** \brief The numbers of rooms, those with more points first: so that no thread is left
 * with a large one at the end.
 * \param[in] sizes points of each room
 */
PCL_INDOOR_EXPORTS std::vector<std::size_t>
largestFirst(const std::vector<std::size_t>& sizes);

} // namespace pcl::indoor
