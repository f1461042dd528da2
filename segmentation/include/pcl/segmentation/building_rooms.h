/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/progress_callback.h>
#include <pcl/segmentation/rooms/interior_space.h>
#include <pcl/segmentation/rooms/occupancy_grid.h>
#include <pcl/segmentation/rooms/room_map.h>
#include <pcl/segmentation/rooms/scan_stations.h>
#include <pcl/segmentation/rooms/storeys.h>
#include <pcl/segmentation/rooms/wall_sides.h>

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace indoor {

constexpr double smallest_automatic_voxel = 0.1; ///< metres
constexpr double largest_automatic_voxel = 0.4;  ///< metres: half as wide as a door

/** \brief How points at walls get their room. */
enum class PointRooms {
  WallSides, ///< by the side of the wall that they are on
  Vote       ///< by most of the ten nearest free voxels, Sec. 3.2.3
};

/** \brief All parameters of the way from a building's points to its rooms. */
struct BuildingRoomsOptions {
  double voxel_size = 0.0; ///< side of a voxel and of a map pixel, metres (>= 0); 0 =
                           ///< automatic: 0.1, up to 0.4 where the points are so sparse
                           ///< that their surfaces would have holes
  InteriorSpaceOptions interior;
  StoreyOptions storeys;
  RoomMapOptions map;
  WallSideOptions walls;
  PointRooms point_rooms =
      PointRooms::WallSides; ///< how points at walls get their room
  bool align_grid = true;    ///< whether voxels lie along the best supported walls
  int threads = 0; ///< of all stages, 0 = automatic; the result does not depend on it
};

/** \brief The thesis's own way from points to rooms (Sec. 3.2) and no more: voxels of
 * 20 cm along the axes, two dominant directions in space, the potential field, each
 * pixel a landmark of visibility, and the vote of ten neighbours. Of the weights of Eq.
 * (3.1) it changed w1 (interior.weights.below) to 0.5 where floors are hidden, and w2
 * (interior.weights.above) to 1.5 where ceilings are not. docs/method/thesis.md lists
 * what the thesis leaves open.
 */
BuildingRoomsOptions
thesisRoomOptions();

/** \brief What is wrong with the options: one sentence with the value and the range.
 * \return empty if all are in range
 */
std::string
findProblem(const BuildingRoomsOptions& options);

/** \brief One room of a building. */
struct Room {
  std::uint32_t label = 0;     ///< 1 ... n
  std::uint32_t storey = 0;    ///< that of its floor; 0 = the lowest
  std::size_t point_count = 0; ///< points with this label
  double area = 0.0;           ///< floor area inside the walls, m^2
  double volume = 0.0;         ///< from the storey's floor to the ceiling, m^3
  double height = 0.0;         ///< volume over area, metres; where floor or ceiling was
                               ///< not seen, its walls' lower or upper end stands in
  double floor_seen = 0.0;     ///< share of the area in which the floor was seen
  double ceiling_seen = 0.0;   ///< share of the area in which the ceiling was seen
  double seen = 0.0;           ///< share of its border where a wall or another room was
                               ///< seen; elsewhere it may go on where nobody looked
  Eigen::Vector3d lower;       ///< lower corner of the box around the points, metres
  Eigen::Vector3d upper;       ///< upper corner of it, metres
  Eigen::Vector3d centroid;    ///< of the points, metres
  /** Its floor inside the walls, metres: closed lines, counter-clockwise seen from
   * above around the floor (the largest part first), clockwise around holes; within 1.5
   * pixels of the map's borders. */
  std::vector<std::vector<Eigen::Vector3d>> footprint;
};

/** \brief A place where a person can pass from one room to another. */
struct RoomOpening {
  std::uint32_t room_a = 0; ///< the smaller label
  std::uint32_t room_b = 0; ///< the larger label
  Eigen::Vector3d position; ///< its middle, on the storey's floor, metres
  double width = 0.0;       ///< metres
  double area = 0.0;        ///< m^2
  /** Its middle over the middle between floor and ceiling, metres: below 0 under a
   * lintel. */
  double rise = 0.0;
};

/** \brief The rooms of a building and every step on the way to them. */
struct BuildingRooms {
  OccupancyGrid occupancy; ///< its voxel size is the one that was used
  InteriorSpace interior;
  Storeys storeys;           ///< heights of the storeys
  std::vector<RoomMap> maps; ///< per storey; each has its own labels 1 ... n
  std::vector<std::vector<std::uint32_t>> room_of; ///< per storey and label: the room
  std::vector<std::uint32_t> point_labels;         ///< room per point, 0 = none
  std::vector<Room> rooms;                         ///< in the order of their labels
  std::vector<RoomOpening> openings; ///< storey by storey, in the order of the rooms
  /** Spaces that are no rooms: far fewer points show them than others, as mirror images
   * behind glass, or hardly a wall, as what is seen through a door. */
  std::size_t hardly_seen = 0;
  /** Spaces that are no rooms: no station stands in them, and none looked into them but
   * through walls and panes. */
  std::size_t never_entered = 0;
  std::vector<PlacedStation> stations; ///< those that were given, in their order
};

/** \brief Find the rooms of a building.
 * \param[in] points finite points near the origin, z up, metres
 * \param[in] progress called before each stage and at the end with 1; may be empty
 * \param[in] stations in the frame of the points, if they are known
 * \return nothing at all (no storeys, no labels) if \a progress returned false or there
 * are no points
 * \throws pcl::BadArgumentException if an option is out of range
 */
BuildingRooms
segmentBuilding(const std::vector<Eigen::Vector3f>& points,
                BuildingRoomsOptions options = {},
                const ProgressCallback& progress = {},
                const ScanStations& stations = {});

} // namespace indoor
} // namespace pcl
