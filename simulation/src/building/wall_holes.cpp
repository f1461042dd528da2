/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "building/wall_holes.h"
#include "building/wall_frame.h"
#include "plan/fail_at.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::indoor {

namespace {

constexpr double tolerance =
    0.02; // metres, between an opening and its wall's centre line

struct Match {
  WallHole hole;
  Eigen::Vector2d inwards; // from the wall into the room
  Eigen::Vector2d at;      // middle of the hole on the centre line, at height 0
  double lean = 0.0;       // metres inwards per metre up
};

const char*
nameOf(OpeningKind kind)
{
  switch (kind) {
  case OpeningKind::Door:
    return "doors";
  case OpeningKind::Window:
    return "windows";
  default:
    return "passages";
  }
}

[[noreturn]] void
fail(const std::string& source,
     const StoreyPlan& storey,
     const OpeningPlan& opening,
     const std::string& problem)
{
  failAt(source, nameOf(opening.kind), storey, "one", opening.at, problem);
}

// All walls whose centre line the opening lies on, whatever their height.
std::vector<Match>
wallsAt(const OpeningPlan& opening,
        const std::vector<RoomInfo>& rooms,
        double half_thickness,
        double floor)
{
  std::vector<Match> matches;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const double low = floor + opening.sill;
    for (std::size_t e = 0; e < rooms[r].polygon.size(); ++e) {
      const auto wall = wallFrame(rooms[r], e);
      const Eigen::Vector2d from_start = opening.at - wall.at(0, 0);
      const double middle = from_start.dot(wall.along);
      const double off = from_start.dot(wall.inwards) + half_thickness;
      if (std::abs(off) > tolerance || middle < wall.first(low) ||
          middle > wall.last(low))
        continue;
      Match match;
      match.hole = {static_cast<int>(r),
                    static_cast<int>(e),
                    middle - opening.width / 2,
                    middle + opening.width / 2,
                    low,
                    low + opening.height};
      match.inwards = wall.inwards;
      match.at = opening.at - off * wall.inwards;
      match.lean = wall.lean;
      matches.push_back(match);
    }
  }
  return matches;
}

bool
isWithinWall(const RoomInfo& room, const WallHole& hole)
{
  const auto wall = wallFrame(room, hole.edge);
  return hole.s0 >= std::max(wall.first(hole.z0), wall.first(hole.z1)) - 1e-9 &&
         hole.s1 <= std::min(wall.last(hole.z0), wall.last(hole.z1)) + 1e-9;
}

// The lowest ceiling over the hole.
double
ceilingOver(const RoomInfo& room, const WallHole& hole)
{
  const auto wall = wallFrame(room, hole.edge);
  double lowest = std::numeric_limits<double>::infinity();
  for (const double s : {hole.s0, (hole.s0 + hole.s1) / 2, hole.s1})
    lowest = std::min(lowest, room.ceiling.heightAt(wall.at(s, hole.z1)));
  return room.floor + lowest;
}

bool
isHighEnough(const RoomInfo& room, const WallHole& hole)
{
  return room.floor <= hole.z0 + tolerance && ceilingOver(room, hole) >= hole.z1;
}

std::vector<Match>
requireFitting(const std::vector<Match>& matches,
               const std::vector<RoomInfo>& rooms,
               const std::string& source,
               const StoreyPlan& storey,
               const OpeningPlan& opening)
{
  if (matches.empty())
    fail(source, storey, opening, "lies in no wall");
  std::vector<Match> fitting;
  for (const auto& match : matches)
    if (isHighEnough(rooms[match.hole.room], match.hole))
      fitting.push_back(match);
  if (fitting.empty())
    fail(source,
         storey,
         opening,
         "reaches above the ceiling of room '" + rooms[matches[0].hole.room].name +
             "'");
  for (const auto& match : fitting) {
    const auto& hole = match.hole;
    if (!isWithinWall(rooms[hole.room], hole))
      fail(source,
           storey,
           opening,
           "is wider than its wall in room '" + rooms[hole.room].name + "'");
  }
  if (fitting.size() > 2 ||
      (fitting.size() == 2 && fitting[0].inwards.dot(fitting[1].inwards) > -0.999))
    fail(source, storey, opening, "lies in more than one wall");
  return fitting;
}

// Which of the fitting walls belongs to the room that the leaf turns into.
std::size_t
frontOf(const std::vector<Match>& fitting,
        const std::vector<RoomInfo>& rooms,
        const std::string& source,
        const StoreyPlan& storey,
        const OpeningPlan& opening)
{
  for (std::size_t i = 0; i < fitting.size(); ++i)
    if (rooms[fitting[i].hole.room].name == opening.into)
      return i;
  if (!opening.into.empty())
    fail(source, storey, opening, "is not in a wall of room '" + opening.into + "'");
  const auto area = [&](std::size_t i) {
    return signedArea(rooms[fitting[i].hole.room].polygon);
  };
  return fitting.size() == 2 && area(1) < area(0) ? 1 : 0;
}

bool
meet(const WallHole& a, const WallHole& b)
{
  return a.room == b.room && a.edge == b.edge && a.s0 < b.s1 && b.s0 < a.s1 &&
         a.z0 < b.z1 && b.z0 < a.z1;
}

} // namespace

WallHoles
placeOpenings(const Plan& plan,
              const std::vector<RoomInfo>& rooms,
              const std::string& source)
{
  WallHoles result;
  for (std::size_t s = 0; s < plan.storeys.size(); ++s) {
    const auto& storey = plan.storeys[s];
    for (const auto& opening : storey.openings) {
      const auto fitting = requireFitting(
          wallsAt(opening, rooms, plan.wall_thickness / 2, storey.elevation),
          rooms,
          source,
          storey,
          opening);
      for (const auto& match : fitting) {
        for (const auto& other : result.holes)
          if (meet(match.hole, other))
            fail(source, storey, opening, "overlaps another opening");
        result.holes.push_back(match.hole);
      }
      const std::size_t front = frontOf(fitting, rooms, source, storey, opening);
      PlacedOpening placed;
      placed.plan = opening;
      placed.storey = static_cast<int>(s);
      const auto& wall = fitting[front];
      const double low = storey.elevation + opening.sill;
      placed.origin << wall.at + low * wall.lean * wall.inwards, low;
      placed.lean = wall.lean;
      placed.towards = fitting[front].inwards;
      placed.along = Eigen::Vector2d(placed.towards.y(), -placed.towards.x());
      placed.front_room = fitting[front].hole.room;
      if (fitting.size() == 2)
        placed.back_room = fitting[1 - front].hole.room;
      result.openings.push_back(placed);
    }
  }
  return result;
}

} // namespace pcl::indoor
