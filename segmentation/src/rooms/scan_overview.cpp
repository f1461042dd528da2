/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/rooms/building_frame.h>
#include <pcl/segmentation/rooms/occupancy_grid.h>
#include <pcl/segmentation/rooms/storeys.h>
#include <pcl/segmentation/scan_overview.h>

#include "rooms/space/block_extent.h"
#include "rooms/space/closed_surfaces.h"
#include <pcl/indoor/flood_fill.h>
#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl {
namespace indoor {
namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr double least_height = 1.0; // metres, of free space and of a scan with rooms
constexpr double least_room = 4.0;   // m^2

/** One in so many points, chosen by the bits of their coordinates: all in one place
 * are, and a smaller sample is a part of a larger one. */
Points
sampleOf(const Points& points, std::size_t one_in)
{
  if (one_in <= 1)
    return points;
  const std::uint64_t most = (std::uint64_t{1} << 32) / one_in;
  Points sample;
  for (const auto& point : points) {
    std::uint32_t bits[3];
    std::memcpy(bits, point.data(), sizeof(bits));
    std::uint64_t hash = 0;
    for (const std::uint32_t part : bits)
      hash = (hash ^ part) * 0x9e3779b97f4a7c15u;
    hash = (hash ^ hash >> 29) * 0xbf58476d1ce4e5b9u;
    if (hash >> 32 < most)
      sample.push_back(point);
  }
  return sample;
}

/** Of the places with few points: where thousands are, they are all in a sample or
 * none. */
double
duplicateShare(Points sample)
{
  constexpr std::ptrdiff_t few = 100;
  const auto place = [](const auto& p) { return std::make_tuple(p.x(), p.y(), p.z()); };
  const auto less = [&](const auto& a, const auto& b) { return place(a) < place(b); };
  std::sort(sample.begin(), sample.end(), less);
  std::ptrdiff_t points = 0, places = 0;
  for (auto begin = sample.begin(), end = begin; begin != sample.end(); begin = end) {
    end = std::find_if(begin, sample.end(), [&](const auto& p) { return p != *begin; });
    if (end - begin > few)
      continue;
    points += end - begin;
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
  constexpr double most_voxels = 2e7; // bytes
  OccupancyGridOptions options;
  options.threads = 1; // others would take longer to wake up
  const Box box = blockExtent(
      points, {options.block_size, options.max_growth, options.min_density, 1});
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
  std::vector<std::uint32_t> counts(grid.grid.values.size(), 0);
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

/** What a storey has in a column, as bits. */
enum Column : std::uint8_t {
  nothing = 0,
  low = 1,   ///< a floor, or a thing on it
  floor = 2, ///< that goes on over some square metres, as no thing does
  high = 4,  ///< a ceiling, or what hangs from it
  wall = 8
};

/** The voxels of a column in a storey. */
struct Layers {
  int begin, end;
};

/** Pixels of the storeys' plans. */
struct PlaceCounts {
  std::size_t area = 0;   ///< of places, but for walls
  std::size_t places = 0; ///< those not beside walls either, where voxels hold both
  std::size_t seen = 0;   ///< with anything in their column
  std::size_t floors = 0, no_floors = 0; ///< under things it is not known
  std::size_t ceilings = 0;
  std::size_t sides = 0; ///< of the places that were seen, those towards a wall

  void
  add(std::uint8_t column, int own_sides)
  {
    ++places;
    if (column == nothing)
      return;
    ++seen;
    floors += (column & floor) != 0;
    no_floors += (column & low) == 0;
    ceilings += (column & high) != 0;
    sides += own_sides;
  }
};

/** A storey as it is seen from above. */
class StoreyPlan {
public:
  StoreyPlan(const VoxelMap<std::uint8_t>& grid, const Storeys& storeys, std::size_t s)
  : grid_(grid)
  , storeys_(storeys)
  , storey_(s)
  , gap_(std::max(1, static_cast<int>(std::lround(least_height / grid.voxel_size))))
  , columns_{grid.shape.nx, grid.shape.ny, {}}
  {
    findHeights();
    columns_.values.assign(columns_.size(), nothing);
    lowest_ = {columns_.nx, columns_.ny, std::vector<int>(columns_.size(), 0)};
    for (int x = 0; x < columns_.nx; ++x)
      for (int y = 0; y < columns_.ny; ++y)
        columns_.at(x, y) = columnAt(x, y);
    findFloors();
    findSides();
  }

  /** \param[in,out] enclosed places with walls around them, as rooms have
   * \param[in,out] open other places where something was seen */
  void
  addTo(PlaceCounts& enclosed, PlaceCounts& open) const
  {
    for (int x = 0; x < columns_.nx; ++x)
      for (int y = 0; y < columns_.ny; ++y) {
        const auto column = columns_.at(x, y);
        const int sides = sides_.at(x, y);
        const bool is_nothing = column == nothing;
        const bool has_walls = sides >= (is_nothing ? 4 : 2); // a window is no wall
        if (column == wall || (is_nothing && !has_walls))
          continue;
        auto& counts = has_walls ? enclosed : open;
        ++counts.area;
        if (!isBesideWall(x, y))
          counts.add(column, sides);
      }
  }

private:
  Layers
  layers(int x, int y) const
  {
    const auto above = [&](double height) {
      const double layer = (height - grid_.origin.z()) / grid_.voxel_size - 0.5;
      return static_cast<int>(
          std::ceil(std::clamp(layer, 0.0, static_cast<double>(grid_.shape.nz))));
    };
    const auto& borders = storeys_.borders;
    // a slab may be one voxel, floor and ceiling
    return {storey_ == 0 ? 0 : std::max(0, above(borders[storey_ - 1].at(x, y)) - 1),
            storey_ == borders.size()
                ? grid_.shape.nz
                : std::min(grid_.shape.nz, above(borders[storey_].at(x, y)) + 1)};
  }

  /** From the lowest to the highest layer with more than a few voxels. */
  void
  findHeights()
  {
    constexpr double few = 0.25;        // of the median layer
    constexpr double wall_height = 1.5; // metres: higher than most furniture
    std::vector<std::size_t> counts(grid_.shape.nz, 0);
    for (int x = 0; x < grid_.shape.nx; ++x)
      for (int y = 0; y < grid_.shape.ny; ++y) {
        const auto [begin, end] = layers(x, y);
        const auto* const voxels = &grid_.values[grid_.shape.index(x, y, 0)];
        for (int z = begin; z < end; ++z)
          counts[z] += voxels[z];
      }
    auto sorted = counts;
    sorted.erase(std::remove(sorted.begin(), sorted.end(), 0u), sorted.end());
    const double least =
        sorted.empty() ? 0.0 : few * static_cast<double>(median(sorted));
    for (int z = 0; z < grid_.shape.nz; ++z)
      if (counts[z] > 0 && static_cast<double>(counts[z]) >= least) {
        bottom_ = heights_known_ ? bottom_ : z;
        top_ = z;
        heights_known_ = true;
      }
    const int tall = static_cast<int>(std::lround(wall_height / grid_.voxel_size));
    wall_ = std::max(2, std::min(tall, (top_ - bottom_ + 2) / 2));
  }

  std::uint8_t
  columnAt(int x, int y)
  {
    const auto [begin, end] = layers(x, y);
    const auto* const voxels = &grid_.values[grid_.shape.index(x, y, 0)];
    int groups = 0, first = 0, bottom = 0,
        top = 0; // of occupied voxels; of the last one
    for (int z = std::max(begin, bottom_); z < std::min(end, top_ + 1); ++z) {
      if (!voxels[z])
        continue;
      if (groups == 0)
        first = z;
      if (groups == 0 || z - top - 1 >= gap_) {
        ++groups;
        bottom = z;
      }
      top = z;
    }
    if (groups == 0)
      return nothing;
    if (groups == 1 && top - bottom + 1 >= wall_)
      return wall;
    const bool is_low = groups > 1 || bottom + top < bottom_ + top_;
    const bool is_high = groups > 1 || !is_low;
    lowest_.at(x, y) = first;
    return static_cast<std::uint8_t>((is_low ? low : 0) | (is_high ? high : 0));
  }

  /** Floors are low columns that lie together, each as high as the next or a layer
   * higher: they may lean. */
  void
  findFloors()
  {
    const double least = least_room / (grid_.voxel_size * grid_.voxel_size);
    PixelMap<std::uint8_t> reached{columns_.nx, columns_.ny, {}};
    reached.values.assign(reached.size(), 0);
    const auto for_each_neighbor = [&](std::size_t pixel, const auto& visit) {
      const int x = static_cast<int>(pixel) / columns_.ny;
      const int y = static_cast<int>(pixel) % columns_.ny;
      for (const auto& [u, v] :
           {std::pair{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}})
        if (columns_.contains(u, v))
          visit(columns_.index(u, v));
    };
    const auto enter = [&](std::size_t other, std::size_t from) {
      return (columns_.values[other] & low) != 0 &&
             std::abs(lowest_.values[other] - lowest_.values[from]) <= 1 &&
             !std::exchange(reached.values[other], 1);
    };
    for (std::size_t start = 0; start < columns_.size(); ++start) {
      if (!enter(start, start))
        continue;
      std::vector<std::size_t> patch = {start};
      floodFill(patch, for_each_neighbor, enter);
      if (static_cast<double>(patch.size()) >= least)
        for (const auto pixel : patch)
          columns_.values[pixel] |= floor;
    }
  }

  /** On how many of the four sides a wall stands, near or far. */
  void
  findSides()
  {
    sides_ = {columns_.nx, columns_.ny, {}};
    sides_.values.assign(sides_.size(), 0);
    const int last_x = columns_.nx - 1, last_y = columns_.ny - 1;
    for (int x = 0; x <= last_x; ++x) {
      addSides({x, 0}, {0, 1});
      addSides({x, last_y}, {0, -1});
    }
    for (int y = 0; y <= last_y; ++y) {
      addSides({0, y}, {1, 0});
      addSides({last_x, y}, {-1, 0});
    }
  }

  void
  addSides(Eigen::Vector2i at, const Eigen::Vector2i& step)
  {
    bool has_wall = false;
    for (; columns_.contains(at.x(), at.y()); at += step) {
      has_wall = has_wall || columns_.at(at.x(), at.y()) == wall;
      sides_.at(at.x(), at.y()) += has_wall;
    }
  }

  /** There voxels hold parts of the wall. */
  bool
  isBesideWall(int x, int y) const
  {
    for (int u = std::max(0, x - 1); u <= std::min(columns_.nx - 1, x + 1); ++u)
      for (int v = std::max(0, y - 1); v <= std::min(columns_.ny - 1, y + 1); ++v)
        if (columns_.at(u, v) == wall)
          return true;
    return false;
  }

  const VoxelMap<std::uint8_t>& grid_;
  const Storeys& storeys_;
  std::size_t storey_;
  int gap_;                  // voxels
  int bottom_ = 0, top_ = 0; // layers
  int wall_ = 0;             // voxels
  bool heights_known_ = false;
  PixelMap<std::uint8_t> columns_;
  PixelMap<int> lowest_; // layers
  PixelMap<std::uint8_t> sides_;
};

/** The median of the longest free heights of the columns, from point to point. */
double
roomHeight(const Points& points, const OccupancyGrid& grid)
{
  const auto& shape = grid.grid.shape;
  const int least =
      std::max(1, static_cast<int>(std::lround(least_height / grid.grid.voxel_size)));
  struct Gap {
    int below = -1, above = -1; // layers
    float floor = -1e9f, ceiling = 1e9f;
  };
  std::vector<Gap> gaps(static_cast<std::size_t>(shape.nx) * shape.ny);
  for (std::size_t column = 0; column < gaps.size(); ++column) {
    const auto* const voxels = &grid.grid.values[column * shape.nz];
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
  constexpr std::size_t enough = 200000, few = 15000;
  constexpr double few_seen = 0.3;
  ScanOverview overview;
  if (points.empty())
    return overview;
  // a quarter of large scans, so that their surfaces have no holes
  const auto one_in = std::min<std::size_t>(points.size() / enough, 4);
  Points sample = sampleOf(points, one_in);
  overview.duplicates = duplicateShare(sampleOf(sample, points.size() / few));
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
  StoreyOptions options;
  options.threads = 1;
  const auto storeys = findStoreys(grid.grid, options);
  overview.storeys = storeys.heights.size();
  PlaceCounts enclosed, open;
  for (std::size_t s = 0; s < overview.storeys; ++s)
    StoreyPlan(grid.grid, storeys, s).addTo(enclosed, open);
  const double pixel = grid.grid.voxel_size * grid.grid.voxel_size; // m^2
  const bool has_rooms = pixel * enclosed.places > least_room;
  setShares(has_rooms ? enclosed : open, overview);
  overview.area = pixel * (has_rooms ? enclosed : open).area;
  overview.open_area = pixel * (has_rooms ? open.area : 0);
  // where few places have both, free heights end at furniture, lamps and doors
  if (std::min(overview.floor_seen, overview.ceiling_seen) > few_seen)
    overview.room_height = roomHeight(sample, grid);
  return overview;
}

} // namespace indoor
} // namespace pcl
