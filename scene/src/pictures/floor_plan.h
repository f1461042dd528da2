/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/plan_polygon.h"

#include <pcl/indoor/exports.h>
#include <pcl/model/building_model.h>
#include <pcl/segmentation/building_rooms.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

constexpr double widest_door = 1.3; // metres, of one leaf: wider ones are passages

using PlanLine = std::pair<Eigen::Vector2d, Eigen::Vector2d>;

/** \brief A room as it is drawn. */
struct PlanRoom {
  std::uint32_t label = 0;
  double area = 0.0;     ///< m^2
  Eigen::Vector2d place; ///< of its number: where it is about widest
  std::vector<std::vector<Eigen::Vector2d>> rings; ///< counter-clockwise, holes not
  std::string name; ///< what it is for; empty = not known
};

/** \brief A door or a wider passage. */
struct PlanOpening {
  std::size_t number = 0; ///< of the building's openings, from 1
  double width = 0.0;
  Eigen::Vector2d middle;
  Eigen::Vector2d along; ///< the wall, unit length
  Eigen::Vector2d into;  ///< the smaller room, across the wall, unit length
  bool is_door = true;   ///< not wider than a door with one leaf

  /** \brief The ends of the threshold; a leaf would hang at the first. */
  PlanLine
  threshold() const;

  /** \brief The end of a leaf that is open by a right angle. */
  Eigen::Vector2d
  leafEnd() const;
};

/** \brief A piece of a wall from above, or a window in it. */
struct PlanBar {
  PlanLine axis;
  double thickness = 0.0; ///< metres

  /** \brief Counter-clockwise. */
  PlanRing
  corners() const;
};

/** \brief An object from above. */
struct PlanObject {
  std::uint32_t number = 0;             ///< of the object, from 1
  std::uint32_t storey = 0;             ///< that it is drawn on
  std::vector<Eigen::Vector2d> corners; ///< of its box, counter-clockwise
};

struct StoreyPlan {
  std::vector<PlanRoom> rooms;
  std::vector<PlanLine> walls; ///< sides of the rooms, but for openings
  std::vector<PlanOpening> openings;
  std::vector<PlanObject> objects;
  std::vector<PlanBar> bodies;           ///< walls of known thickness, but for openings
  std::vector<PlanBar> windows;          ///< across their walls
  std::vector<Eigen::Vector2d> stations; ///< where the scanner stood
};

/** \brief Add a wall to a storey whose openings are known: what of it is beside them.
 */
void
addWall(const PlanBar& wall, StoreyPlan& storey);

/** \brief Add a window to a storey.
 * \param[in] along the wall, unit length
 * \param[in] thickness of the wall; 0 = not known
 */
void
addWindow(const Eigen::Vector2d& middle,
          const Eigen::Vector2d& along,
          double width,
          double thickness,
          StoreyPlan& storey);

/** \brief The sides of a storey's rooms, but for its openings. */
std::vector<PlanLine>
planWalls(const StoreyPlan& storey);

/** \brief A building as it is drawn: metres, y up, in the building's frame. */
struct FloorPlan {
  Eigen::AlignedBox2d box; ///< of all storeys
  std::vector<StoreyPlan> storeys;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero(); ///< add it to get the scan's places
};

/** \brief Footprints as walls, openings as gaps in them, and where to write.
 * Which way a door opens is not known; it is drawn as opening into the smaller room.
 * \param[in] objects may be empty
 */
PCL_INDOOR_EXPORTS FloorPlan
floorPlan(const BuildingRooms& building, const std::vector<PlanObject>& objects = {});

/** \brief Write what rooms are for into the plan.
 * \param[in] names of room 1, 2, ...; empty = not known
 */
PCL_INDOOR_EXPORTS void
addNames(const std::vector<std::string>& names, FloorPlan& plan);

/** \brief Add walls with their thickness and windows to the plan of the same building.
 */
PCL_INDOOR_EXPORTS void
addModel(const BuildingModel& model, FloorPlan& plan);

} // namespace pcl::indoor::tool
