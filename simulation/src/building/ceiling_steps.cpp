/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "building/ceiling_facets.h"
#include "building/room_shell.h"

#include <algorithm>

namespace pcl::indoor {

namespace {

// An upright plane over a way on the floor: u along the way, z up.
struct UprightPlane {
  Eigen::Vector2d start, along;
  double length = 0.0, floor = 0.0;

  Eigen::Vector2d
  at(double u) const
  {
    return start + u * along;
  }

  // On a parallel line, so much to the left.
  HalfPlane
  restricted(const HalfPlane& border, double left = 0.0) const
  {
    const Eigen::Vector2d beside =
        start + left * Eigen::Vector2d(-along.y(), along.x());
    return {{border.normal.dot(along), 0.0}, border.offset - border.normal.dot(beside)};
  }

  HalfPlane
  below(const CeilingPlane& plane) const
  {
    return {{-plane.slope.dot(along), 1.0}, floor + plane.heightAt(start)};
  }
};

HalfPlane
opposite(const HalfPlane& half_plane)
{
  return {-half_plane.normal, -half_plane.offset};
}

// What is seen of the upright plane from the higher facet, within one piece of room.
void
addStep(std::vector<ShellPiece>& pieces,
        const UprightPlane& plane,
        Polygon step,
        const CeilingFacet& higher,
        const CeilingFacet& lower,
        const Polygon& room_piece,
        bool higher_on_left)
{
  constexpr double beside = 1e-6; // metres: more than rounding
  const double left = higher_on_left ? beside : -beside;
  for (const auto& border : higher.borders)
    step = clip(step, plane.restricted(border, left));
  for (const auto& border : lower.borders)
    step = clip(step, plane.restricted(border, -left));
  step = clip(step, plane.below(higher.plane));
  step = clip(step, opposite(plane.below(lower.plane)));
  for (std::size_t i = 0; i < room_piece.size(); ++i)
    step = clip(step,
                plane.restricted(
                    leftOf(room_piece[i], room_piece[(i + 1) % room_piece.size()])));
  std::vector<Eigen::Vector3d> corners;
  for (const auto& p : step) {
    const Eigen::Vector2d at = plane.at(p.x());
    corners.emplace_back(at.x(), at.y(), p.y());
  }
  if (higher_on_left) // u to the right, z up: the corners run around the right side
    std::reverse(corners.begin(), corners.end());
  addFace(pieces, ShellPiece::Face::Ceiling, corners);
}

} // namespace

std::vector<ShellPiece>
ceilingSteps(const RoomInfo& room)
{
  std::vector<ShellPiece> pieces;
  const auto facets = ceilingFacets(room.ceiling);
  const double top = room.floor + ceilingRange(room.ceiling, room.polygon).second + 1;
  const auto triangles = triangulate(room.polygon);
  for (const auto& inner : facets)
    for (std::size_t e = 0; inner.part >= 0; ++e) {
      const auto& polygon = room.ceiling.parts[inner.part].polygon;
      if (e == polygon.size())
        break;
      const auto& a = polygon[e];
      const Eigen::Vector2d way = polygon[(e + 1) % polygon.size()] - a;
      const UprightPlane plane{a, way.normalized(), way.norm(), room.floor};
      const Polygon all{
          {0, room.floor}, {plane.length, room.floor}, {plane.length, top}, {0, top}};
      for (const auto& outer : facets) {
        if (outer.part >= 0 && outer.part <= inner.part)
          continue; // the same part, or one that has met this one already
        for (const auto& t : triangles) {
          const Polygon piece{
              room.polygon[t[0]], room.polygon[t[1]], room.polygon[t[2]]};
          addStep(pieces, plane, all, inner, outer, piece, true);
          addStep(pieces, plane, all, outer, inner, piece, false);
        }
      }
    }
  return pieces;
}

} // namespace pcl::indoor
