/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/interior_space.h"

#include "rooms/dimensions.h"
#include "rooms/space/dominant_directions.h"
#include "rooms/space/enclosure.h"
#include "rooms/space/grid_cut.h"
#include "rooms/space/unseen_sides.h"
#include "rooms/space/vertical_cleanup.h"
#include "rooms/space/voxel_normals.h"

#include <Eigen/Geometry> // for cross()

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::indoor {
namespace {

GridShape
coarseShape(const GridShape& fine, int factor)
{
  const auto groups = [&](int count) { return (count + factor - 1) / factor; };
  return {groups(fine.nx), groups(fine.ny), groups(fine.nz)};
}

VoxelMap<std::uint8_t>
coarser(const VoxelBits& fine, int factor)
{
  VoxelMap<std::uint8_t> coarse;
  coarse.origin = fine.origin;
  coarse.voxel_size = fine.voxel_size * factor;
  coarse.shape = coarseShape(fine.shape, factor);
  coarse.values.assign(coarse.shape.size(), 0);
  for (int x = 0; x < fine.shape.nx; ++x)
    for (int y = 0; y < fine.shape.ny; ++y) {
      auto* to = &coarse.values[coarse.shape.index(x / factor, y / factor, 0)];
      fine.column(x, y).forEachSet(
          0, fine.shape.nz, [&](int z) { to[z / factor] = 1; });
    }
  return coarse;
}

/** The points of some square tiles of the map, so many that enough are left: directions
 * need no more. Which tiles are taken depends on their place alone. */
OccupancyGrid
someTiles(const std::vector<Eigen::Vector3f>& points,
          const OccupancyGrid& building,
          std::vector<Eigen::Vector3f>& chosen)
{
  constexpr std::size_t enough = 500000; // points
  constexpr int tile = 16;               // pixels along x and y
  const unsigned one_in =
      static_cast<unsigned>(std::max<std::size_t>(1, points.size() / enough));
  const GridShape& shape = building.grid.shape;
  OccupancyGrid part;
  part.grid.shape = shape; // its values are not needed
  part.grid.origin = building.grid.origin;
  part.grid.voxel_size = building.grid.voxel_size;
  part.yaw = building.yaw;
  std::vector<std::uint8_t> is_chosen; // per pixel
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y) {
      const unsigned u = x / tile, v = y / tile;
      is_chosen.push_back((u * 73856093u ^ v * 19349663u) / 16 % one_in == 0);
    }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int32_t cell = building.cells[i];
    if (cell < 0 || !is_chosen[cell / shape.nz])
      continue;
    chosen.push_back(points[i]);
    part.cells.push_back(cell);
  }
  return part;
}

/** Normals of the building's voxels, by how much they count. */
WeightedNormals
sampledNormals(const std::vector<Eigen::Vector3f>& points,
               const OccupancyGrid& building,
               int threads)
{
  std::vector<Eigen::Vector3f> chosen;
  const OccupancyGrid part = someTiles(points, building, chosen);
  return voxelNormals(chosen, part, threads);
}

/** The gain of each voxel, by Eq. (3.1). What it is found from is as large as the grid
 * and not kept.
 * \param[in,out] space gets the occupied voxels, and the sides that nobody has seen */
CodedGains
gainIn(InteriorSpace& space,
       const OccupancyGrid& building,
       const std::vector<Eigen::Vector3d>& directions,
       const InteriorSpaceOptions& options,
       int threads)
{
  auto occupancy = coarser(building.grid, space.factor);
  cleanUpVertically(occupancy, threads);
  space.occupancy = occupancy;
  const int count = static_cast<int>(directions.size());
  auto bits = enclosure(occupancy, directions, threads);
  space.unseen = findUnseenSides(occupancy, bits, count);
  return interiorGain(occupancy, std::move(bits), count, options.weights);
}

} // namespace

std::vector<Eigen::Vector3d>
wallDirections(const std::vector<Eigen::Vector3f>& points,
               const OccupancyGrid& building,
               const InteriorSpaceOptions& options,
               int threads)
{
  WeightedNormals sample = sampledNormals(points, building, threads);
  for (auto& normal : sample.normals) // a wall that leans counts by where it heads
    if (std::abs(normal.z()) < std::sin(steepest_lean)) {
      normal.z() = 0.0;
      normal.normalize();
    }
  std::vector<Eigen::Vector3d> directions;
  for (const auto& found :
       horizontalDirections(manhattanFrames(sample.normals, sample.weights))) {
    const bool few = directions.size() < 2; // Eq. (3.1) has two
    if (directions.size() < options.max_directions &&
        (few || found.support >= options.min_direction_support))
      directions.emplace_back(found.direction.x(), found.direction.y(), 0.0);
  }
  return directions;
}

std::vector<Eigen::Vector3d>
dominantDirections(const std::vector<Eigen::Vector3f>& points,
                   const OccupancyGrid& building,
                   const InteriorSpaceOptions& options,
                   int threads)
{
  const WeightedNormals sample = sampledNormals(points, building, threads);
  std::vector<std::pair<double, Eigen::Vector3d>> axes; // with their support
  for (const auto& frame : manhattanFrames(sample.normals, sample.weights))
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(frame.axes(2, axis)) < std::sqrt(0.5))
        axes.emplace_back(frame.axis_support[axis], frame.axes.col(axis));
  std::stable_sort(axes.begin(), axes.end(), [](const auto& a, const auto& b) {
    return a.first > b.first;
  });
  std::vector<Eigen::Vector3d> directions;
  for (const auto& [support, axis] : axes) {
    const bool known = std::any_of(
        directions.begin(), directions.end(), [&, axis = axis](const auto& other) {
          return std::abs(other.dot(axis)) >= std::cos(same_direction);
        });
    const bool few = directions.size() < 2; // Eq. (3.1) has two
    if (!known &&
        directions.size() < std::max<std::size_t>(2, options.max_directions) &&
        (few || support >= options.min_direction_support))
      directions.push_back(axis);
  }
  if (directions.empty())
    directions.push_back(Eigen::Vector3d::UnitX());
  if (directions.size() == 1)
    directions.push_back(Eigen::Vector3d::UnitZ().cross(directions[0]).normalized());
  return directions;
}

InteriorSpace
interiorSpace(const OccupancyGrid& building,
              const std::vector<Eigen::Vector3d>& directions,
              const InteriorSpaceOptions& options,
              int threads)
{
  InteriorSpace space;
  space.factor = voxelsIn(options.voxel_size, building.grid.voxel_size, 1);
  std::vector<Eigen::Vector3d> turned; // into the frame of the grid
  for (const auto& direction : directions) {
    turned.push_back(building.toGrid(direction));
    const Eigen::Vector2d heading = turned.back().head<2>();
    space.directions.push_back(direction.z() == 0.0 ? heading : heading.normalized());
  }
  VoxelMap<std::uint8_t> inside;
  inside.values = cutGrid(coarseShape(building.grid.shape, space.factor),
                          gainIn(space, building, turned, options, threads),
                          static_cast<int>(std::lround(options.smoothness / gain_unit)))
                      .inside;
  inside.shape = space.occupancy.shape;
  inside.origin = space.occupancy.origin;
  inside.voxel_size = space.occupancy.voxel_size;
  space.inside = inside;
  return space;
}

} // namespace pcl::indoor
