/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/building_rooms.h>

#include "rooms/map/building_steps.h"
#include "rooms/map/region_evidence.h"
#include "rooms/map/room_map.h"
#include "rooms/map/station_views.h"
#include "rooms/outline/room_layout.h"
#include "rooms/outline/storey_labels.h"
#include "rooms/room_way.h"
#include "rooms/space/closed_surfaces.h"
#include "rooms/space/interior_space.h"
#include "rooms/space/occupancy_grid.h"
#include "rooms/space/surface_triangles.h"
#include "rooms/space/unseen_sides.h"
#include "rooms/storeys/storey_space.h"
#include "rooms/storeys/storeys.h"
#include "rooms/storeys/unseen_slabs.h"

#include <pcl/indoor/distinct_points.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>

#include <pcl/indoor/require_valid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace pcl::indoor {
namespace {

/** The storey of each point; points outside the grid have none that matters. */
std::vector<std::uint8_t>
storeysOfPoints(const std::vector<Eigen::Vector3f>& points,
                const DetailedBuilding& building,
                int threads)
{
  const VoxelBits& grid = building.occupancy.grid;
  std::vector<std::uint8_t> storey_of(points.size(), 0);
  if (building.storeys.borders.empty())
    return storey_of;
#pragma omp parallel for schedule(static) num_threads(threadCount(threads))
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(points.size()); ++i) {
    if (building.occupancy.cells[i] < 0)
      continue;
    const std::int32_t pixel = building.occupancy.cells[i] / grid.shape.nz;
    storey_of[i] = static_cast<std::uint8_t>(building.storeys.storeyAt(
        pixel / grid.shape.ny, pixel % grid.shape.ny, points[i].z()));
  }
  return storey_of;
}

/** How many points of a storey each column holds. */
PixelMap<std::uint32_t>
pointsOfColumns(const StoreyPoints& points, const OccupancyGrid& occupancy)
{
  const GridShape& shape = occupancy.grid.shape;
  auto counts = PixelMap<std::uint32_t>::filled(shape.nx, shape.ny, 0);
  for (std::size_t i = 0; i < points.storey_of.size(); ++i)
    if (occupancy.cells[i] >= 0 && points.storey_of[i] == points.storey)
      ++counts.values[occupancy.cells[i] / shape.nz];
  return counts;
}

std::vector<Room>
describeRooms(const std::vector<Eigen::Vector3f>& points,
              const DetailedBuilding& building)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double size = building.occupancy.grid.voxel_size;
  std::vector<Room> rooms;
  for (std::size_t s = 0; s < building.room_maps.size(); ++s) {
    const RoomMap& map = building.room_maps[s];
    for (const std::uint32_t label : building.room_of[s])
      if (label > rooms.size()) {
        Room room;
        room.label = label;
        room.storey = static_cast<std::uint32_t>(s);
        room.lower.setConstant(infinity);
        room.upper.setConstant(-infinity);
        room.centroid.setZero();
        rooms.push_back(room);
      }
    for (std::size_t i = 0; i < map.free_labels.size(); ++i) {
      if (map.free_labels.values[i] <= 0)
        continue;
      Room& room = rooms[building.room_of[s][map.free_labels.values[i]] - 1];
      room.volume += size * size * size * (map.ceiling.values[i] - map.range.begin);
      room.area += size * size;
    }
    const auto closed = closedBorders(map, size);
    for (std::size_t label = 1; label < closed.size(); ++label)
      rooms[building.room_of[s][label] - 1].seen = closed[label];
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    if (building.point_labels[i] > 0) {
      Room& room = rooms[building.point_labels[i] - 1];
      const Eigen::Vector3d point = points[i].cast<double>();
      ++room.point_count;
      room.lower = room.lower.cwiseMin(point);
      room.upper = room.upper.cwiseMax(point);
      room.centroid += point;
    }
  for (Room& room : rooms) {
    room.height = room.area > 0 ? room.volume / room.area : 0.0;
    room.centroid /= std::max<double>(1.0, room.point_count);
  }
  return rooms;
}

/** The directions in which enclosure is looked for. */
std::vector<Eigen::Vector3d>
directionsOf(const std::vector<Eigen::Vector3f>& points,
             const OccupancyGrid& building,
             const InteriorSpaceOptions& options,
             int threads)
{
  return options.upright_walls ? wallDirections(points, building, options, threads)
                               : dominantDirections(points, building, options, threads);
}

/** How far the grid is turned so that most walls lie along its voxels, radians: less
 * than a degree is none, and whole tenths of degrees, or the order of the points would
 * matter. */
double
yawAlong(const std::vector<Eigen::Vector3d>& directions)
{
  if (directions.empty())
    return 0.0;
  constexpr double degree = M_PI / 180.0;
  const double angle = std::atan2(directions[0].y(), directions[0].x()) / degree;
  const double yaw = angle - 90.0 * std::round(angle / 90.0); // -45 ... 45
  return std::abs(yaw) < 1.0 ? 0.0 : 0.1 * degree * std::round(10.0 * yaw);
}

/** The points' grid, not turned; an automatic voxel size is found from it.
 * \param[in] voxel_size metres, 0 = automatic
 * \param[in,out] options the voxel size is filled in
 * \param[out] triangles what closes the surfaces of sparse points
 */
OccupancyGrid
gridOf(const std::vector<Eigen::Vector3f>& points,
       double voxel_size,
       OccupancyGridOptions& options,
       SurfaceTriangles& triangles)
{
  options.voxel_size = voxel_size > 0.0 ? voxel_size : smallest_automatic_voxel;
  OccupancyGrid grid = occupancyGrid(points, options);
  if (voxel_size > 0.0)
    return grid;
  if (hasHoles(grid.grid)) {
    triangles = surfaceTriangles(points, options.voxel_size, options.threads);
    addTriangles(triangles, options.threads, grid);
  }
  const double closed = closedVoxelSize(grid.grid, largest_automatic_voxel);
  if (closed > options.voxel_size) {
    options.voxel_size = closed;
    grid = occupancyGrid(points, options);
    addTriangles(triangles, options.threads, grid);
  }
  return grid;
}

/** Make the points' grid, along most walls if the options say so.
 * \return the directions in which enclosure is looked for */
std::vector<Eigen::Vector3d>
makeGrid(const std::vector<Eigen::Vector3f>& points,
         const BuildingRoomsOptions& options,
         OccupancyGrid& grid)
{
  OccupancyGridOptions grid_options;
  grid_options.threads = options.threads;
  SurfaceTriangles triangles;
  grid = gridOf(points, options.voxel_size, grid_options, triangles);
  auto directions = directionsOf(points, grid, options.interior, options.threads);
  if (options.align_grid)
    grid_options.yaw = yawAlong(directions);
  if (grid_options.yaw != 0.0) {
    grid = occupancyGrid(points, grid_options);
    addTriangles(triangles, options.threads, grid);
  }
  return directions;
}

/** The interior of a building, closed where its floors or ceilings were not seen.
 * \param[in,out] grid what closes it is set */
InteriorSpace
closedInterior(const std::vector<Eigen::Vector3d>& directions,
               const BuildingRoomsOptions& options,
               OccupancyGrid& grid)
{
  auto interior = interiorSpace(grid, directions, options.interior, options.threads);
  const UnseenSides unseen = interior.unseen;
  if (unseen.floor.empty() && unseen.ceiling.empty())
    return interior;
  closeUnseenSides(interior, grid.grid);
  interior = {}; // before there is another
  interior = interiorSpace(grid, directions, options.interior, options.threads);
  interior.unseen = unseen;
  return interior;
}

/** A storey's part of the building, and its map before anything is dropped. */
struct MappedStorey {
  StoreySpace space;
  RoomMap map;
};

/** How many storeys are mapped at once: most steps of a map have one thread. Where the
 * maps are large, one after the other takes less memory. */
std::size_t
mapsAtOnce(std::size_t pixels, int threads)
{
  constexpr std::size_t enough = 4000000; // pixels
  return std::clamp<std::size_t>(
      enough / std::max<std::size_t>(pixels, 1), 1, threadCount(threads));
}

std::vector<MappedStorey>
mapStoreys(const DetailedBuilding& building,
           std::size_t first,
           std::size_t end,
           const RoomWay& way)
{
  std::vector<MappedStorey> mapped(end - first);
  const auto count = static_cast<std::ptrdiff_t>(mapped.size());
  parallelFor(count, static_cast<int>(count), 1, [&](std::ptrdiff_t k) {
    mapped[k].space = storeySpace(
        building.occupancy.grid, building.interior, building.storeys, first + k);
    mapped[k].map = way.map(mapped[k].space);
  });
  return mapped;
}

/** Take what is no room out of the map of the last storey. */
void
keepRooms(const StoreySpace& space,
          const StoreyPoints& points,
          const StationViews& views,
          OpenGround& ground,
          DetailedBuilding& building)
{
  RoomMap& map = building.room_maps.back();
  dropStreets(space, map);
  dropOutdoors(space, ground, map);
  building.hardly_seen += dropSeenThroughOpenings(space, map);
  building.hardly_seen +=
      dropHardlySeen(space, pointsOfColumns(points, building.occupancy), map);
  views.joinMirrored(points, map);
  building.never_entered += views.dropNeverEntered(points, map);
}

/** The rooms in which the stations of a storey stand. */
void
placeStations(const StationViews& views, std::size_t storey, DetailedBuilding& building)
{
  const auto regions = views.regionsOf(building.room_maps[storey], storey);
  for (std::size_t k = 0; k < regions.size(); ++k)
    if (regions[k] > 0)
      building.stations[k].room = building.room_of[storey][regions[k]];
}

/** The rooms of points that have no copies. */
DetailedBuilding
segmentDistinct(const RoomWay& way,
                const std::vector<Eigen::Vector3f>& points,
                const BuildingRoomsOptions& options,
                const ProgressCallback& progress,
                const ScanStations& stations)
{
  const auto stopped = [&](double share, const char* stage) {
    return progress && !progress(share, stage);
  };
  if (points.empty())
    return {};
  DetailedBuilding building;
  if (stopped(0.0, "occupancy grid"))
    return {};
  const auto directions = makeGrid(points, options, building.occupancy);
  const VoxelBits& grid = building.occupancy.grid;
  if (stopped(0.2, "interior space"))
    return {};
  building.interior = closedInterior(directions, options, building.occupancy);
  if (stopped(0.4, "storeys"))
    return {};
  building.storeys = findStoreys(
      grid, options.storeys, options.threads, unseenSlabs(building.occupancy));
  refineBorders(points, building.occupancy, building.storeys);
  const auto storey_of = storeysOfPoints(points, building, options.threads);
  const StationViews views(
      stations, building.occupancy, building.interior, building.storeys);
  building.stations = views.placed();
  std::uint32_t room_count = 0;
  OpenGround ground;
  const std::size_t storeys = building.storeys.heights.size();
  const std::size_t at_once = mapsAtOnce(grid.columns(), options.threads);
  std::vector<MappedStorey> mapped;
  for (std::size_t s = 0; s < storeys; ++s) {
    const double part = static_cast<double>(s) / static_cast<double>(storeys);
    if (stopped(0.5 + 0.3 * part, "rooms of a storey"))
      return {};
    if (s % at_once == 0) {
      mapped.clear(); // before there are others
      mapped = mapStoreys(building, s, std::min(storeys, s + at_once), way);
    }
    const StoreySpace& space = mapped[s % at_once].space;
    RoomMap& map = building.room_maps.emplace_back();
    map = std::move(mapped[s % at_once].map);
    keepRooms(space, {storey_of, s}, views, ground, building);
    auto& room_of = building.room_of.emplace_back();
    for (std::int32_t label = 0; label <= map.room_count; ++label)
      room_of.push_back(label == 0 ? 0 : ++room_count);
    placeStations(views, s, building);
    addOpenings(points, space, options.threads, building);
  }
  mapped.clear();
  if (stopped(0.8, "rooms of the points"))
    return {};
  building.point_labels.assign(points.size(), 0);
  for (std::size_t s = 0; s < storeys; ++s)
    way.label(points, storey_of, s, building);
  building.rooms = describeRooms(points, building);
  addFootprints(points, options.threads, building);
  if (stopped(1.0, "done"))
    return {};
  return building;
}

/** The stations of those points of which each place has one. */
ScanStations
stationsOnce(const ScanStations& stations, const DistinctPoints& places)
{
  return {stations.positions, places.once(stations.of_point)};
}

/** Give the copies of points what their places have. */
void
spreadToCopies(const DistinctPoints& places, DetailedBuilding& building)
{
  auto& cells = building.occupancy.cells;
  cells = places.forAll(cells);
  building.point_labels = places.forAll(building.point_labels);
  for (auto& room : building.rooms)
    room.point_count = 0;
  for (const auto label : building.point_labels)
    if (label > 0)
      ++building.rooms[label - 1].point_count;
}

} // namespace

void
labelBySides(const std::vector<Eigen::Vector3f>& points,
             const BuildingRoomsOptions& options,
             const std::vector<std::uint8_t>& storey_of,
             std::size_t storey,
             DetailedBuilding& building)
{
  StoreyLabels(points, building.occupancy, building.room_maps[storey], options)
      .assign(storey_of,
              static_cast<std::uint8_t>(storey),
              building.room_of[storey],
              building.point_labels);
}

BuildingRooms
segmentBuildingBy(const RoomWay& way,
                  const std::vector<Eigen::Vector3f>& points,
                  const BuildingRoomsOptions& options,
                  const ProgressCallback& progress,
                  const ScanStations& stations)
{
  if (!stations.of_point.empty() && stations.of_point.size() != points.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "There are stations of " << stations.of_point.size()
                                                 << " points for " << points.size()
                                                 << " points.");
  const auto places = placesOfCopies(points);
  if (!places)
    return published(segmentDistinct(way, points, options, progress, stations));
  auto building = segmentDistinct(
      way, places->once(points), options, progress, stationsOnce(stations, *places));
  if (!building.point_labels.empty())
    spreadToCopies(*places, building);
  return published(std::move(building));
}

BuildingRooms
segmentBuilding(const std::vector<Eigen::Vector3f>& points,
                const BuildingRoomsOptions& options,
                const ProgressCallback& progress,
                const ScanStations& stations)
{
  requireValid(options);
  const RoomWay ours = {
      [&options](const StoreySpace& space) {
        return segmentRoomMap(space, options.map, options.threads);
      },
      [&options](const auto& distinct, const auto& storey_of, auto s, auto& building) {
        labelBySides(distinct, options, storey_of, s, building);
      }};
  return segmentBuildingBy(ours, points, options, progress, stations);
}

} // namespace pcl::indoor
