/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/scene/room_names.h>

#include <algorithm>

namespace pcl::indoor {
namespace {

/** Of its largest outer line. */
double
perimeterOf(const Room& room)
{
  if (room.footprint.empty())
    return 0.0;
  const auto& line = room.footprint.front();
  double length = 0.0;
  for (std::size_t i = 0; i < line.size(); ++i)
    length += (line[(i + 1) % line.size()] - line[i]).head<2>().norm();
  return length;
}

RoomEvidence
evidenceOf(const Room& room)
{
  RoomEvidence evidence;
  evidence.area = std::max(0.0, room.area);
  evidence.perimeter = perimeterOf(room);
  evidence.height = std::max(0.0, room.height);
  evidence.storey = room.storey;
  return evidence;
}

bool
isGlass(const ModelOpening& opening)
{
  constexpr double two_leaves = 1.3, gate = 2.3; // metres
  return opening.kind == ModelOpeningKind::Window ||
         (opening.kind == ModelOpeningKind::Door &&
          std::min(opening.room_a, opening.room_b) == 0 &&
          opening.width >= two_leaves && opening.width <= gate);
}

void
addOpenings(const BuildingModel& model, std::vector<RoomEvidence>& rooms)
{
  for (const auto& opening : model.openings)
    for (const auto& [room, other] : {std::pair(opening.room_a, opening.room_b),
                                      {opening.room_b, opening.room_a}}) {
      if (room == 0 || room > rooms.size() || room == other)
        continue;
      if (isGlass(opening))
        rooms[room - 1].window_area += opening.width * opening.height;
      else if (other > 0 && other <= rooms.size())
        rooms[room - 1].neighbours.push_back(other - 1);
    }
}

RoomObject
objectOf(const ObjectClass& object, const std::vector<std::string>& names)
{
  RoomObject named;
  for (const auto& [category, confidence] : object.top) {
    const auto probability = static_cast<double>(confidence);
    if (probability > 0.0) // others may name objects, too
      named.classes.emplace_back(names.at(category), std::min(1.0, probability));
  }
  return named;
}

void
addObjects(const Scene& scene, std::vector<RoomEvidence>& rooms)
{
  if (scene.classes.objects.size() != scene.objects.size())
    return;
  const double origin = scene.frame.origin().z();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const auto& object = scene.objects[i];
    if (object.room == 0 || object.room > rooms.size() || object.structure != 0)
      continue;
    const auto storey = rooms[object.room - 1].storey;
    auto named = objectOf(scene.classes.objects[i], scene.classes.names);
    named.foot = object.upright.center.z() - 0.5 * object.upright.size.z() - origin -
                 scene.building.heights.at(storey).floor;
    rooms[object.room - 1].objects.push_back(std::move(named));
  }
}

} // namespace

std::vector<RoomEvidence>
roomEvidence(const Scene& scene)
{
  std::vector<RoomEvidence> rooms;
  for (const auto& room : scene.building.rooms)
    rooms.push_back(evidenceOf(room));
  addOpenings(scene.model, rooms);
  addObjects(scene, rooms);
  return rooms;
}

std::vector<NamedRoom>
roomNames(const Scene& scene)
{
  return nameRooms(roomEvidence(scene));
}

} // namespace pcl::indoor
