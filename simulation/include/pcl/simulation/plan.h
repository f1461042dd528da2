/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

#include <cstdint>

#include <pcl/exceptions.h>

namespace pcl {
namespace indoor {

/** \brief A plan that cannot be built; what() names the file, the key and the value. */
class PlanError : public BadArgumentException {
public:
  explicit PlanError(const std::string& message)
  : BadArgumentException(message)
  , message_(message)
  {}

  const char*
  what() const noexcept override
  {
    return message_.c_str();
  }

private:
  std::string message_;
};

/** \brief A ceiling: height above the floor at one point, and how it rises from there.
 */
struct CeilingPlan {
  double height = 2.8; ///< metres above the floor at \a at
  Eigen::Vector2d slope =
      Eigen::Vector2d::Zero();                  ///< metres of rise per metre in x and y
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< where \a height is measured

  double
  heightAt(const Eigen::Vector2d& point) const
  {
    return height + slope.dot(point - at);
  }
};

/** \brief A room: the centre lines of its walls, counter-clockwise, in metres. */
struct RoomPlan {
  std::string name;
  std::vector<Eigen::Vector2d> polygon;
  CeilingPlan ceiling;
};

enum class OpeningKind { Door, Window, Passage };

/** \brief A hole in a wall: a door with leaf, a window with glass, or an empty passage.
 */
struct OpeningPlan {
  OpeningKind kind = OpeningKind::Door;
  Eigen::Vector2d at =
      Eigen::Vector2d::Zero(); ///< middle of the hole, on a centre line
  double width = 0.9;          ///< metres
  double height = 2.05;        ///< metres, from sill to lintel
  double sill = 0.0;           ///< metres above the floor of the storey
  double leaf_angle = 0.0;     ///< doors: radians, 0 closed
  std::string into;       ///< doors: room the leaf turns into; empty: the smaller one
  bool hinge_left = true; ///< doors: hinge on the left seen from the room \a into
};

/** \brief A piece of furniture; size and parts are drawn from the seed. */
struct FurniturePlan {
  std::string category;
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< middle of its footprint, metres
  double rotation = 0.0;               ///< radians, counter-clockwise, 0 faces +y
  std::optional<double> elevation;     ///< metres above the floor of the storey
  std::optional<Eigen::Vector3d> size; ///< width, depth, height, metres
  std::optional<std::uint32_t> seed;   ///< default: from the plan's seed
};

struct StoreyPlan {
  std::string name;
  double elevation = 0.0; ///< height of the floor, metres
  std::vector<RoomPlan> rooms;
  std::vector<OpeningPlan> openings;
  std::vector<FurniturePlan> furniture;
};

/** \brief Description of a building, as read from a plan file (docs/simulation.md). */
struct Plan {
  std::string name;
  double wall_thickness = 0.2; ///< metres
  std::uint32_t seed = 1;
  std::vector<StoreyPlan> storeys;
  std::vector<Eigen::Vector3d> trajectory; ///< sensor positions; empty: automatic
};

/** \brief Read a plan from JSON text.
 * \param[in] text the JSON document
 * \param[in] source what error messages call the document, for example its file name
 * \throws PlanError if the text is no JSON, a key is missing, unknown or of the wrong
 * type, or the values contradict each other
 */
Plan
parsePlan(const std::string& text, const std::string& source);

/** \brief Read a plan file.
 * \throws PlanError if the file cannot be read, and as parsePlan()
 */
Plan
readPlan(const std::string& file_name);

} // namespace indoor
} // namespace pcl
