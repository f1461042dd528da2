/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "building/room_shell.h"
#include "building/ceiling_facets.h"
#include "building/wall_frame.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl::indoor {

namespace {

using Face = ShellPiece::Face;

// The border of a facet, in the plane of a wall.
HalfPlane
onWall(const WallFrame& wall, const HalfPlane& border)
{
  const Eigen::Vector2d origin = wall.at(0, 0), up = wall.lean * wall.inwards;
  return {{border.normal.dot(wall.along), border.normal.dot(up)},
          border.offset - border.normal.dot(origin)};
}

// What lies below a facet's plane, in the plane of a wall.
HalfPlane
belowOnWall(const WallFrame& wall, const CeilingPlane& plane)
{
  const Eigen::Vector2d origin = wall.at(0, 0), up = wall.lean * wall.inwards;
  return {{-plane.slope.dot(wall.along), 1.0 - plane.slope.dot(up)},
          wall.floor + plane.heightAt(origin)};
}

// A rectangle of the wall's plane, as far as it belongs to the room.
void
addWallPiece(std::vector<ShellPiece>& pieces,
             const WallFrame& wall,
             const std::vector<CeilingFacet>& facets,
             const Polygon& rectangle)
{
  for (const auto& facet : facets) {
    Polygon piece = rectangle;
    const double f = wall.floor;
    piece = clip(piece, {{-1.0, wall.first_drift}, wall.first_drift * f});
    piece = clip(piece, {{1.0, -wall.last_drift}, wall.length - wall.last_drift * f});
    for (const auto& border : facet.borders)
      piece = clip(piece, onWall(wall, border));
    piece = clip(piece, belowOnWall(wall, facet.plane));
    std::vector<Eigen::Vector3d> corners;
    for (const auto& p : piece) {
      const Eigen::Vector2d at = wall.at(p.x(), p.y());
      corners.emplace_back(at.x(), at.y(), p.y());
    }
    addFace(pieces, Face::Wall, corners);
  }
}

// One wall: strips between the ends of the holes, each cut at its holes.
void
addWall(std::vector<ShellPiece>& pieces,
        const WallFrame& wall,
        const std::vector<CeilingFacet>& facets,
        double top,
        std::vector<WallHole> holes)
{
  std::sort(holes.begin(), holes.end(), [](const auto& p, const auto& q) {
    return p.z0 < q.z0;
  });
  const double first = std::min(0.0, wall.first(top));
  const double last = std::max(wall.length, wall.last(top));
  std::vector<double> cuts{first, last};
  for (const auto& hole : holes) {
    cuts.push_back(std::clamp(hole.s0, first, last));
    cuts.push_back(std::clamp(hole.s1, first, last));
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double s0 = cuts[i], s1 = cuts[i + 1], middle = (s0 + s1) / 2;
    if (s1 - s0 < 1e-9)
      continue;
    const auto add = [&](double low, double high) {
      addWallPiece(
          pieces, wall, facets, {{s1, low}, {s0, low}, {s0, high}, {s1, high}});
    };
    double low = wall.floor;
    for (const auto& hole : holes)
      if (hole.s0 < middle && middle < hole.s1) {
        if (hole.z0 > low)
          add(low, hole.z0);
        low = hole.z1;
      }
    add(low, top);
  }
}

// A facet's plane, as far as the walls reach: where each corner's line meets it.
Polygon
wallsMeet(const RoomInfo& room, const CeilingPlane& plane)
{
  Polygon corners;
  for (std::size_t i = 0; i < room.polygon.size(); ++i) {
    const auto &p = room.polygon[i], &drift = room.drift[i];
    corners.push_back(p + plane.heightAt(p) / (1.0 - plane.slope.dot(drift)) * drift);
  }
  return corners;
}

std::vector<Polygon>
withoutHoles(const Polygon& convex, const std::vector<Polygon>& holes)
{
  std::vector<Polygon> pieces{convex};
  for (const auto& hole : holes) {
    std::vector<Polygon> rest;
    for (const auto& piece : pieces)
      for (auto& left : subtract(piece, hole))
        rest.push_back(std::move(left));
    pieces = rest;
  }
  return pieces;
}

void
addFloor(std::vector<ShellPiece>& pieces,
         const RoomInfo& room,
         const Polygon& triangle,
         const std::vector<Polygon>& holes)
{
  for (const auto& piece : withoutHoles(triangle, holes)) {
    std::vector<Eigen::Vector3d> corners;
    for (const auto& p : piece)
      corners.emplace_back(p.x(), p.y(), room.floor);
    addFace(pieces, Face::Floor, corners);
  }
}

void
addCeiling(std::vector<ShellPiece>& pieces,
           const RoomInfo& room,
           const CeilingFacet& facet,
           Polygon triangle,
           const std::vector<Polygon>& holes)
{
  for (const auto& border : facet.borders)
    triangle = clip(triangle, border);
  for (const auto& piece : withoutHoles(triangle, holes)) {
    std::vector<Eigen::Vector3d> corners;
    for (std::size_t i = 0; i < piece.size(); ++i) { // seen from below
      const auto& p = piece[(piece.size() - i) % piece.size()];
      corners.emplace_back(p.x(), p.y(), room.floor + facet.plane.heightAt(p));
    }
    addFace(pieces, Face::Ceiling, corners);
  }
}

} // namespace

void
addFace(std::vector<ShellPiece>& pieces,
        ShellPiece::Face face,
        const std::vector<Eigen::Vector3d>& corners)
{
  constexpr double smallest = 1e-9; // square metres: nothing but rounding
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const auto &a = corners[0], &b = corners[i], &c = corners[i + 1];
    if ((b - a).cross(c - a).norm() > smallest)
      pieces.push_back({{a.cast<float>(), b.cast<float>(), c.cast<float>()}, face});
  }
}

std::vector<ShellPiece>
roomShell(const RoomInfo& room, const ShellHoles& holes)
{
  std::vector<ShellPiece> pieces;
  const auto& polygon = room.polygon;
  const auto facets = ceilingFacets(room.ceiling);
  std::vector<Polygon> above;
  std::vector<std::vector<std::array<int, 3>>> triangles;
  double top = room.floor;
  for (const auto& facet : facets) {
    above.push_back(wallsMeet(room, facet.plane));
    triangles.push_back(triangulate(above.back()));
    for (const auto& p : above.back())
      top = std::max(top, room.floor + facet.plane.heightAt(p) + 1);
  }
  const auto floor = triangulate(polygon);
  for (std::size_t i = 0; i < floor.size(); ++i) {
    const auto corner = [i](const Polygon& of, const auto& list) {
      return Polygon{of[list[i][0]], of[list[i][1]], of[list[i][2]]};
    };
    addFloor(pieces, room, corner(polygon, floor), holes.floor);
    for (std::size_t k = 0; k < facets.size(); ++k)
      addCeiling(
          pieces, room, facets[k], corner(above[k], triangles[k]), holes.ceiling);
  }
  for (std::size_t e = 0; e < polygon.size(); ++e) {
    std::vector<WallHole> here;
    for (const auto& hole : holes.walls)
      if (hole.edge == static_cast<int>(e))
        here.push_back(hole);
    addWall(pieces, wallFrame(room, e), facets, top, here);
  }
  const auto steps = ceilingSteps(room);
  pieces.insert(pieces.end(), steps.begin(), steps.end());
  return pieces;
}

std::vector<ShellPiece>
reveal(const PlacedOpening& opening, double y)
{
  std::vector<ShellPiece> pieces;
  const double x = opening.plan.width / 2, z = opening.plan.height;
  const auto at = [&](double px, double py, double pz) {
    const Eigen::Vector2d p = opening.origin.head<2>() + px * opening.along +
                              (py + pz * opening.lean) * opening.towards;
    return Eigen::Vector3d(p.x(), p.y(), opening.origin.z() + pz);
  };
  const double y0 = std::min(y, 0.0), y1 = std::max(y, 0.0);
  const bool threshold = opening.plan.sill < 0.05; // metres: a step, not a parapet
  addFace(pieces,
          threshold ? Face::Floor : Face::Wall,
          {at(-x, y0, 0), at(x, y0, 0), at(x, y1, 0), at(-x, y1, 0)});
  addFace(
      pieces, Face::Wall, {at(-x, y1, z), at(x, y1, z), at(x, y0, z), at(-x, y0, z)});
  addFace(
      pieces, Face::Wall, {at(-x, y0, 0), at(-x, y1, 0), at(-x, y1, z), at(-x, y0, z)});
  addFace(pieces, Face::Wall, {at(x, y1, 0), at(x, y0, 0), at(x, y0, z), at(x, y1, z)});
  return pieces;
}

} // namespace pcl::indoor
