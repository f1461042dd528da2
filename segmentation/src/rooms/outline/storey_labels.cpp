/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/storey_labels.h"

#include "rooms/map/wall_lean.h"
#include "rooms/outline/wall_sides.h"
#include "rooms/space/potential_field.h"

#include <pcl/indoor/threads.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl {
namespace indoor {
namespace {

/** Pixels beside one of another room. */
PixelMap<std::uint8_t>
borderPixels(const PixelMap<std::int32_t>& labels)
{
  PixelMap<std::uint8_t> border{labels.nx, labels.ny, {}};
  border.values.assign(border.size(), 0);
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
{
  if (!map.lean.values.empty())
    slab_ = slabHeights(map.range, map.ceiling, map.slab);
}

void
StoreyLabels::assign(const std::vector<std::uint8_t>& storey_of,
                     std::uint8_t storey,
                     const std::vector<std::uint32_t>& room_of,
                     std::vector<std::uint32_t>& point_labels) const
{
  // Only near borders are there sides to choose, and walls to fit in the slab around.
  const auto to_border =
      squaredDistanceMap(borderPixels(map_.labels), options_.threads);
  const double radius = 0.5 * options_.walls.window / occupancy_.grid.voxel_size + 2.0;
  const double reach = 2.0 * radius * radius; // to the corner of the window, squared
  const auto count = static_cast<std::ptrdiff_t>(points_.size());
  const int threads = threadCount(options_.threads);
  std::vector<std::uint8_t> is_near(points_.size(), 0);
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    if (occupancy_.cells[i] < 0 || storey_of[i] != storey)
      continue;
    const std::size_t pixel = pixelOf(i);
    if (to_border.values[pixel] <= (inSlab(i, pixel) ? 4 * reach : reach))
      is_near[i] = 1;
    else
      point_labels[i] = room_of[map_.labels.values[pixel]];
  }
  std::vector<std::uint32_t> first(map_.labels.nx + 1, 0); // per row of pixels
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (is_near[i])
      ++first[pixelOf(i) / map_.labels.ny + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> near(first.back());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (is_near[i])
      near[next[pixelOf(i) / map_.labels.ny]++] = static_cast<std::uint32_t>(i);
  std::vector<std::uint8_t>().swap(is_near);

  // Strip by strip, so that large buildings need no more memory than others.
  constexpr std::uint32_t enough = 1 << 22; // points
  const int margin = static_cast<int>(std::ceil(radius));
  for (int begin = 0, end = 0; begin < map_.labels.nx; begin = end) {
    while (end < map_.labels.nx && first[end] <= first[begin] + enough)
      ++end;
    const int from = std::max(0, begin - margin);
    const int to = std::min(map_.labels.nx, end + margin);
    const auto labels = wallLabels(near.data() + first[from], near.data() + first[to]);
    for (std::uint32_t k = first[begin]; k < first[end]; ++k)
      point_labels[near[k]] = room_of[labels[k - first[from]]];
  }
}

/** Where a point lies on the map, pixels. */
Eigen::Vector2d
StoreyLabels::placeOf(std::size_t i) const
{
  const VoxelBits& grid = occupancy_.grid;
  const Eigen::Vector3d point = points_[i].cast<double>();
  Eigen::Vector3d place;
  place << turn_ * point.head<2>(), point.z();
  place = (place - grid.origin) / grid.voxel_size;
  place.z() -= map_.first_layer;
  if (map_.lean.values.empty())
    return place.head<2>();
  // The places at the border of the map stand for those beyond it.
  return straightened(map_.lean, slab_, place)
      .cwiseMax(0.0)
      .cwiseMin(Eigen::Vector2d(map_.labels.nx - 0.5, map_.labels.ny - 0.5));
}

std::size_t
StoreyLabels::pixelOf(std::size_t i) const
{
  const std::size_t pixel = occupancy_.cells[i] / occupancy_.grid.shape.nz;
  if (map_.lean.values.empty() || map_.lean.values[pixel].isZero(0.0f))
    return pixel;
  const Eigen::Vector2d place = placeOf(i);
  return map_.labels.index(static_cast<int>(place.x()), static_cast<int>(place.y()));
}

bool
StoreyLabels::inSlab(std::size_t i, std::size_t pixel) const
{
  const int layer = occupancy_.cells[i] % occupancy_.grid.shape.nz;
  const int below = map_.ceiling.values[pixel] + map_.first_layer - layer;
  return below >= map_.slab.first && below <= map_.slab.last;
}

/** Labels on the map of some of the points, told apart by the faces of walls. */
std::vector<std::int32_t>
StoreyLabels::wallLabels(const std::uint32_t* begin, const std::uint32_t* end) const
{
  const double size = occupancy_.grid.voxel_size;
  const std::ptrdiff_t count = end - begin;
  const int threads = threadCount(options_.threads);
  std::vector<Eigen::Vector2f> position(count);
  std::vector<std::uint8_t> is_wall(count);
  std::vector<std::int32_t> labels(count);
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    const std::uint32_t i = begin[k];
    const std::size_t pixel = pixelOf(i);
    position[k] = (size * placeOf(i)).cast<float>();
    // The top of a wardrobe may lie in the slab, but it does not go on to the ceiling.
    is_wall[k] = map_.blocked.values[pixel] != 0 && inSlab(i, pixel);
    labels[k] = map_.labels.values[pixel];
  }
  assignWallSides(
      position, is_wall, size, map_.labels, map_.free_labels, options_.walls, labels);
  return labels;
}

} // namespace indoor
} // namespace pcl
