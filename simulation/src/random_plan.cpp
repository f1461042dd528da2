/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "room_furnisher.h"

#include <pcl/simulation/random_plan.h>

#include <map>

namespace pcl {
namespace indoor {

namespace {

Polygon
cornersOf(const Eigen::AlignedBox2d& box)
{
  return turnedRectangle(box.center(), box.sizes(), 0.0);
}

StoreyPlan
drawStorey(const std::vector<LayoutRoom>& rooms,
           const std::string& name,
           PlanKind kind,
           double ceiling,
           double wall_thickness,
           std::uint32_t seed)
{
  RandomDraw draw(seed);
  StoreyPlan storey;
  storey.name = name;
  const auto openings = drawOpenings(rooms, ceiling, true, draw);
  std::map<std::string, int> named;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    RoomPlan room;
    room.name = nameOf(rooms[r].kind);
    room.name += ' ' + std::to_string(++named[room.name]);
    room.polygon = cornersOf(rooms[r].outline);
    room.ceiling.planes[0].height = ceiling;
    storey.rooms.push_back(room);
    RoomFurnisher furnisher(rooms[r],
                            openings,
                            static_cast<int>(r),
                            wall_thickness,
                            ceiling,
                            mixSeed(seed, static_cast<std::uint32_t>(r)));
    if (kind == PlanKind::Home)
      furnishHomeRoom(furnisher, rooms[r].kind);
    else
      furnishOfficeRoom(furnisher, rooms[r].kind);
    const auto& pieces = furnisher.furniture();
    storey.furniture.insert(storey.furniture.end(), pieces.begin(), pieces.end());
  }
  for (const auto& opening : openings)
    storey.openings.push_back(opening.plan);
  return storey;
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
randomPlan(std::uint32_t seed, PlanKind kind)
{
  RandomDraw draw(mixSeed(seed, kind == PlanKind::Home ? 0 : 1));
  const bool home = kind == PlanKind::Home;
  Plan plan;
  plan.name =
      std::string("random ") + (home ? "home " : "office ") + std::to_string(seed);
  plan.seed = seed;
  plan.wall_thickness = draw.uniform(0.1, 0.3);
  const double ceiling = draw.uniform(2.4, 3.0);
  const auto rooms = home ? drawHomeRooms(draw) : drawOfficeRooms(draw);
  plan.storeys.push_back(drawStorey(
      rooms, "ground floor", kind, ceiling, plan.wall_thickness, mixSeed(seed, 2)));
  if (draw.uniform() < 0.5)
    turnPlan(plan, draw.uniform(0.0, M_PI));
  return plan;
}

std::optional<Plan>
randomPlanNamed(const std::string& name)
{
  if (name.rfind("random:", 0) != 0)
    return std::nullopt;
  for (const auto kind : {PlanKind::Home, PlanKind::Office}) {
    const std::string start =
        kind == PlanKind::Home ? "random:home:" : "random:office:";
    if (name.rfind(start, 0) != 0)
      continue;
    const std::string digits = name.substr(start.size());
    if (digits.empty() || digits.size() > 10 ||
        digits.find_first_not_of("0123456789") != std::string::npos ||
        std::stoull(digits) > 4294967295ull)
      break;
    return randomPlan(static_cast<std::uint32_t>(std::stoull(digits)), kind);
  }
  throw PlanError(name +
                  ": must be random:home:SEED or random:office:SEED, with a seed "
                  "from 0 to 4294967295");
}

} // namespace indoor
} // namespace pcl
