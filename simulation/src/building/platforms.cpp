/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "building/platforms.h"

#include "building/ceiling_facets.h"
#include "plan/fail_at.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

using Face = ShellPiece::Face;

constexpr double boundary_tolerance = 0.02; // metres

[[noreturn]] void
fail(const std::string& source,
     const std::string& what,
     const StoreyPlan& storey,
     const Polygon& polygon,
     const std::string& problem)
{
  failAt(source, what, storey, "one with a corner", polygon[0], problem);
}

bool
liesIn(const Polygon& polygon, const Polygon& room)
{
  return std::all_of(polygon.begin(), polygon.end(), [&](const auto& p) {
    return contains(room, p) || distanceToBoundary(room, p) <= boundary_tolerance;
  });
}

// The middle of a convex or compact polygon.
Eigen::Vector2d
middleOf(const Polygon& polygon)
{
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const auto& p : polygon)
    sum += p;
  return sum / static_cast<double>(polygon.size());
}

double
ceilingOf(const RoomInfo& room, const Eigen::Vector2d& at)
{
  return room.floor + room.ceiling.heightAt(at);
}

// The room right below a hole in the floor of room upper; 0: none.
std::uint32_t
roomBelow(const std::vector<RoomInfo>& rooms,
          const RoomInfo& upper,
          const Polygon& polygon)
{
  std::uint32_t below = 0;
  const auto middle = middleOf(polygon);
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const auto& room = rooms[r];
    const double top = ceilingOf(room, middle);
    if (room.floor < upper.floor && top <= upper.floor + 1e-6 &&
        liesIn(polygon, room.polygonAt(top)) &&
        (below == 0 || top > ceilingOf(rooms[below - 1], middle)))
      below = static_cast<std::uint32_t>(r + 1);
  }
  return below;
}

// Is the ceiling over the polygon one plane?
bool
isFlatOver(const CeilingPlan& ceiling, const Polygon& polygon)
{
  const auto middle = middleOf(polygon);
  double sum = 0;
  for (const auto& p : polygon)
    sum += ceiling.heightAt(p);
  if (std::abs(sum / static_cast<double>(polygon.size()) - ceiling.heightAt(middle)) >
      1e-6)
    return false;
  const auto facets = ceilingFacets(ceiling);
  return std::any_of(facets.begin(), facets.end(), [&](const auto& facet) {
    return std::all_of(polygon.begin(), polygon.end(), [&](const auto& p) {
      return std::abs(facet.plane.heightAt(p) - ceiling.heightAt(p)) < 1e-6;
    });
  });
}

double
bottomOf(const PlatformInfo& platform, const RoomInfo& room, const Eigen::Vector2d& at)
{
  return platform.thickness
             ? platform.elevation + platform.top.heightAt(at) - *platform.thickness
             : room.floor;
}

std::uint32_t
roomOfPlatform(const PlatformPlan& platform,
               const std::vector<RoomInfo>& rooms,
               std::size_t storey)
{
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const bool meant = platform.room.empty() ? rooms[r].storey == storey
                                             : rooms[r].name == platform.room;
    if (meant && liesIn(platform.polygon, rooms[r].polygon))
      return static_cast<std::uint32_t>(r + 1);
  }
  return 0;
}

void
requireFitting(const PlatformInfo& platform,
               const RoomInfo& room,
               const StoreyPlan& storey,
               const std::string& source)
{
  for (const auto& p : platform.polygon) {
    const double top = platform.elevation + platform.top.heightAt(p);
    if (top < room.floor - 1e-9 || bottomOf(platform, room, p) < room.floor - 1e-9)
      fail(source, "platforms", storey, platform.polygon, "reaches below the floor");
    if (top > ceilingOf(room, p))
      fail(source, "platforms", storey, platform.polygon, "reaches above the ceiling");
  }
}

} // namespace

std::vector<WellInfo>
placeWells(const Plan& plan,
           const std::vector<RoomInfo>& rooms,
           const std::string& source)
{
  std::vector<WellInfo> wells;
  for (std::size_t s = 0; s < plan.storeys.size(); ++s)
    for (const auto& well : plan.storeys[s].wells) {
      const auto& storey = plan.storeys[s];
      WellInfo info;
      info.polygon = well.polygon;
      for (std::size_t r = 0; r < rooms.size() && info.upper == 0; ++r)
        if (rooms[r].storey == s && liesIn(well.polygon, rooms[r].polygon))
          info.upper = static_cast<std::uint32_t>(r + 1);
      if (info.upper == 0)
        fail(source, "wells", storey, well.polygon, "lies in no room");
      info.lower = roomBelow(rooms, rooms[info.upper - 1], well.polygon);
      if (info.lower == 0)
        fail(source, "wells", storey, well.polygon, "lies above no room");
      if (!isFlatOver(rooms[info.lower - 1].ceiling, well.polygon))
        fail(source, "wells", storey, well.polygon, "lies above an edge of a ceiling");
      for (const auto& other : wells)
        if (other.upper == info.upper && overlap(other.polygon, well.polygon))
          fail(source, "wells", storey, well.polygon, "overlaps another");
      wells.push_back(info);
    }
  return wells;
}

std::vector<PlatformInfo>
placePlatforms(const Plan& plan,
               const std::vector<RoomInfo>& rooms,
               const std::string& source)
{
  std::vector<PlatformInfo> platforms;
  for (std::size_t s = 0; s < plan.storeys.size(); ++s)
    for (const auto& platform : plan.storeys[s].platforms) {
      const auto& storey = plan.storeys[s];
      PlatformInfo info;
      info.room = roomOfPlatform(platform, rooms, s);
      if (info.room == 0)
        fail(source,
             "platforms",
             storey,
             platform.polygon,
             platform.room.empty()
                 ? "does not lie within a room"
                 : "does not lie within room '" + platform.room + "'");
      info.polygon = platform.polygon;
      info.top = platform.top;
      info.elevation = storey.elevation;
      info.thickness = platform.thickness;
      requireFitting(info, rooms[info.room - 1], storey, source);
      platforms.push_back(info);
    }
  return platforms;
}

std::vector<ShellPiece>
wellReveal(const Building& building, const WellInfo& well, bool upper)
{
  std::vector<ShellPiece> pieces;
  const double top = building.rooms[well.upper - 1].floor;
  const auto corner = [&](const Eigen::Vector2d& p, bool high) {
    const double bottom = ceilingOf(building.rooms[well.lower - 1], p);
    const double middle = (bottom + top) / 2;
    const double z = upper ? (high ? top : middle) : (high ? middle : bottom);
    return Eigen::Vector3d(p.x(), p.y(), z);
  };
  for (std::size_t i = 0; i < well.polygon.size(); ++i) {
    const auto& a = well.polygon[i];
    const auto& b = well.polygon[(i + 1) % well.polygon.size()];
    addFace(pieces,
            Face::Wall,
            {corner(b, false), corner(a, false), corner(a, true), corner(b, true)});
  }
  return pieces;
}

std::vector<ShellPiece>
platformShell(const Building& building, const PlatformInfo& platform)
{
  std::vector<ShellPiece> pieces;
  const auto& room = building.rooms[platform.room - 1];
  const auto high = [&](const Eigen::Vector2d& p) {
    return Eigen::Vector3d(p.x(), p.y(), platform.elevation + platform.top.heightAt(p));
  };
  const auto low = [&](const Eigen::Vector2d& p) {
    return Eigen::Vector3d(p.x(), p.y(), bottomOf(platform, room, p));
  };
  const auto& polygon = platform.polygon;
  for (const auto& t : triangulate(polygon)) {
    const auto &a = polygon[t[0]], &b = polygon[t[1]], &c = polygon[t[2]];
    addFace(pieces, Face::Floor, {high(a), high(b), high(c)});
    if (platform.thickness)
      addFace(pieces, Face::Ceiling, {low(c), low(b), low(a)});
  }
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    addFace(pieces, Face::Wall, {low(a), low(b), high(b), high(a)});
  }
  return pieces;
}

} // namespace pcl::indoor
