/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/scene_record.h"

#include "formats/record.h"

namespace pcl::indoor::tool {

// One function per struct, for both ways: it names the members that are kept.

template <typename Record, typename T>
void
exchange(Record& record, PixelMap<T>& map)
{
  record(map.nx, map.ny, map.values);
}

template <typename Record>
void
exchange(Record& record, Room& room)
{
  record(room.label,
         room.storey,
         room.point_count,
         room.area,
         room.volume,
         room.height,
         room.seen,
         room.floor_seen,
         room.ceiling_seen,
         room.lower,
         room.upper,
         room.centroid,
         room.footprint);
}

template <typename Record>
void
exchange(Record& record, RoomOpening& opening)
{
  record(opening.room_a, opening.room_b, opening.position, opening.width, opening.area);
  record(opening.rise);
}

template <typename Record>
void
exchange(Record& record, MappedRooms& map)
{
  record(map.blocked, map.field, map.free_labels, map.labels, map.room_count);
  record(map.potential, map.potential_factor);
}

template <typename Record>
void
exchange(Record& record, Storey& storey)
{
  record(storey.floor, storey.ceiling);
}

template <typename Record>
void
exchange(Record& record, BuildingRooms& building)
{
  record(building.grid.yaw, building.grid.origin, building.grid.voxel_size);
  record(building.heights,
         building.maps,
         building.room_of,
         building.rooms,
         building.openings);
}

template <typename Record>
void
exchange(Record& record, BuildingFrame& frame)
{
  record(frame.offset, frame.metres_per_unit, frame.pose.matrix());
}

template <typename Record>
void
exchange(Record& record, Scene& scene)
{
  record(scene.room_of_point, scene.rooms, scene.openings, scene.building, scene.frame);
  auto& report = scene.report;
  record(report.warnings, report.voxel_size, report.outside);
  record(report.up_axis, report.metres_per_unit, report.end_is_recognised);
  record(report.vertical.direction,
         report.vertical.is_found,
         report.vertical.is_end_known,
         report.vertical.room_height);
}

template <typename Record>
void
exchange(Record& record, ObjectMeasures& object)
{
  record(object.structure,
         object.point_count,
         object.lower,
         object.upper,
         object.centroid,
         object.upright.center,
         object.upright.size,
         object.upright.yaw);
}

template <typename Record>
void
exchange(Record& record, ObjectClass& object)
{
  record(object.category, object.confidence, object.top);
}

template <typename Record>
void
exchange(Record& record, FinishedRoom& room)
{
  record(room.objects.object_of_point,
         room.objects.structure_of_point,
         room.objects.voxel_size,
         room.measures,
         room.classes);
}

namespace {

template <typename T>
std::optional<T>
valueOf(const std::string& bytes)
{
  try {
    T value;
    RecordReader record(bytes);
    record(value);
    record.finish();
    return value;
  } catch (const DamagedRecord&) {
    return {};
  }
}

} // namespace

void
dropGrids(BuildingRooms& building)
{
  building.steps.reset();
  std::vector<std::uint32_t>().swap(building.point_labels);
  std::vector<std::size_t>().swap(building.outside);
  building.stations.clear();
}

std::string
sceneBytes(const Scene& scene)
{
  return recordOf(scene);
}

std::optional<Scene>
sceneOf(const std::string& bytes)
{
  return valueOf<Scene>(bytes);
}

std::string
roomBytes(const FinishedRoom& room)
{
  return recordOf(room);
}

std::optional<FinishedRoom>
roomOf(const std::string& bytes)
{
  return valueOf<FinishedRoom>(bytes);
}

} // namespace pcl::indoor::tool
