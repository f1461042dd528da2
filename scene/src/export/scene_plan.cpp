/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/scene_plan.h"

#include "export/opening_place.h"
#include "export/plan_boxes.h"

namespace pcl::indoor::tool {
namespace {

/** It opens into the smaller room. */
PlanOpening
drawnOpening(const SavedScene& scene, const SavedOpening& opening)
{
  const auto place = openingPlace(scene, opening);
  PlanOpening drawn;
  drawn.number = opening.number;
  drawn.width = opening.width;
  drawn.middle = place.middle;
  drawn.along = place.along;
  drawn.into = {-place.along.y(), place.along.x()};
  drawn.is_door = opening.kind == ModelOpeningKind::Door;
  const SavedRoom* into = nullptr;
  for (const auto number : {opening.room_a, opening.room_b})
    if (number > 0 && (!into || scene.rooms[number - 1].area < into->area))
      into = &scene.rooms[number - 1];
  constexpr double beyond = 0.1; // metres
  if (into &&
      !isInside(into->rings, drawn.middle + (place.left + beyond) * drawn.into) &&
      isInside(into->rings, drawn.middle - (place.right + beyond) * drawn.into))
    drawn.into = -drawn.into;
  return drawn;
}

} // namespace

FloorPlan
scenePlan(const SavedScene& scene)
{
  FloorPlan plan;
  plan.storeys.resize(scene.storeys.size());
  plan.origin = scene.origin.head<2>();
  for (const auto& room : scene.rooms) {
    plan.storeys[room.storey].rooms.push_back(
        {room.number, room.area, widestPlace(room.rings), room.rings, room.name});
    for (const auto& ring : room.rings)
      for (const auto& corner : ring)
        plan.box.extend(corner);
  }
  for (const auto& opening : scene.openings)
    if (opening.kind != ModelOpeningKind::Window)
      plan.storeys[opening.storey].openings.push_back(drawnOpening(scene, opening));
  for (const auto& wall : scene.walls)
    if (wall.thickness > 0.0)
      addWall({{wall.begin, wall.end}, wall.thickness}, plan.storeys[wall.storey]);
  for (const auto& opening : scene.openings)
    if (opening.kind == ModelOpeningKind::Window) {
      const auto place = openingPlace(scene, opening);
      addWindow(place.middle,
                place.along,
                opening.width,
                opening.wall < scene.walls.size() ? scene.walls[opening.wall].thickness
                                                  : 0.0,
                plan.storeys[opening.storey]);
    }
  for (auto& storey : plan.storeys)
    storey.walls = planWalls(storey);
  for (const auto& object : scene.objects)
    if (!object.is_structure)
      plan.storeys[object.storey].objects.push_back(
          {object.number, object.storey, boxFromAbove(object.box)});
  if (plan.box.isEmpty())
    plan.box = {Eigen::Vector2d::Zero(), Eigen::Vector2d(1.0, 1.0)};
  return plan;
}

} // namespace pcl::indoor::tool
