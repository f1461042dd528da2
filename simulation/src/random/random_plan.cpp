/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/random_plan.h>

#include "plan/turned_rectangle.h"
#include "random/furnished_rooms.h"
#include "random/random_table.h"

#include <map>
#include <utility>

namespace pcl::indoor {

namespace {

Polygon
cornersOf(const Eigen::AlignedBox2d& box)
{
  return turnedRectangle(box.center(), box.sizes(), 0.0);
}

// A storey and those who furnish its rooms.
struct Storey {
  std::vector<LayoutRoom> rooms;
  StoreyPlan plan;
  std::vector<RoomFurnisher> furnishers;
};

Storey
drawStorey(const std::vector<LayoutRoom>& rooms,
           std::size_t level,
           double ceiling,
           double wall_thickness,
           std::uint32_t seed)
{
  constexpr double slab = 0.3; // metres between a ceiling and the floor above it
  constexpr const char* names[] = {"ground floor", "upper floor"};
  RandomDraw draw(seed);
  Storey storey;
  storey.rooms = rooms;
  storey.plan.name = names[level];
  storey.plan.elevation = static_cast<double>(level) * (ceiling + slab);
  const auto openings = drawOpenings(rooms, ceiling, level == 0, draw);
  std::map<std::string, int> named;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    RoomPlan room;
    room.name = std::string(level == 0 ? "" : "upper ") + nameOf(rooms[r].kind);
    room.name += ' ' + std::to_string(++named[room.name]);
    room.polygon = cornersOf(rooms[r].outline);
    room.ceiling.planes[0].height = ceiling;
    storey.plan.rooms.push_back(room);
    storey.furnishers.emplace_back(rooms[r],
                                   openings,
                                   static_cast<int>(r),
                                   wall_thickness,
                                   ceiling,
                                   mixSeed(seed, static_cast<std::uint32_t>(r)));
  }
  for (const auto& opening : openings)
    storey.plan.openings.push_back(opening.plan);
  return storey;
}

FurniturePlan
drawStairs(double height, RandomDraw& draw)
{
  constexpr double handrail = 1.0; // metres above the last step
  FurniturePlan stairs;
  stairs.category = "stairs";
  stairs.seed = 0;
  stairs.elevation = 0.0;
  const double run = draw.uniform(0.2, 0.27) * height / 0.175,
               width = draw.uniform(0.8, 1.0);
  Eigen::Vector3d size(width, run, height + handrail);
  const int shape = draw.pick(3);
  if (shape == 0) {
    stairs.half_turn = true;
    size.head<2>() = Eigen::Vector2d(2 * width, run / 2 + width);
  }
  else if (shape == 1) {
    stairs.variant = 1;
    size.head<2>().setConstant(2 * width - 0.1);
  }
  stairs.size = size;
  return stairs;
}

// Join two storeys by stairs in rooms above each other, if there is room for them.
bool
joinByStairs(Storey& lower, Storey& upper, RandomDraw& draw)
{
  constexpr double free_end = 0.8; // metres before the first and after the last step
  const double height = upper.plan.elevation;
  for (int attempt = 0; attempt < 600; ++attempt) {
    const auto r =
        static_cast<std::size_t>(draw.pick(static_cast<int>(lower.rooms.size())));
    if (lower.rooms[r].kind != RoomKind::Hall &&
        lower.rooms[r].kind != RoomKind::Living)
      continue;
    auto stairs = drawStairs(height, draw);
    const Eigen::Vector2d size = stairs.size->head<2>();
    const bool straight = !stairs.half_turn && stairs.variant == 0;
    const auto& outline = lower.rooms[r].outline;
    stairs.rotation = draw.pick(4) * M_PI / 2;
    const Eigen::Rotation2Dd turn(stairs.rotation);
    const Eigen::Vector2d turned = (turn * size).cwiseAbs(), wall(0.16, 0.16);
    for (const int axis : {0, 1}) { // at a wall or in a corner
      const double low = outline.min()[axis] + wall[axis] + turned[axis] / 2;
      const double high = outline.max()[axis] - wall[axis] - turned[axis] / 2;
      stairs.at[axis] = axis == draw.pick(2) ? draw.uniform(low, std::max(low, high))
                                             : (draw.pick(2) == 0 ? low : high);
    }
    const Eigen::Vector2d front = turn * Eigen::Vector2d(0, (size.y() + free_end) / 2);
    const Polygon place = turnedRectangle(stairs.at, size, stairs.rotation);
    const Polygon before =
        turnedRectangle(stairs.at + front, {size.x(), free_end}, stairs.rotation);
    const Polygon behind =
        turnedRectangle(stairs.at - front, {size.x(), free_end}, stairs.rotation);
    auto &below = lower.furnishers[r], &above = upper.furnishers[r];
    const Polygon& start = straight ? behind : before; // a flight climbs to its front
    if (!below.isFree(place, 0, below.ceiling()) || !below.isFree(start, 0, 2) ||
        !above.isFree(place, 0, above.ceiling()) || !above.isFree(before, 0, 2))
      continue;
    below.block(place, 0, below.ceiling());
    below.block(start, 0, 2);
    above.block(place, 0, above.ceiling());
    above.block(before, 0, 2);
    lower.plan.furniture.push_back(stairs);
    upper.plan.wells.push_back({place});
    return true;
  }
  return false;
}

void
furnish(Storey& storey, PlanKind kind, PlanFilling filling)
{
  for (std::size_t r = 0; r < storey.rooms.size(); ++r) {
    storey.plan.rooms[r].kind = purposeOf(storey.rooms[r].kind, kind == PlanKind::Home);
    if (filling == PlanFilling::LivedIn)
      storey.furnishers[r].liveIn();
    if (kind == PlanKind::Home)
      furnishHomeRoom(storey.furnishers[r], storey.rooms[r].kind);
    else
      furnishOfficeRoom(storey.furnishers[r], storey.rooms[r].kind);
    if (filling == PlanFilling::Cluttered)
      storey.furnishers[r].clutter();
    if (filling == PlanFilling::LivedIn)
      addBelongings(storey.furnishers[r], storey.rooms[r].kind);
    const auto& pieces = storey.furnishers[r].furniture();
    storey.plan.furniture.insert(
        storey.plan.furniture.end(), pieces.begin(), pieces.end());
  }
}

void
turnPlan(Plan& plan, double angle)
{
  const Eigen::Rotation2Dd turn(angle);
  for (auto& storey : plan.storeys) {
    for (auto& room : storey.rooms)
      for (auto& corner : room.polygon)
        corner = turn * corner;
    for (auto& opening : storey.openings)
      opening.at = turn * opening.at;
    for (auto& well : storey.wells)
      for (auto& corner : well.polygon)
        corner = turn * corner;
    for (auto& item : storey.furniture) {
      item.at = turn * item.at;
      item.rotation += angle;
    }
  }
}

} // namespace

Plan
randomPlan(std::uint32_t seed, PlanKind kind, PlanFilling filling)
{
  if (kind == PlanKind::Table)
    return randomTable(seed, filling);
  RandomDraw draw(mixSeed(seed, kind == PlanKind::Home ? 0 : 1));
  const bool home = kind == PlanKind::Home;
  Plan plan;
  plan.name =
      std::string("random ") + (home ? "home " : "office ") + std::to_string(seed);
  plan.seed = seed;
  plan.wall_thickness = draw.uniform(0.1, 0.3);
  const double ceiling = draw.uniform(2.4, 3.0);
  const auto rooms = home ? drawHomeRooms(draw) : drawOfficeRooms(draw);
  const auto draw_storey = [&](const std::vector<LayoutRoom>& floor,
                               std::size_t level) {
    return drawStorey(floor,
                      level,
                      ceiling,
                      plan.wall_thickness,
                      mixSeed(seed, 2 + static_cast<std::uint32_t>(level)));
  };
  std::vector<Storey> storeys{draw_storey(rooms, 0)};
  if (home && draw.uniform() < 0.35) {
    Storey upper = draw_storey(asUpperFloor(rooms, draw), 1);
    if (joinByStairs(storeys[0], upper, draw))
      storeys.push_back(std::move(upper));
  }
  for (auto& storey : storeys) {
    furnish(storey, kind, filling);
    plan.storeys.push_back(storey.plan);
  }
  if (draw.uniform() < 0.5)
    turnPlan(plan, draw.uniform(0.0, M_PI));
  return plan;
}

std::optional<Plan>
randomPlanNamed(const std::string& name)
{
  if (name.rfind("random:", 0) != 0)
    return std::nullopt;
  const std::pair<PlanFilling, std::string> fillings[] = {
      {PlanFilling::Cluttered, ":cluttered"}, {PlanFilling::LivedIn, ":lived_in"}};
  PlanFilling filling = PlanFilling::Plain;
  std::string plain = name;
  for (const auto& [kind, end] : fillings)
    if (name.size() > end.size() &&
        name.compare(name.size() - end.size(), end.size(), end) == 0) {
      filling = kind;
      plain = name.substr(0, name.size() - end.size());
    }
  const std::pair<PlanKind, std::string> kinds[] = {
      {PlanKind::Home, "random:home:"},
      {PlanKind::Office, "random:office:"},
      {PlanKind::Table, "random:table:"}};
  for (const auto& [kind, start] : kinds) {
    if (plain.rfind(start, 0) != 0)
      continue;
    const std::string digits = plain.substr(start.size());
    if (digits.empty() || digits.size() > 10 ||
        digits.find_first_not_of("0123456789") != std::string::npos ||
        std::stoull(digits) > 4294967295ull)
      break;
    return randomPlan(static_cast<std::uint32_t>(std::stoull(digits)), kind, filling);
  }
  throw PlanError(
      name +
      ": must be random:home:SEED, random:office:SEED or random:table:SEED, "
      "with a seed from 0 to 4294967295, and may end with :cluttered or :lived_in");
}

} // namespace pcl::indoor
