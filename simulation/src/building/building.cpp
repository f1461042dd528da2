/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/building.h>

#include "building/ceiling_facets.h"
#include "building/leaning_walls.h"
#include "building/platforms.h"
#include "building/room_shell.h"
#include "furniture/catalogue.h"
#include "furniture/draped_cloth.h"
#include "furniture/placement.h"

#include <pcl/simulation/furniture.h>
#include <pcl/simulation/random_draw.h> // for mixSeed

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace pcl::indoor {

namespace {

std::vector<std::string>
categoryNames(const Plan& plan)
{
  std::vector<std::string> names{
      "none", "floor", "ceiling", "wall", "door", "window", "ghost"};
  std::vector<std::string> later; // those of lived-in rooms: numbers stay
  for (const auto& name : furnitureCategories())
    (plainShapes(name) > 0 ? names : later).push_back(name);
  const auto is_later = [&](const FurniturePlan& item) {
    return plainShapes(item.category) == 0;
  };
  const bool needed = std::any_of(
      plan.storeys.begin(), plan.storeys.end(), [&](const StoreyPlan& storey) {
        return std::any_of(storey.furniture.begin(), storey.furniture.end(), is_later);
      });
  if (needed)
    names.insert(names.end(), later.begin(), later.end());
  return names;
}

// Walls thicker than the room turn its edges around.
bool
vanishes(const Polygon& outline, const Polygon& inner)
{
  constexpr double smallest = 0.25; // square metres
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t next = (i + 1) % outline.size();
    if ((outline[next] - outline[i]).dot(inner[next] - inner[i]) <= 0)
      return true;
  }
  return crossesItself(inner) || signedArea(inner) < smallest;
}

void
requireSound(const RoomPlan& plan, const RoomInfo& room, const std::string& source)
{
  const auto fail = [&](const std::string& problem) {
    throw PlanError(source + ": rooms: room '" + room.name + "' " + problem);
  };
  if (vanishes(plan.polygon, room.polygon))
    fail("vanishes between its walls (wall_thickness)");
  const double top = room.floor + ceilingRange(room.ceiling, room.polygon).second;
  if (vanishes(plan.polygon, room.polygonAt(top)))
    fail("closes below its ceiling: its walls lean too much (leaning_walls)");
  for (const auto& facet : ceilingFacets(room.ceiling))
    for (const auto& drift : room.drift)
      if (drift != Eigen::Vector2d::Zero() &&
          (facet.part >= 0 || facet.plane.slope.dot(drift) > 0.9))
        fail("has a wall that leans by itself below a ceiling of parts, or along its "
             "slope (leaning_walls)");
  for (std::size_t i = 0; i < room.polygon.size(); ++i) {
    const auto& p = room.polygon[i];
    if (room.ceiling.heightAt(p) < -1e-6) {
      std::ostringstream problem;
      problem << "has its ceiling below its floor at (" << p.x() << ", " << p.y()
              << ")";
      fail(problem.str());
    }
  }
}

std::vector<RoomInfo>
makeRooms(const Plan& plan, const std::string& source)
{
  std::vector<RoomInfo> rooms;
  for (std::size_t s = 0; s < plan.storeys.size(); ++s)
    for (const auto& room : plan.storeys[s].rooms) {
      RoomInfo info;
      info.name = room.name;
      info.kind = room.kind;
      info.storey_name = plan.storeys[s].name;
      info.storey = static_cast<std::uint32_t>(s);
      info.drift = cornerDrifts(plan, room, source);
      info.polygon = inset(room.polygon, plan.wall_thickness / 2);
      info.floor = plan.storeys[s].elevation;
      for (std::size_t i = 0; i < info.polygon.size(); ++i)
        info.polygon[i] += info.floor * info.drift[i]; // drawn at height 0
      info.ceiling = room.ceiling;
      requireSound(room, info, source);
      rooms.push_back(info);
    }
  requireLeaningWallsUsed(plan, source);
  return rooms;
}

// Do the rooms overlap at the lowest or the highest level that both have?
bool
overlapSomewhere(const RoomInfo& a, const RoomInfo& b)
{
  const double a_top = a.floor + ceilingRange(a.ceiling, a.polygon).second;
  const double b_top = b.floor + ceilingRange(b.ceiling, b.polygon).second;
  const double low = std::max(a.floor, b.floor), high = std::min(a_top, b_top);
  if (low >= high)
    return false;
  return overlap(a.polygonAt(low), b.polygonAt(low)) ||
         overlap(a.polygonAt(high), b.polygonAt(high));
}

void
requireApart(const std::vector<RoomInfo>& rooms, const std::string& source)
{
  for (std::size_t i = 0; i < rooms.size(); ++i)
    for (std::size_t j = i + 1; j < rooms.size(); ++j)
      if (overlapSomewhere(rooms[i], rooms[j]))
        throw PlanError(source + ": rooms: '" + rooms[i].name + "' and '" +
                        rooms[j].name + "' overlap");
}

// Puts triangles with their labels into a building.
class Assembler {
public:
  explicit Assembler(Building& building)
  : building_(building)
  {}

  void
  addShell(const std::vector<ShellPiece>& pieces, std::uint32_t room)
  {
    const std::uint32_t categories[3] = {building_.category("floor"),
                                         building_.category("wall"),
                                         building_.category("ceiling")};
    for (const auto& piece : pieces) {
      Surface surface;
      surface.labels.room = room;
      surface.labels.category = categories[static_cast<int>(piece.face)];
      surface.kind = SurfaceKind::Shell;
      const auto& t = piece.triangle;
      building_.triangles.push_back({leant(t.a), leant(t.b), leant(t.c)});
      building_.surfaces.push_back(surface);
    }
  }

  // Parts on the far side of y = 0 of the object's frame belong to room_behind. Points
  // move sideways with their height by drift.
  void
  addObject(const FurnitureModel& model,
            const ObjectInfo& info,
            std::uint32_t room_behind,
            SurfaceKind glass,
            const Eigen::Vector2d& drift)
  {
    building_.objects.push_back(info);
    auto& object = building_.objects.back();
    object.first_part = next_part_;
    object.size = model.size;
    const Eigen::Affine3d pose =
        Eigen::Translation3d(info.position) *
        Eigen::AngleAxisd(info.rotation, Eigen::Vector3d::UnitZ());
    Surface surface;
    surface.labels.object = static_cast<std::uint32_t>(building_.objects.size());
    surface.labels.category = building_.category(info.category);
    for (const auto& part : model.parts) {
      object.part_names.push_back(part.name);
      surface.labels.part = next_part_++;
      surface.kind = part.glass ? glass : SurfaceKind::Solid;
      for (const auto& t : part.triangles) {
        const bool behind = t.a.y() + t.b.y() + t.c.y() < 0;
        surface.labels.room = behind ? room_behind : info.room;
        const auto moved = [&](const Eigen::Vector3f& p) -> Eigen::Vector3f {
          Eigen::Vector3d at = pose * p.cast<double>();
          at.head<2>() += p.z() * drift;
          return at.cast<float>();
        };
        building_.triangles.push_back({moved(t.a), moved(t.b), moved(t.c)});
        building_.surfaces.push_back(surface);
      }
    }
  }

private:
  Eigen::Vector3f
  leant(const Eigen::Vector3f& drawn) const
  {
    return building_.leant(drawn.cast<double>()).cast<float>();
  }

  Building& building_;
  std::uint32_t next_part_ = 1;
};

void
addOpening(Assembler& assemble,
           Building& building,
           const PlacedOpening& opening,
           double wall_thickness)
{
  constexpr double passable =
      60 * M_PI / 180; // a leaf this far open lets the sensor by
  const auto front = static_cast<std::uint32_t>(opening.front_room + 1);
  const auto back = static_cast<std::uint32_t>(opening.back_room + 1);
  assemble.addShell(reveal(opening, wall_thickness / 2), front);
  if (back > 0)
    assemble.addShell(reveal(opening, -wall_thickness / 2), back);
  const auto& plan = opening.plan;
  const Eigen::Vector3d origin = building.leant(opening.origin);
  const Eigen::Vector2d drift = opening.lean * opening.towards + building.lean;
  if (back > 0 && plan.sill == 0 && plan.kind != OpeningKind::Window &&
      (plan.kind == OpeningKind::Passage || plan.leaf_angle >= passable))
    building.doorways.push_back({origin, plan.width, drift});
  if (plan.kind == OpeningKind::Passage)
    return;
  ObjectInfo info;
  info.category = plan.kind == OpeningKind::Door ? "door" : "window";
  info.room = info.stands_in = front;
  info.position = origin;
  info.rotation = std::atan2(opening.along.y(), opening.along.x());
  const auto model = plan.kind == OpeningKind::Door ? makeDoor(plan.width,
                                                               plan.height,
                                                               wall_thickness,
                                                               plan.leaf_angle,
                                                               plan.hinge_left)
                                                    : makeWindow(plan.width,
                                                                 plan.height,
                                                                 wall_thickness,
                                                                 plan.frame_width,
                                                                 plan.frame_depth);
  assemble.addObject(model,
                     info,
                     back,
                     back > 0 ? SurfaceKind::InteriorGlass : SurfaceKind::ExteriorGlass,
                     drift);
}

void
addRooms(Assembler& assemble, const Building& building, const WallHoles& walls)
{
  for (std::size_t r = 0; r < building.rooms.size(); ++r) {
    const auto number = static_cast<std::uint32_t>(r + 1);
    ShellHoles holes;
    for (const auto& hole : walls.holes)
      if (hole.room == static_cast<int>(r))
        holes.walls.push_back(hole);
    for (const auto& well : building.wells) {
      if (well.upper == number)
        holes.floor.push_back(well.polygon);
      if (well.lower == number)
        holes.ceiling.push_back(well.polygon);
    }
    assemble.addShell(roomShell(building.rooms[r], holes), number);
  }
}

// What was built so far of objects over or beside a footprint, in its frame.
std::vector<Triangle>
supportsOf(const Building& building, const FurniturePlacement& cloth, double rotation)
{
  const Eigen::Isometry3f into =
      (Eigen::AngleAxisd(-rotation, Eigen::Vector3d::UnitZ()) *
       Eigen::Translation3d(-cloth.position))
          .cast<float>();
  const Eigen::Vector3f half = cloth.model.size.cast<float>() / 2;
  std::vector<Triangle> supports;
  for (std::size_t i = 0; i < building.triangles.size(); ++i) {
    if (building.surfaces[i].labels.object == 0)
      continue;
    const auto& t = building.triangles[i];
    const Triangle moved{into * t.a, into * t.b, into * t.c};
    const Eigen::Array3f low = moved.a.cwiseMin(moved.b).cwiseMin(moved.c),
                         high = moved.a.cwiseMax(moved.b).cwiseMax(moved.c);
    if ((low.head<2>() < half.array().head<2>()).all() &&
        (high.head<2>() > -half.array().head<2>()).all() && high.z() > 0 &&
        low.z() < 2 * half.z())
      supports.push_back(moved);
  }
  return supports;
}

// A cloth over nothing stays as it is.
void
drape(FurniturePlacement& cloth,
      const Building& building,
      double rotation,
      std::uint32_t seed)
{
  const auto model =
      drapeCloth(supportsOf(building, cloth, rotation), cloth.model.size, seed);
  if (!model.parts.empty())
    cloth.model = model;
}

// What joins storeys, and what can be walked on besides floors.
void
addLevels(Assembler& assemble, const Building& building)
{
  for (const auto& well : building.wells)
    for (const bool upper : {false, true})
      assemble.addShell(wellReveal(building, well, upper),
                        upper ? well.upper : well.lower);
  for (const auto& platform : building.platforms)
    assemble.addShell(platformShell(building, platform), platform.room);
}

} // namespace

std::uint32_t
Building::category(const std::string& name) const
{
  const auto found = std::find(categories.begin(), categories.end(), name);
  if (found == categories.end())
    PCL_THROW_EXCEPTION(BadArgumentException, "there is no category '" << name << "'");
  return static_cast<std::uint32_t>(found - categories.begin());
}

Building
buildBuilding(const Plan& plan, const std::string& source)
{
  Building building;
  building.categories = categoryNames(plan);
  building.lean = driftOf(plan);
  building.rooms = makeRooms(plan, source);
  requireApart(building.rooms, source);
  const auto walls = placeOpenings(plan, building.rooms, source);
  building.wells = placeWells(plan, building.rooms, source);
  building.platforms = placePlatforms(plan, building.rooms, source);
  Assembler assemble(building);
  addRooms(assemble, building, walls);
  for (const auto& opening : walls.openings)
    addOpening(assemble, building, opening, plan.wall_thickness);
  addLevels(assemble, building);
  std::uint32_t item_number = 0;
  for (std::size_t s = 0; s < plan.storeys.size(); ++s)
    for (const auto& item : plan.storeys[s].furniture) {
      const std::uint32_t seed = item.seed.value_or(mixSeed(plan.seed, item_number++));
      auto placed = placeFurniture(item, seed, building, s, plan.storeys[s], source);
      if (item.draped)
        drape(placed, building, item.rotation, seed);
      ObjectInfo info;
      info.category = item.category;
      info.room = placed.room;
      info.stands_in = placed.stands_in;
      info.position = placed.position;
      info.rotation = item.rotation;
      assemble.addObject(
          placed.model, info, placed.room, SurfaceKind::Solid, Eigen::Vector2d::Zero());
    }
  return building;
}

} // namespace pcl::indoor
