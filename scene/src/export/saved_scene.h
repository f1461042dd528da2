/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/plan_polygon.h"

#include <pcl/indoor/exports.h>
#include <pcl/model/building_model.h>
#include <pcl/segmentation/building_frame.h>
#include <pcl/segmentation/room_objects.h>

#include <nlohmann/json.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A storey of a scene file. */
struct SavedStorey {
  double floor = 0.0;   ///< height, metres
  double ceiling = 0.0; ///< height, metres
};

/** \brief A room of a scene file. */
struct SavedRoom {
  std::uint32_t number = 0; ///< from 1
  std::uint32_t storey = 0;
  double area = 0.0;           ///< m^2
  double height = 0.0;         ///< metres
  double volume = 0.0;         ///< m^3
  double floor = 0.0;          ///< height, metres
  std::vector<PlanRing> rings; ///< counter-clockwise, holes not
  std::string name;            ///< what it is for; empty = not known
  double name_probability = 0.0;
};

/** \brief A wall of a scene file. */
struct SavedWall {
  std::uint32_t number = 0; ///< from 1
  std::uint32_t storey = 0;
  Eigen::Vector2d begin, end; ///< of its axis; of one side if only that was seen, the
                              ///< room on the left
  double floor = 0.0;         ///< height of its foot, metres
  double height = 0.0;        ///< metres
  double thickness = 0.0;     ///< metres; 0 = not known
};

/** \brief A column of a scene file. */
struct SavedColumn {
  std::uint32_t number = 0; ///< from 1
  std::uint32_t storey = 0;
  Eigen::Vector3d foot;  ///< middle of its foot
  Eigen::Vector3d size;  ///< length, width, height, metres
  double yaw = 0.0;      ///< of its length, radians
  bool is_round = false; ///< its length and width are the diameter
};

/** \brief An opening of a scene file. */
struct SavedOpening {
  std::uint32_t number = 0; ///< from 1
  ModelOpeningKind kind = ModelOpeningKind::Door;
  std::uint32_t room_a = 0, room_b = 0; ///< 0 = outside
  std::uint32_t storey = 0;
  std::size_t wall = 0;     ///< place in the list of walls; its size = in none
  Eigen::Vector3d position; ///< middle of the lower edge
  double width = 0.0;       ///< metres
  double height = 0.0;      ///< metres
  double sill = 0.0;        ///< metres
  bool is_open = true;      ///< a person can pass, as it was scanned
};

/** \brief An object of a scene file. */
struct SavedObject {
  std::uint32_t number = 0; ///< from 1
  std::uint32_t room = 0;   ///< 0 = none
  std::uint32_t storey = 0; ///< of its room; without one, that of its lower end
  bool is_structure = false;
  std::string name;        ///< of its class; empty = none
  double confidence = 0.0; ///< of its class
  UprightBox box;
};

/** \brief What a scene file holds: metres, z up. Of upright scans the directions are
 * those of the file. */
struct SavedScene {
  int version = 0;
  std::string input;      ///< name of the scan
  Eigen::Vector3d origin; ///< what to add to places to get those of the file, metres
  BuildingFrame frame;    ///< in whose upright frame places are
  std::vector<SavedStorey> storeys;
  std::vector<SavedRoom> rooms; ///< room i + 1 is the i-th
  std::vector<SavedWall> walls; ///< none of version 1
  std::vector<SavedColumn> columns;
  std::vector<SavedOpening> openings;
  std::vector<SavedObject> objects;
};

/** \brief The highest storey whose floor is below a height, or little above it; 0 if
 * there is none. */
std::uint32_t
storeyAt(double height, const std::vector<SavedStorey>& storeys);

/** \brief A column seen from above; a round one has 24 sides. */
PlanRing
outlineOf(const SavedColumn& column);

/** \brief Take a scene apart, as readScene() gives it.
 * \throws nlohmann::json::exception if a field is missing or of another type
 * \throws ToolError if a number refers to nothing or is out of range
 */
PCL_INDOOR_EXPORTS SavedScene
savedScene(const nlohmann::ordered_json& scene);

/** \brief Read scene.json.
 * \throws ToolError naming the file and the reason, if it is no whole scene
 */
PCL_INDOOR_EXPORTS SavedScene
readSavedScene(const std::string& path);

} // namespace pcl::indoor::tool
