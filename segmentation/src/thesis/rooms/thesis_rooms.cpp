/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/thesis.h>

#include "internal/option_check.h"
#include "rooms/map/region_evidence.h" // for relabel
#include "rooms/room_way.h"
#include "rooms/space/nearest_sites.h"
#include "thesis/rooms/field_rooms.h"
#include "thesis/rooms/map_labels.h"

#include <pcl/indoor/require_valid.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl::indoor {
namespace thesis {
namespace {

/** The rooms of the field map on the pixels of the map. */
PixelMap<std::int32_t>
fieldRoomsOnMap(const FieldRooms& rooms, int factor, const PixelMap<float>& field)
{
  PixelMap<std::int32_t> labels{field.nx, field.ny, {}};
  labels.values.resize(labels.size());
  for (int x = 0; x < field.nx; ++x)
    for (int y = 0; y < field.ny; ++y)
      labels.at(x, y) = rooms.labels.at(x / factor, y / factor) + 1;
  return labels;
}

/** The room of each coarse voxel of a storey, 0 = none, by the vote of Sec. 3.2.3. */
VoxelMap<int>
votedVoxels(const StoreySpace& space, const RoomMap& map, int threads)
{
  const GridShape& shape = space.interior.occupancy.shape;
  const int factor = space.interior.factor;
  PixelMap<int> labels{shape.nx, shape.ny, {}};
  labels.values.resize(labels.size());
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y)
      labels.at(x, y) =
          map.free_labels.at(std::min(x * factor, map.free_labels.nx - 1),
                             std::min(y * factor, map.free_labels.ny - 1)) -
          1;
  return labelVoxels(
      space.interior.occupancy.bytes(), space.interior.inside.bytes(), labels, threads);
}

/** Label the points of one storey by the voxels they lie in. */
void
labelByVote(int threads,
            const std::vector<std::uint8_t>& storey_of,
            std::size_t storey,
            DetailedBuilding& building)
{
  const VoxelBits& grid = building.occupancy.grid;
  const auto space = storeySpace(grid, building.interior, building.storeys, storey);
  const auto votes = votedVoxels(space, building.room_maps[storey], threads);
  const int factor = building.interior.factor;
  const int first = building.room_maps[storey].first_layer / factor;
  for (std::size_t i = 0; i < storey_of.size(); ++i) {
    const std::int32_t cell = building.occupancy.cells[i];
    if (cell < 0 || storey_of[i] != storey)
      continue;
    const int pixel = cell / grid.shape.nz;
    const int x = pixel / grid.shape.ny / factor, y = pixel % grid.shape.ny / factor;
    const int z = cell % grid.shape.nz / factor - first;
    if (votes.shape.contains(x, y, z))
      building.point_labels[i] = building.room_of[storey][votes.at(x, y, z) + 1];
  }
}

/** Carry the labels of free pixels into the walls, and number the regions 1 ... n by
 * their first pixels.
 * \param[in] reach pixels */
void
numberRegions(double reach, RoomMap& map)
{
  map.labels = map.free_labels;
  growLabels(map.labels, reach);
  const auto& labels = map.labels.values;
  std::vector<std::int32_t> number(*std::max_element(labels.begin(), labels.end()) + 1,
                                   0);
  std::int32_t count = 0;
  for (const std::int32_t label : labels)
    if (label != 0 && number[label] == 0)
      number[label] = ++count;
  relabel(number, map);
}

/** The rooms of a storey, on the map of its walls. */
RoomMap
fieldRoomMap(const StoreySpace& space, const RoomOptions& options)
{
  const BuildingRoomsOptions& shared = options.shared;
  RoomMap map = mapWithoutRooms(space, shared.map, shared.threads);
  const FieldRooms rooms =
      segmentFieldMap(space.interior, options.field, shared.map.slab);
  map.potential = rooms.field;
  map.potential_factor = space.interior.factor;
  map.free_labels = fieldRoomsOnMap(rooms, space.interior.factor, map.field);
  numberRegions(shared.map.reach / space.occupancy.voxel_size, map);
  return map;
}

} // namespace

BuildingRooms
segmentBuilding(const std::vector<Eigen::Vector3f>& points,
                RoomOptions options,
                const ProgressCallback& progress,
                const ScanStations& stations)
{
  requireValid(options);
  const BuildingRoomsOptions& shared = options.shared;
  options.field.threads = shared.threads;
  const RoomWay way = {
      [&options](const StoreySpace& space) { return fieldRoomMap(space, options); },
      [&](const auto& distinct, const auto& storey_of, auto s, auto& building) {
        if (options.point_rooms == PointRooms::WallSides)
          labelBySides(distinct, shared, storey_of, s, building);
        else
          labelByVote(shared.threads, storey_of, s, building);
      }};
  return segmentBuildingBy(way, points, shared, progress, stations);
}

std::string
findProblem(const RoomOptions& options)
{
  if (const auto problem = indoor::findProblem(options.shared); !problem.empty())
    return problem;
  constexpr double infinity = OptionCheck::infinity;
  OptionCheck check;
  const FieldRoomsOptions& field = options.field;
  const double most = std::numeric_limits<float>::max(); // finite
  const MapDistanceOptions& distance = field.distance;
  check.between(0, most, "visibility weight", distance.visibility_weight, "");
  check.between(0, most, "Euclidean weight", distance.euclidean_weight, "");
  check.between(0, most, "field weight", distance.field_weight, "");
  check.between(0, most, "Euclidean scale", distance.euclidean_scale, " pixels");
  check.between(1, 1e6, "number of the histogram's bins", field.peaks.bins, "");
  check.between(0, 1e6, "histogram's smoothing", field.peaks.smoothing, " bins");
  check.between(0, infinity, "prominence of a peak", field.peaks.prominence, "");
  check.between(0, most, "DBSCAN distance", field.dbscan_distance, "");
  check.positive("least area of a cluster", field.min_cluster_area, 1e6, " m^2");
  check.positive("sample area of a cluster", field.sample_area, 1e6, " m^2");
  check.length("spacing of landmarks", field.landmark_spacing);
  check.between(0, most, "random walker's beta", field.beta, "");
  return check.problem();
}

} // namespace thesis

thesis::RoomOptions
thesisRoomOptions()
{
  thesis::RoomOptions options;
  auto& shared = options.shared;
  shared.voxel_size = shared.interior.voxel_size = 0.2;
  shared.align_grid = false;
  shared.interior.upright_walls = false;
  shared.interior.max_directions = 2;
  options.field.landmark_spacing = 0.0;
  options.field.peaks_on_slopes = true;
  options.point_rooms = thesis::PointRooms::Vote;
  return options;
}

} // namespace pcl::indoor
