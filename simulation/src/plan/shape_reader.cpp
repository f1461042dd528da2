/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "plan/shape_reader.h"

#include "internal/cross.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

// A line on the floor, as two distinct points.
struct Line {
  Eigen::Vector2d at, across; // a point; the unit vector to its left
};

Line
readLine(const JsonReader& json)
{
  const auto points = json.values();
  if (points.size() != 2)
    json.fail("must be two points");
  const auto a = points[0].vector<2>(), b = points[1].vector<2>();
  if ((b - a).norm() < 0.01)
    json.fail("must be two points that lie apart");
  const Eigen::Vector2d along = (b - a).normalized();
  return {a, Eigen::Vector2d(-along.y(), along.x())};
}

std::vector<CeilingPlane>
readRidge(const JsonReader& json)
{
  json.requireKeys({"ridge", "height", "pitch"});
  const auto ridge = readLine(json.at("ridge"));
  const double height = json.at("height").positive();
  const double pitch = json.at("pitch").number();
  if (!(pitch > 0 && pitch < 85))
    json.at("pitch").fail("must lie between 0 and 85 degrees");
  const Eigen::Vector2d fall = std::tan(pitch * radians_per_degree) * ridge.across;
  return {{height, fall, ridge.at}, {height, -fall, ridge.at}};
}

// The planes through neighbouring lines of the cylinder.
std::vector<CeilingPlane>
readVault(const JsonReader& json)
{
  constexpr int facets = 24; // of a half circle: 7.5 degrees each, off by 0.2 % of it
  json.requireKeys({"vault", "height", "radius"});
  const auto axis = readLine(json.at("vault"));
  const double height = json.at("height").positive();
  const double radius = json.at("radius").positive();
  std::vector<CeilingPlane> planes;
  for (int i = 0; i < facets; ++i) {
    const double a = M_PI * i / facets, b = M_PI * (i + 1) / facets;
    const Eigen::Vector2d p(-radius * std::cos(a), radius * (std::sin(a) - 1));
    const Eigen::Vector2d q(-radius * std::cos(b), radius * (std::sin(b) - 1));
    const double rise = (q.y() - p.y()) / (q.x() - p.x());
    planes.push_back(
        {height + p.y(), rise * axis.across, axis.at + p.x() * axis.across});
  }
  return planes;
}

// The points between two vertices on the circle around a centre.
void
addArc(Polygon& polygon,
       const JsonReader& json,
       const Eigen::Vector2d& from,
       const Eigen::Vector2d& to)
{
  json.requireKeys({"around", "sides", "turn"});
  const auto center = json.at("around").vector<2>();
  const double sides = json.at("sides").positive();
  if (sides != std::floor(sides) || sides < 2 || sides > 360)
    json.at("sides").fail("must be a whole number from 2 to 360");
  const auto turn = json.has("turn") ? json.at("turn").text() : "left";
  if (turn != "left" && turn != "right")
    json.at("turn").fail("must be 'left' or 'right', not '" + turn + "'");
  const Eigen::Vector2d a = from - center, b = to - center;
  if (std::abs(a.norm() - b.norm()) > 0.02)
    json.at("around").fail("is not as far from the vertex before as from the next");
  double angle = std::atan2(crossOf(a, b), a.dot(b));
  if (turn == "left" && angle <= 0)
    angle += 2 * M_PI;
  if (turn == "right" && angle >= 0)
    angle -= 2 * M_PI;
  for (int i = 1; i < sides; ++i) {
    const double share = i / sides;
    const double direction = std::atan2(a.y(), a.x()) + share * angle;
    const double radius = (1 - share) * a.norm() + share * b.norm();
    polygon.push_back(
        center + radius * Eigen::Vector2d(std::cos(direction), std::sin(direction)));
  }
}

} // namespace

Polygon
readPolygon(const JsonReader& json)
{
  Polygon polygon;
  const auto elements = json.values();
  const std::size_t n = elements.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!elements[i].isObject()) {
      polygon.push_back(elements[i].vector<2>());
      continue;
    }
    const auto &before = elements[(i + n - 1) % n], &next = elements[(i + 1) % n];
    if (before.isObject() || next.isObject())
      elements[i].fail("must stand between two vertices");
    addArc(polygon, elements[i], before.vector<2>(), next.vector<2>());
  }
  if (polygon.size() < 3)
    json.fail("needs at least 3 vertices");
  if (crossesItself(polygon))
    json.fail("crosses or touches itself");
  if (signedArea(polygon) < 0)
    std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

Polygon
readConvexPolygon(const JsonReader& json)
{
  const auto polygon = readPolygon(json);
  if (!isConvex(polygon))
    json.fail("must be convex");
  return polygon;
}

CeilingPlane
readPlane(const JsonReader& json)
{
  CeilingPlane plane;
  if (!json.isObject()) {
    plane.height = json.number();
    return plane;
  }
  json.requireKeys({"height", "at", "slope"});
  plane.height = json.at("height").number();
  plane.at = json.at("at").vector<2>();
  plane.slope = json.at("slope").vector<2>();
  return plane;
}

std::vector<CeilingPlane>
readCeiling(const JsonReader& json)
{
  std::vector<CeilingPlane> planes;
  if (json.isList())
    for (const auto& element : json.values())
      for (const auto& plane : readCeiling(element))
        planes.push_back(plane);
  else if (json.isObject() && json.has("ridge"))
    planes = readRidge(json);
  else if (json.isObject() && json.has("vault"))
    planes = readVault(json);
  else {
    planes = {readPlane(json)};
    (json.isObject() ? json.at("height") : json).positive();
  }
  if (planes.empty())
    json.fail("must hold at least one height or plane");
  return planes;
}

} // namespace pcl::indoor
