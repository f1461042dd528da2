/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/storey_labels.h"

#include "rooms/map/wall_lean.h"
#include "rooms/space/distance_map.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl::indoor {
namespace {

/** Pixels beside one of another room. */
PixelMap<std::uint8_t>
borderPixels(const PixelMap<std::int32_t>& labels)
{
  auto border = PixelMap<std::uint8_t>::filled(labels.nx, labels.ny, 0);
  const auto compare = [&](std::size_t a, std::size_t b) {
    if (labels.values[a] == labels.values[b])
      return;
    border.values[a] |= labels.values[b] != 0;
    border.values[b] |= labels.values[a] != 0;
  };
  for (int x = 0; x < labels.nx; ++x)
    for (int y = 0; y < labels.ny; ++y) {
      if (x + 1 < labels.nx)
        compare(labels.index(x, y), labels.index(x + 1, y));
      if (y + 1 < labels.ny)
        compare(labels.index(x, y), labels.index(x, y + 1));
    }
  return border;
}

} // namespace

StoreyLabels::StoreyLabels(const std::vector<Eigen::Vector3f>& points,
                           const OccupancyGrid& occupancy,
                           const RoomMap& map,
                           const BuildingRoomsOptions& options)
: points_(points)
, occupancy_(occupancy)
, map_(map)
, options_(options)
, turn_(occupancy.turn())
, radius_(0.5 * options.walls.window / occupancy.grid.voxel_size + 2.0)
{
  if (!map.lean.values.empty())
    slab_ = slabHeights(map);
}

void
StoreyLabels::assign(const std::vector<std::uint8_t>& storey_of,
                     std::uint8_t storey,
                     const std::vector<std::uint32_t>& room_of,
                     std::vector<std::uint32_t>& point_labels) const
{
  auto near = labelFarPoints(storey_of, storey, room_of, point_labels);

  // Strip by strip, so that large buildings need no more memory than others.
  constexpr std::uint32_t enough = 1 << 22; // points
  const auto& first = near.first;
  const int margin = static_cast<int>(std::ceil(radius_));
  for (int begin = 0, end = 0; begin < map_.labels.nx; begin = end) {
    while (end < map_.labels.nx && first[end] <= first[begin] + enough)
      ++end;
    const int from = std::max(0, begin - margin);
    const int to = std::min(map_.labels.nx, end + margin);
    const auto strip = sortByPixels(from, to, near);
    std::vector<std::int32_t> labels(strip.places.size());
    for (std::size_t pixel = 0; pixel + 1 < strip.first.size(); ++pixel)
      std::fill(labels.begin() + strip.first[pixel],
                labels.begin() + strip.first[pixel + 1],
                map_.labels.values[map_.labels.index(from, 0) + pixel]);
    assignWallSides(strip,
                    occupancy_.grid.voxel_size,
                    map_.labels,
                    map_.free_labels,
                    options_.walls,
                    options_.threads,
                    labels);
    for (std::uint32_t k = first[begin]; k < first[end]; ++k)
      point_labels[near.points[k]] = room_of[labels[k - first[from]]];
  }
}

StoreyLabels::Voxel
StoreyLabels::voxelOf(std::size_t i) const
{
  const std::int32_t cell = occupancy_.cells[i], nz = occupancy_.grid.shape.nz;
  const std::int32_t column = cell / nz;
  return {column, cell - column * nz};
}

/** Whether walls do not lean there. */
bool
StoreyLabels::isUpright(const Voxel& voxel) const
{
  return map_.lean.values.empty() || map_.lean.values[voxel.column].isZero(0.0f);
}

/** Where a point lies on the map, pixels. */
Eigen::Vector2d
StoreyLabels::placeOf(std::size_t i, const Voxel& voxel) const
{
  const VoxelBits& grid = occupancy_.grid;
  const Eigen::Vector3d point = points_[i].cast<double>();
  Eigen::Vector3d place;
  place << turn_ * point.head<2>(), point.z();
  place = (place - grid.origin) / grid.voxel_size;
  place.z() -= map_.first_layer;
  if (isUpright(voxel))
    return place.head<2>();
  // The places at the border of the map stand for those beyond it.
  return straightened(map_.lean, slab_, place)
      .cwiseMax(0.0)
      .cwiseMin(Eigen::Vector2d(map_.labels.nx - 0.5, map_.labels.ny - 0.5));
}

std::int32_t
StoreyLabels::pixelOf(std::size_t i, const Voxel& voxel) const
{
  if (isUpright(voxel))
    return voxel.column;
  const Eigen::Vector2d place = placeOf(i, voxel);
  return static_cast<std::int32_t>(
      map_.labels.index(static_cast<int>(place.x()), static_cast<int>(place.y())));
}

/** Label the points by the map alone where there are no sides to choose and no walls
 * around to be fitted.
 * \return the others */
StoreyLabels::NearPoints
StoreyLabels::labelFarPoints(const std::vector<std::uint8_t>& storey_of,
                             std::uint8_t storey,
                             const std::vector<std::uint32_t>& room_of,
                             std::vector<std::uint32_t>& point_labels) const
{
  const auto to_border =
      squaredDistanceMap(borderPixels(map_.labels), options_.threads);
  const double reach = 2.0 * radius_ * radius_; // to the corner of the window, squared
  const std::size_t count = points_.size();
  const int parts = usefulThreads(options_.threads, count, 100000);
  const std::int32_t rows = map_.labels.nx, ny = map_.labels.ny;
  std::vector<std::uint8_t> is_near(count, 0);
  // Per part of the points and row: how many, then where they go.
  std::vector<std::vector<std::uint32_t>> next(parts);
  const auto rowOf = [&](std::size_t i) { return pixelOf(i, voxelOf(i)) / ny; };
  parallelFor(parts, parts, 1, [&](std::ptrdiff_t p) {
    next[p].assign(rows, 0);
    for (std::size_t i = count * p / parts; i < count * (p + 1) / parts; ++i) {
      if (storey_of[i] != storey || occupancy_.cells[i] < 0)
        continue;
      const Voxel voxel = voxelOf(i);
      const std::int32_t pixel = pixelOf(i, voxel);
      if (to_border.values[pixel] >
          (map_.inSlab(pixel, voxel.layer) ? 4 * reach : reach)) {
        point_labels[i] = room_of[map_.labels.values[pixel]];
        continue;
      }
      is_near[i] = 1;
      ++next[p][pixel / ny];
    }
  });
  NearPoints near;
  near.first.assign(1, 0);
  std::uint32_t sum = 0;
  for (std::int32_t row = 0; row < rows; ++row) {
    for (auto& of_part : next)
      sum += std::exchange(of_part[row], sum);
    near.first.push_back(sum);
  }
  near.points.resize(sum);
  parallelFor(parts, parts, 1, [&](std::ptrdiff_t p) {
    for (std::size_t i = count * p / parts; i < count * (p + 1) / parts; ++i)
      if (is_near[i])
        near.points[next[p][rowOf(i)]++] = static_cast<std::uint32_t>(i);
  });
  return near;
}

/** Bring the points of some rows into the order of their pixels. */
PixelPoints
StoreyLabels::sortByPixels(int begin_row, int end_row, NearPoints& near) const
{
  const std::int32_t ny = map_.labels.ny;
  const std::uint32_t before = near.first[begin_row];
  PixelPoints sorted;
  sorted.begin_row = begin_row;
  sorted.end_row = end_row;
  sorted.places.resize(near.first[end_row] - before);
  sorted.walls_end.resize(static_cast<std::size_t>(end_row - begin_row) * ny);
  sorted.first.resize(sorted.walls_end.size() + 1, near.first[end_row] - before);
  struct State { // of a row
    std::vector<std::uint32_t> points, group, next;
    std::vector<Eigen::Vector2f> places;
  };
  const auto sortRow = [&](State& state, std::ptrdiff_t row) {
    const std::uint32_t begin = near.first[begin_row + row];
    const std::uint32_t end = near.first[begin_row + row + 1];
    state.points.assign(near.points.begin() + begin, near.points.begin() + end);
    state.group.clear(); // two per pixel: at walls, and others
    state.places.clear();
    state.next.assign(2 * static_cast<std::size_t>(ny) + 1, 0);
    for (const std::uint32_t i : state.points) {
      const Voxel voxel = voxelOf(i);
      const std::int32_t pixel = pixelOf(i, voxel);
      // The top of a wardrobe may lie in the slab, but it does not go on to the
      // ceiling.
      const bool is_wall =
          map_.blocked.values[pixel] != 0 && map_.inSlab(pixel, voxel.layer);
      state.group.push_back(2 * (pixel % ny) + !is_wall);
      state.places.push_back(placeOf(i, voxel).cast<float>());
      ++state.next[state.group.back() + 1];
    }
    std::partial_sum(state.next.begin(), state.next.end(), state.next.begin());
    for (std::int32_t y = 0; y < ny; ++y) {
      const std::size_t pixel = static_cast<std::size_t>(row) * ny + y;
      sorted.first[pixel] = begin - before + state.next[2 * y];
      sorted.walls_end[pixel] = begin - before + state.next[2 * y + 1];
    }
    for (std::size_t k = 0; k < state.points.size(); ++k) {
      const std::uint32_t to = begin + state.next[state.group[k]]++;
      near.points[to] = state.points[k];
      sorted.places[to - before] = state.places[k];
    }
  };
  parallelFor(
      end_row - begin_row,
      threadCount(options_.threads),
      4,
      [] { return State(); },
      sortRow);
  return sorted;
}

} // namespace pcl::indoor
