/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "building/leaning_walls.h"

#include "internal/cross.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl::indoor {

namespace {

constexpr double line_tolerance =
    0.02; // metres, between a wall and a leaning wall's line

struct Edge {
  Eigen::Vector2d a, b;

  Eigen::Vector2d
  along() const
  {
    return (b - a).normalized();
  }

  Eigen::Vector2d
  inwards() const
  {
    return {-along().y(), along().x()};
  }
};

Edge
edgeOf(const Polygon& polygon, std::size_t i)
{
  return {polygon[i], polygon[(i + 1) % polygon.size()]};
}

// Metres of the edge that lie on the wall's line, between its ends.
double
covered(const Edge& edge, const LeaningWallPlan& wall)
{
  const double length = (wall.to - wall.from).norm();
  const Eigen::Vector2d along = (wall.to - wall.from) / length;
  const Eigen::Vector2d across(-along.y(), along.x());
  if (std::abs((edge.a - wall.from).dot(across)) > line_tolerance ||
      std::abs((edge.b - wall.from).dot(across)) > line_tolerance)
    return 0.0;
  const double a = (edge.a - wall.from).dot(along), b = (edge.b - wall.from).dot(along);
  return std::min(std::max(a, b), length) - std::max(std::min(a, b), 0.0);
}

bool
covers(const LeaningWallPlan& wall, const Edge& edge)
{
  return covered(edge, wall) >= (edge.b - edge.a).norm() - 2 * line_tolerance;
}

std::string
nameOf(const LeaningWallPlan& wall)
{
  std::ostringstream text;
  text << "leaning_walls: the one from (" << wall.from.x() << ", " << wall.from.y()
       << ") to (" << wall.to.x() << ", " << wall.to.y() << ")";
  return text.str();
}

// Metres inwards per metre up of one wall of a room, beside the building's lean.
double
leanOf(const Plan& plan,
       const RoomPlan& room,
       const Edge& edge,
       const std::string& source)
{
  for (const auto& wall : plan.leaning_walls) {
    if (covered(edge, wall) <= 2 * line_tolerance)
      continue;
    if (!covers(wall, edge))
      throw PlanError(source + ": " + nameOf(wall) +
                      " covers only a part of a wall of room '" + room.name + "'");
    const double side = (wall.to - wall.from).dot(edge.along()) > 0 ? 1.0 : -1.0;
    return side * std::tan(wall.angle) - driftOf(plan).dot(edge.inwards());
  }
  return 0.0;
}

} // namespace

Eigen::Vector2d
driftOf(const Plan& plan)
{
  const LeanPlan lean = plan.lean.value_or(LeanPlan());
  return std::tan(lean.angle) *
         Eigen::Vector2d(std::cos(lean.towards), std::sin(lean.towards));
}

std::vector<Eigen::Vector2d>
cornerDrifts(const Plan& plan, const RoomPlan& room, const std::string& source)
{
  const std::size_t n = room.polygon.size();
  std::vector<double> lean;
  for (std::size_t e = 0; e < n; ++e)
    lean.push_back(leanOf(plan, room, edgeOf(room.polygon, e), source));
  std::vector<Eigen::Vector2d> drifts(n, Eigen::Vector2d::Zero());
  for (std::size_t i = 0; i < n; ++i) {
    const double before = lean[(i + n - 1) % n], after = lean[i];
    if (before == 0 && after == 0)
      continue;
    const Eigen::Vector2d m = edgeOf(room.polygon, (i + n - 1) % n).inwards();
    const Eigen::Vector2d k = edgeOf(room.polygon, i).inwards();
    const double sine = crossOf(m, k);
    if (std::abs(sine) > 1e-6) // the corner of both leaning lines
      drifts[i] = Eigen::Vector2d(before * k.y() - after * m.y(),
                                  after * m.x() - before * k.x()) /
                  sine;
    else if (std::abs(before - after) < 1e-6)
      drifts[i] = before * m;
    else {
      std::ostringstream place;
      place << "(" << room.polygon[i].x() << ", " << room.polygon[i].y() << ")";
      throw PlanError(source + ": leaning_walls: two walls of room '" + room.name +
                      "' that run on straight lean apart at " + place.str());
    }
  }
  return drifts;
}

void
requireLeaningWallsUsed(const Plan& plan, const std::string& source)
{
  for (const auto& wall : plan.leaning_walls) {
    bool used = false;
    for (const auto& storey : plan.storeys)
      for (const auto& room : storey.rooms)
        for (std::size_t e = 0; e < room.polygon.size(); ++e)
          used |= covers(wall, edgeOf(room.polygon, e));
    if (!used)
      throw PlanError(source + ": " + nameOf(wall) + " lies on no wall");
  }
}

} // namespace pcl::indoor
