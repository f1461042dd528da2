/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/simulation/polygon.h>

#include <optional>
#include <string>
#include <vector>

#include <cstdint>

#include <pcl/exceptions.h>

namespace pcl::indoor {

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

/** \brief A flat ceiling: height above the floor at one point, and how it rises. */
struct CeilingPlane {
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

/** \brief A part of a room with a ceiling of its own. */
struct CeilingPart {
  Polygon polygon;                  ///< convex, counter-clockwise, metres
  std::vector<CeilingPlane> planes; ///< of which the lowest counts, at least one
};

/** \brief The ceiling of a room: a roof or vault is the lowest of several planes. */
struct PCL_INDOOR_EXPORTS CeilingPlan {
  std::vector<CeilingPlane> planes{1}; ///< of which the lowest counts, at least one
  std::vector<CeilingPart> parts;      ///< which do not overlap

  /** \brief Metres above the floor. */
  double
  heightAt(const Eigen::Vector2d& point) const;
};

/** \brief A room: the centre lines of its walls, counter-clockwise, in metres. */
struct RoomPlan {
  std::string name;
  std::string kind; ///< what it is for, a word such as kitchen; empty: not said
  Polygon polygon;
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
  double frame_width = 0.06;   ///< windows: metres, seen from the room
  double frame_depth = 0.08;   ///< windows: metres, at most the wall's thickness
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
  int variant = 0;        ///< which shape of its class, below furnitureVariants()
  std::string room;       ///< that its points belong to; empty: where it stands
  bool half_turn = false; ///< stairs: two flights side by side and a landing
  bool draped = false;    ///< cloth: lies over what is listed before it
};

/** \brief A slab or block to walk on within a room: a mezzanine, a landing, a ramp. */
struct PlatformPlan {
  Polygon polygon;                 ///< counter-clockwise, metres
  CeilingPlane top;                ///< above the floor of the storey
  std::optional<double> thickness; ///< metres; default: down to the floor
  std::string room;                ///< empty: the one where it lies
};

/** \brief A hole in the floor of a storey and in the ceiling below it. */
struct WellPlan {
  Polygon polygon; ///< convex, counter-clockwise, metres
};

struct StoreyPlan {
  std::string name;
  double elevation = 0.0; ///< height of the floor, metres
  std::vector<RoomPlan> rooms;
  std::vector<OpeningPlan> openings;
  std::vector<PlatformPlan> platforms;
  std::vector<WellPlan> wells;
  std::vector<FurniturePlan> furniture;
};

/** \brief A lean of the whole building: nothing moves at height 0. */
struct LeanPlan {
  double angle = 0.0;   ///< radians from the vertical
  double towards = 0.0; ///< radians from +x, counter-clockwise
};

/** \brief A wall that leans: at height 0 its middle line is where it is drawn. */
struct LeaningWallPlan {
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
  double angle = 0.0; ///< radians from the vertical; positive: to the left of the way
};

/** \brief Description of a building, as read from a plan file
 * (docs/guide/plan_files.md). */
struct Plan {
  std::string name;
  double wall_thickness = 0.2; ///< metres
  std::uint32_t seed = 1;
  std::optional<LeanPlan> lean;               ///< of the whole building
  std::vector<LeaningWallPlan> leaning_walls; ///< these do not follow \a lean
  std::vector<StoreyPlan> storeys;
  std::vector<Eigen::Vector3d> trajectory; ///< sensor positions; empty: automatic
};

/** \brief Change by how much a plan's building and its walls lean, if they do; the
 * directions stay.
 * \param[in,out] plan the plan
 * \param[in] angle radians, at least 0
 * \throws PlanError if nothing leans in the plan
 */
PCL_INDOOR_EXPORTS void
setLean(Plan& plan, double angle);

/** \brief Let the whole building lean; no wall leans otherwise. */
PCL_INDOOR_EXPORTS void
setLean(Plan& plan, const LeanPlan& lean);

/** \brief Read a plan from JSON text.
 * \param[in] text the JSON document
 * \param[in] source what error messages call the document, for example its file name
 * \throws PlanError if the text is no JSON, a key is missing, unknown or of the wrong
 * type, or the values contradict each other
 */
PCL_INDOOR_EXPORTS Plan
parsePlan(const std::string& text, const std::string& source);

/** \brief Read a plan file.
 * \throws PlanError if the file cannot be read, and as parsePlan()
 */
PCL_INDOOR_EXPORTS Plan
readPlan(const std::string& file_name);

} // namespace pcl::indoor
