/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/simulation/plan.h>
#include <pcl/simulation/polygon.h>
#include <pcl/simulation/ray_tracer.h> // for Triangle

#include <string>
#include <vector>

#include <cstdint>

namespace pcl::indoor {

/** \brief What a surface is; 0 means none. */
struct SceneLabels {
  std::uint32_t room = 0;     ///< number of a room of the building
  std::uint32_t object = 0;   ///< number of an object; 0 for walls, floors and ceilings
  std::uint32_t part = 0;     ///< number of a part, counted through the whole building
  std::uint32_t category = 0; ///< number of a name in Building::categories
};

/** \brief How a ray goes on where it meets a surface. */
enum class SurfaceKind : std::uint8_t {
  Solid,         ///< gives an echo
  Shell,         ///< gives an echo from the side of its normal, none from behind
  InteriorGlass, ///< most rays go on behind it
  ExteriorGlass  ///< most rays leave the building
};

struct Surface {
  SceneLabels labels;
  SurfaceKind kind = SurfaceKind::Solid;

  bool
  isGlass() const
  {
    return kind == SurfaceKind::InteriorGlass || kind == SurfaceKind::ExteriorGlass;
  }
};

struct RoomInfo {
  std::string name;
  std::string kind; ///< what it is for; empty: the plan does not say
  std::string storey_name;
  std::uint32_t storey = 0; ///< index into the plan's storeys
  Polygon polygon;          ///< inner faces of the walls at the floor,
                            ///< counter-clockwise, metres
  double floor = 0.0;       ///< height of the floor, metres
  CeilingPlan ceiling;
  /** How each corner moves, metres sideways per metre up: single walls may lean. */
  std::vector<Eigen::Vector2d> drift;

  /** \brief Inner faces of the walls at a height. */
  Polygon
  polygonAt(double z) const
  {
    Polygon moved = polygon;
    for (std::size_t i = 0; i < moved.size(); ++i)
      moved[i] += (z - floor) * drift[i];
    return moved;
  }
};

/** \brief A slab or block to walk on. */
struct PlatformInfo {
  std::uint32_t room = 0;          ///< where it lies
  Polygon polygon;                 ///< counter-clockwise, metres
  CeilingPlane top;                ///< above \a elevation
  double elevation = 0.0;          ///< floor of its storey, metres
  std::optional<double> thickness; ///< none: down to the room's floor
};

/** \brief A hole between two rooms above each other. */
struct WellInfo {
  std::uint32_t upper = 0, lower = 0; ///< numbers of the rooms
  Polygon polygon;                    ///< convex, counter-clockwise, metres
};

struct ObjectInfo {
  std::string category;
  std::uint32_t room = 0;              ///< for a door or window: one of its two rooms
  std::uint32_t stands_in = 0;         ///< the plan may give it to another room
  std::uint32_t first_part = 0;        ///< number of its first part
  std::vector<std::string> part_names; ///< of first_part, first_part + 1, ...
  Eigen::Vector3d position;            ///< middle of its bottom, metres
  Eigen::Vector3d size;                ///< in its own frame, metres
  double rotation = 0.0;               ///< about z, radians
};

/** \brief A way for the sensor through a wall. */
struct Doorway {
  Eigen::Vector3d position; ///< on the floor in the middle of the hole
  double width = 0.0;
  Eigen::Vector2d drift = Eigen::Vector2d::Zero(); ///< sideways per metre up
};

/** \brief A building as triangles, each with its labels.
 *
 * Triangles, objects and doorways are where they are; rooms, platforms and wells are as
 * drawn, before the whole building leans.
 */
struct PCL_INDOOR_EXPORTS Building {
  std::vector<std::string> categories; ///< name of each category number; [0] is "none"
  std::vector<RoomInfo> rooms;         ///< room number i + 1
  std::vector<ObjectInfo> objects;     ///< object number i + 1
  std::vector<Triangle> triangles;     ///< metres
  std::vector<Surface> surfaces;       ///< one for each triangle
  std::vector<Doorway> doorways;       ///< between two rooms, not closed by a leaf
  std::vector<PlatformInfo> platforms;
  std::vector<WellInfo> wells;
  Eigen::Vector2d lean = Eigen::Vector2d::Zero(); ///< metres sideways per metre up

  /** \brief Where a point of the drawn building is. */
  Eigen::Vector3d
  leant(const Eigen::Vector3d& drawn) const
  {
    return drawn + drawn.z() * Eigen::Vector3d(lean.x(), lean.y(), 0.0);
  }

  /** \brief Number of a category.
   * \throws BadArgumentException if there is none of that name
   */
  std::uint32_t
  category(const std::string& name) const;
};

/** \brief Build walls, floors, ceilings, platforms, doors, windows and furniture.
 *
 * Every room gets a shell of its own: its polygon moved inwards by half the thickness
 * of the walls. A hole in a wall joins the shells of both rooms by a reveal, of which
 * each room owns the half on its side; so does a hole in a floor. Furniture stays
 * upright where walls lean, and is moved off walls that lean over it.
 * \param[in] plan the building
 * \param[in] source what error messages call the plan, for example its file name
 * \throws PlanError if rooms overlap, a room vanishes between its walls, an opening
 * lies in no wall, overlaps another or reaches above the ceiling, or furniture stands
 * in no room
 */
PCL_INDOOR_EXPORTS Building
buildBuilding(const Plan& plan, const std::string& source = "plan");

} // namespace pcl::indoor
