/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/storeys/storey_plan.h"

#include "rooms/dimensions.h"
#include "rooms/space/map_regions.h"

#include <pcl/indoor/quantile.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pcl::indoor {
namespace {

/** What a storey has in a column, as bits. */
enum Column : std::uint8_t {
  nothing = 0,
  low = 1,   ///< a floor, or an object on it
  floor = 2, ///< that goes on over some square metres, as no object does
  high = 4,  ///< a ceiling, or what hangs from it
  wall = 8
};

/** The voxels of a column in a storey. */
struct Layers {
  int begin, end;
};

/** Count a place with its column. */
void
add(std::uint8_t column, int own_sides, PlaceCounts& counts)
{
  ++counts.places;
  if (column == nothing)
    return;
  ++counts.seen;
  counts.floors += (column & floor) != 0;
  counts.no_floors += (column & low) == 0;
  counts.ceilings += (column & high) != 0;
  counts.sides += own_sides;
}

/** A storey as it is seen from above. */
class StoreyPlan {
public:
  StoreyPlan(const VoxelBits& grid, const Storeys& storeys, std::size_t s)
  : grid_(grid)
  , storeys_(storeys)
  , storey_(s)
  , gap_(voxelsIn(least_height, grid.voxel_size, 1))
  , columns_(PixelMap<std::uint8_t>::filled(grid.shape.nx, grid.shape.ny, nothing))
  , lowest_(PixelMap<int>::filled(grid.shape.nx, grid.shape.ny, 0))
  , sides_(PixelMap<std::uint8_t>::filled(grid.shape.nx, grid.shape.ny, 0))
  {
    findHeights();
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
          add(column, sides, counts);
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
    constexpr double few = 0.25; // of the median layer
    std::vector<std::size_t> counts(grid_.shape.nz, 0);
    for (int x = 0; x < grid_.shape.nx; ++x)
      for (int y = 0; y < grid_.shape.ny; ++y) {
        const auto [begin, end] = layers(x, y);
        const auto voxels = grid_.column(x, y);
        for (int z = begin; z < end; ++z)
          counts[z] += voxels[z];
      }
    const double least = few * usualCount(counts);
    for (int z = 0; z < grid_.shape.nz; ++z)
      if (counts[z] > 0 && static_cast<double>(counts[z]) >= least) {
        bottom_ = heights_known_ ? bottom_ : z;
        top_ = z;
        heights_known_ = true;
      }
    const int tall = voxelsIn(standing_height, grid_.voxel_size);
    wall_ = std::max(2, std::min(tall, (top_ - bottom_ + 2) / 2));
  }

  std::uint8_t
  columnAt(int x, int y)
  {
    const auto [begin, end] = layers(x, y);
    const auto voxels = grid_.column(x, y);
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
    auto reached = PixelMap<std::uint8_t>::filled(columns_.nx, columns_.ny, 0);
    const auto enter = [&](std::size_t other, std::size_t from) {
      return (columns_.values[other] & low) != 0 &&
             std::abs(lowest_.values[other] - lowest_.values[from]) <= 1 &&
             !std::exchange(reached.values[other], 1);
    };
    for (std::size_t start = 0; start < columns_.size(); ++start) {
      if (!enter(start, start))
        continue;
      std::vector<std::size_t> patch = {start};
      floodFill(patch, neighboursIn(columns_, Neighbours::Four), enter);
      if (static_cast<double>(patch.size()) >= least)
        for (const auto pixel : patch)
          columns_.values[pixel] |= floor;
    }
  }

  /** On how many of the four sides a wall stands, near or far. */
  void
  findSides()
  {
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

  const VoxelBits& grid_;
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

} // namespace

double
usualCount(std::vector<std::size_t> counts)
{
  counts.erase(std::remove(counts.begin(), counts.end(), 0u), counts.end());
  return counts.empty() ? 0.0 : static_cast<double>(median(counts));
}

void
countPlaces(const VoxelBits& grid,
            const Storeys& storeys,
            std::size_t storey,
            PlaceCounts& enclosed,
            PlaceCounts& open)
{
  StoreyPlan(grid, storeys, storey).addTo(enclosed, open);
}

} // namespace pcl::indoor
