/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/scan_overview.h>

#include "rooms/dimensions.h"
#include "rooms/scan_sample.h"
#include "rooms/space/block_extent.h"
#include "rooms/space/closed_surfaces.h"
#include "rooms/space/interior_space.h"
#include "rooms/space/occupancy_grid.h"
#include "rooms/storeys/storey_plan.h"
#include "rooms/storeys/storeys.h"
#include "rooms/storeys/unseen_slabs.h"

#include <pcl/segmentation/building_frame.h>

#include <pcl/indoor/distinct_points.h>
#include <pcl/indoor/point_hash.h>
#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::indoor {
namespace {

using Points = std::vector<Eigen::Vector3f>;

/** One in so many points, chosen by the bits of their coordinates: all in one place
 * are, and a smaller sample is a part of a larger one. */
Points
sampleOf(const Points& points, std::size_t one_in)
{
  if (one_in <= 1)
    return points;
  const std::uint64_t most = (std::uint64_t{1} << 32) / one_in;
  Points sample(points.size());
  std::size_t count = 0;
  for (const auto& point : points) {
    sample[count] = point; // without a branch, which nothing could predict
    count += pointHash(point) >> 32 < most;
  }
  sample.resize(count);
  return sample;
}

/** Of the places with few points: where thousands are, they are all in a sample or
 * none. */
double
duplicateShare(const Points& sample)
{
  constexpr std::size_t few = 100; // points in one place
  const auto distinct = distinctPoints(sample);
  std::vector<std::size_t> counts(distinct.first.size(), 0);
  for (const auto place : distinct.place)
    ++counts[place];
  std::size_t points = 0, places = 0;
  for (const auto count : counts)
    if (count <= few) {
      points += count;
      ++places;
    }
  return points == 0
             ? 0.0
             : static_cast<double>(points - places) / static_cast<double>(points);
}

/** As fine as walls and floors are told apart by, as coarse as the points ask for. */
OccupancyGrid
gridOf(const Points& points)
{
  constexpr double coarsest = 0.8;    // metres
  constexpr double most_voxels = 2e7; // 80 MB in spacingOf()
  OccupancyGridOptions options;
  options.threads = 1; // others would take longer to wake up
  const Box box = blockExtent(points, options.threads);
  const double volume = (box.high - box.low + Eigen::Vector3d::Ones()).prod();
  options.voxel_size = std::max(options.voxel_size, std::cbrt(volume / most_voxels));
  auto grid = occupancyGrid(points, options);
  const double closed = closedVoxelSize(grid.grid, coarsest);
  if (closed > options.voxel_size) {
    options.voxel_size = closed;
    grid = occupancyGrid(points, options);
  }
  return grid;
}

/** \param[in] all points, of which the grid's are a sample */
double
spacingOf(const OccupancyGrid& grid, std::size_t all)
{
  std::vector<std::uint32_t> counts(grid.grid.shape.size(), 0);
  for (const auto cell : grid.cells)
    if (cell >= 0)
      ++counts[cell];
  counts.erase(std::remove(counts.begin(), counts.end(), 0u), counts.end());
  if (counts.empty())
    return 0.0;
  const double per_voxel = median(counts) * static_cast<double>(all) /
                           static_cast<double>(grid.cells.size());
  return grid.grid.voxel_size / std::sqrt(per_voxel);
}

Points
pointsInside(const Points& points, const OccupancyGrid& grid)
{
  Points inside;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (grid.cells[i] >= 0)
      inside.push_back(points[i]);
  return inside;
}

Eigen::Vector3d
extentOf(const Points& points)
{
  constexpr double stray = 0.002; // share of the points at each end
  constexpr std::size_t enough = 20000;
  const auto some = sampleOf(points, points.size() / enough);
  Eigen::Vector3d extent = Eigen::Vector3d::Zero();
  std::vector<float> values(some.size());
  for (int axis = 0; axis < 3 && !some.empty(); ++axis) {
    std::transform(some.begin(), some.end(), values.begin(), [axis](const auto& p) {
      return p[axis];
    });
    extent[axis] = quantile(values, 1.0 - stray) - quantile(values, stray);
  }
  return extent;
}

/** The median of the longest free heights of the columns, from point to point. */
double
roomHeight(const Points& points, const OccupancyGrid& grid)
{
  const auto& shape = grid.grid.shape;
  const int least = voxelsIn(least_height, grid.grid.voxel_size, 1);
  struct Gap {
    int below = -1, above = -1; // layers
    float floor = -1e9f, ceiling = 1e9f;
  };
  std::vector<Gap> gaps(static_cast<std::size_t>(shape.nx) * shape.ny);
  for (std::size_t column = 0; column < gaps.size(); ++column) {
    const auto voxels = grid.grid.column(column);
    for (int z = 0, last = -1; z < shape.nz; ++z) {
      if (!voxels[z])
        continue;
      if (last >= 0 && z - last - 1 >= least &&
          z - last > gaps[column].above - gaps[column].below) {
        gaps[column].below = last;
        gaps[column].above = z;
      }
      last = z;
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (grid.cells[i] < 0)
      continue;
    auto& gap = gaps[grid.cells[i] / shape.nz];
    const int z = grid.cells[i] % shape.nz;
    if (z == gap.below)
      gap.floor = std::max(gap.floor, points[i].z());
    else if (z == gap.above)
      gap.ceiling = std::min(gap.ceiling, points[i].z());
  }
  std::vector<float> heights;
  for (const auto& gap : gaps)
    if (gap.above > 0)
      heights.push_back(gap.ceiling - gap.floor);
  return heights.empty() ? 0.0 : static_cast<double>(median(heights));
}

void
setShares(const PlaceCounts& counts, ScanOverview& overview)
{
  const auto share = [](double part, double whole) {
    return whole > 0.0 ? part / whole : 0.0;
  };
  // courtyards and shafts are closed in, too: up to half may be places like these
  const double closed =
      std::max(0.0, 0.5 * counts.places - static_cast<double>(counts.seen));
  const double floors = counts.floors, seen = counts.seen;
  overview.floor_seen = share(floors, floors + counts.no_floors + closed);
  overview.ceiling_seen = share(counts.ceilings, seen + closed);
  overview.wall_sides = share(counts.sides, counts.seen);
}

} // namespace

ScanOverview
scanOverview(const std::vector<Eigen::Vector3f>& points,
             const Eigen::Vector3f& up_axis,
             double metres_per_unit)
{
  constexpr std::size_t enough = 200000; // points
  ScanOverview overview;
  if (points.empty())
    return overview;
  // a quarter of large scans, so that their surfaces have no holes
  const auto one_in = std::min<std::size_t>(points.size() / enough, 4);
  Points sample = sampleOf(points, one_in);
  overview.duplicates = duplicateShare(sampleOf(sample, points.size() / sample_size));
  moveIntoBuildingFrame(sample, up_axis, metres_per_unit);
  takeOutFarPoints(sample);
  if (sample.empty())
    return overview;
  const auto grid = gridOf(sample);
  overview.extent = extentOf(pointsInside(sample, grid));
  const double places =
      (1.0 - overview.duplicates) * static_cast<double>(points.size());
  overview.spacing = spacingOf(grid, static_cast<std::size_t>(places));
  if (overview.extent.z() < least_height)
    return overview;
  const auto storeys = findStoreys(grid.grid, {}, 1, unseenSlabs(grid));
  overview.storeys = storeys.heights.size();
  PlaceCounts enclosed, open;
  for (std::size_t s = 0; s < overview.storeys; ++s)
    countPlaces(grid.grid, storeys, s, enclosed, open);
  const double pixel = grid.grid.voxel_size * grid.grid.voxel_size; // m^2
  const bool has_rooms = pixel * enclosed.places > least_room;
  setShares(has_rooms ? enclosed : open, overview);
  overview.area = pixel * (has_rooms ? enclosed : open).area;
  overview.open_area = pixel * (has_rooms ? open.area : 0);
  // where few places have both, free heights end at furniture, lamps and doors
  if (std::min(overview.floor_seen, overview.ceiling_seen) > UnseenSides::least_seen)
    overview.room_height = roomHeight(sample, grid);
  return overview;
}

} // namespace pcl::indoor
