/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/indoor/progress_callback.h>
#include <pcl/indoor/voxel_map.h>
#include <pcl/segmentation/building_rooms_options.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl::indoor {

/** \brief The frame of a grid: the building's, turned about the vertical. */
struct PCL_INDOOR_EXPORTS TurnedFrame {
  double yaw = 0.0; ///< it is the building's frame turned by -yaw

  /** \brief Turns horizontal places in the building's frame into the grid's. */
  Eigen::Matrix2d
  turn() const;

  /** \brief Turn a point of the building's frame into the frame of the grid. */
  Eigen::Vector3d
  toGrid(const Eigen::Vector3d& point) const;

  /** \brief Turn a point or direction of the grid's frame into that of the building.
   */
  Eigen::Vector3d
  toBuilding(const Eigen::Vector3d& point) const;
};

/** \brief Where the pixels of a building's maps lie. */
struct MapGrid : TurnedFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< corner of the first, metres
  double voxel_size = 0.0;                          ///< side of a pixel, metres

  /** \brief The middle of a pixel, in the turned frame. */
  Eigen::Vector3d
  center(int x, int y) const
  {
    return origin + voxel_size * Eigen::Vector3d(x + 0.5, y + 0.5, 0.5);
  }
};

/** \brief The rooms of a storey on its map. */
struct MappedRooms {
  PixelMap<std::uint8_t> blocked;     ///< 1 = wall or lintel below the ceiling
  PixelMap<float> field;              ///< distance to the next wall, metres; 0 = wall
  PixelMap<std::int32_t> free_labels; ///< room of each free pixel, 1 ... n; 0 = none
  PixelMap<std::int32_t> labels;      ///< the same, carried into the walls
  std::int32_t room_count = 0;
  PixelMap<float> potential; ///< of thesis::segmentBuilding(), else empty
  int potential_factor = 1;  ///< pixels of the map per pixel of it, along each axis
};

/** \brief A storey's typical heights in the frame of the grid, metres. */
struct Storey {
  double floor = 0.0;
  double ceiling = 0.0;
};

/** \brief Where the scanner stood, and from where it measured which point. */
struct ScanStations {
  /** All of them, in the frame and unit of the points: what is seen from others would
   * seem to be seen from nowhere. If one is not finite, none tells anything. */
  std::vector<Eigen::Vector3d> positions;
  /** The station of each point, from 1; 0 = not known. Empty: of no point is it known.
   */
  std::vector<std::uint32_t> of_point;

  bool
  empty() const
  {
    return positions.empty();
  }
};

/** \brief A station within a building. */
struct PlacedStation {
  Eigen::Vector3d position; ///< in the building's frame, metres
  int storey = -1;          ///< -1 = beyond the building's extent
  std::uint32_t room = 0;   ///< in which it stands; 0 = in none
};

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
  /** How far its middle lies above the middle between floor and ceiling, metres:
   * negative under a lintel; 0 where less than 0.7 was seen of the end to which it
   * would be nearer. */
  double rise = 0.0;
};

struct BuildingSteps; // private

/** \brief The rooms of a building. */
struct BuildingRooms {
  MapGrid grid;                  ///< of the maps; its voxel size is that of all steps
  std::vector<Storey> heights;   ///< per storey, the lowest first
  std::vector<MappedRooms> maps; ///< per storey; each has its own labels 1 ... n
  std::vector<std::vector<std::uint32_t>> room_of; ///< per storey and label: the room
  std::vector<std::uint32_t> point_labels;         ///< room per point, 0 = none
  std::vector<std::size_t> outside;  ///< points beyond the building's extent, ascending
  std::vector<Room> rooms;           ///< in the order of their labels
  std::vector<RoomOpening> openings; ///< storey by storey, in the order of the rooms
  /** Spaces that are no rooms: far fewer points show them than others, as mirror images
   * behind glass, or hardly a wall, as what is seen through a door. */
  std::size_t hardly_seen = 0;
  /** Spaces that are no rooms: no station stands in them, and none looked into them but
   * through walls and panes. */
  std::size_t never_entered = 0;
  std::vector<PlacedStation> stations;        ///< those that were given, in their order
  std::shared_ptr<const BuildingSteps> steps; ///< null if there are no points
};

/** \brief Find the rooms of a building.
 * \param[in] points finite points near the origin, z up, metres
 * \param[in] progress called before each stage and at the end with 1; may be empty
 * \param[in] stations in the frame of the points, if they are known
 * \return nothing at all (no storeys, no labels) if \a progress returned false or there
 * are no points
 * \throws pcl::BadArgumentException if an option is out of range
 */
PCL_INDOOR_EXPORTS BuildingRooms
segmentBuilding(const std::vector<Eigen::Vector3f>& points,
                const BuildingRoomsOptions& options = {},
                const ProgressCallback& progress = {},
                const ScanStations& stations = {});

} // namespace pcl::indoor
