/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/model/wall_face.h>
#include <pcl/segmentation/building_rooms.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief A wall: a straight piece of building between rooms, or around them. */
struct ModelWall {
  std::uint32_t storey = 0;
  Eigen::Vector2d begin, end; ///< of its axis, metres; of a wall of which one side
                              ///< was seen this is that side, the room on the left
  double floor = 0.0;         ///< height of its foot, metres
  double height = 0.0;        ///< metres
  double thickness = 0.0;     ///< where both sides were seen, metres; 0 = only one was
  std::vector<std::uint32_t> rooms; ///< that it bounds, ascending
};

enum class ModelOpeningKind {
  Door,   ///< open or closed, with a lintel or not wider than a door of one leaf
  Window, ///< glass, or a recess with glass, above the floor
  Passage ///< wider or up to the ceiling, without a leaf
};

/** \brief A column: what stands in a room from its floor to its ceiling, and is no
 * wall. */
struct ModelColumn {
  std::uint32_t room = 0;   ///< that it stands in
  std::uint32_t storey = 0; ///< that of the room
  Eigen::Vector2d center;   ///< metres
  Eigen::Vector2d size;     ///< length and width, the length not less; of a round one
                            ///< both are the diameter, metres
  double yaw = 0.0;         ///< of its length, counter-clockwise from +x, radians
  double floor = 0.0;       ///< height of its foot, metres
  double height = 0.0;      ///< metres
  bool is_round = false;
};

/** \brief A hole in a wall, or what closes one. */
struct ModelOpening {
  ModelOpeningKind kind = ModelOpeningKind::Door;
  std::uint32_t room_a = 0; ///< the smaller number of the rooms that it joins
  std::uint32_t room_b = 0; ///< the larger one; 0 = the outside, or what was not seen
  std::uint32_t storey = 0;
  std::size_t wall = 0; ///< which of the walls it is in; their number = none
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< middle of its lower edge,
                                                      ///< metres
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();   ///< the wall, unit length
  double width = 0.0;                                 ///< metres
  double height = 0.0;                                ///< metres
  double sill = 0.0;    ///< height of the lower edge above the floor, metres
  bool is_open = false; ///< whether a person can pass as it was scanned

  double
  head() const
  {
    return sill + height;
  }
};

/** \brief What a building consists of besides rooms. */
struct BuildingModel {
  std::vector<WallFace> faces; ///< sides of walls, outline by outline
  std::vector<ModelWall> walls;
  std::vector<ModelColumn> columns;   ///< room by room
  std::vector<ModelOpening> openings; ///< where one can pass, in the order given; then
                                      ///< all others, storey by storey
};

/** \brief Make walls, doors and windows from rooms and points.
 *
 * Outlines of rooms are divided in straight sides, which are fitted to the points
 * (wallFaces()); sides of two rooms that face each other, and are seen, are one wall
 * (modelWalls()); each side is seen as an image (wallImage()), in which openings are
 * rectangles without the wall's face (wallHoles()); both sides together, and the places
 * where one can pass, say what they are (modelOpenings()). Needs no normals and no
 * classes.
 *
 * \param[in] points of the rooms, in their frame
 * \param[in] openings where one can pass between rooms
 * \param[in] threads 0 = automatic; the result does not depend on it
 * \return nothing if there are no rooms
 * \throws pcl::BadArgumentException if a room has a number that the points have not
 */
PCL_INDOOR_EXPORTS BuildingModel
buildingModel(const PointsOfRooms& points,
              const std::vector<Room>& rooms,
              const std::vector<RoomOpening>& openings,
              int threads = 0);

} // namespace pcl::indoor
