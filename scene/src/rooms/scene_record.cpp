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
exchange(Record& record, RoomMap& map)
{
  record(map.blocked,
         map.field,
         map.free_labels,
         map.labels,
         map.field_rooms.field,
         map.room_count);
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
  auto& grid = building.occupancy.grid;
  record(grid.shape.nx, grid.shape.ny, grid.shape.nz, grid.origin, grid.voxel_size);
  record(building.occupancy.yaw,
         building.interior.factor,
         building.storeys.heights,
         building.maps,
         building.room_of,
         building.rooms,
         building.openings);
}

template <typename Record>
void
exchange(Record& record, Scene& scene)
{
  record(scene.room_of_point,
         scene.rooms,
         scene.openings,
         scene.building,
         scene.building_pose.matrix());
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
  BuildingRooms kept;
  kept.occupancy.grid.shape = building.occupancy.grid.shape;
  kept.occupancy.grid.origin = building.occupancy.grid.origin;
  kept.occupancy.grid.voxel_size = building.occupancy.grid.voxel_size;
  kept.occupancy.yaw = building.occupancy.yaw;
  kept.interior.factor = building.interior.factor;
  kept.storeys.heights = std::move(building.storeys.heights);
  kept.room_of = std::move(building.room_of);
  kept.rooms = std::move(building.rooms);
  kept.openings = std::move(building.openings);
  for (auto& map : building.maps) {
    auto& own = kept.maps.emplace_back();
    own.blocked = std::move(map.blocked);
    own.field = std::move(map.field);
    own.free_labels = std::move(map.free_labels);
    own.labels = std::move(map.labels);
    own.field_rooms.field = std::move(map.field_rooms.field);
    own.room_count = map.room_count;
  }
  building = std::move(kept);
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
