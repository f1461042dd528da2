/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/storeys/slab_levels.h"

#include "rooms/dimensions.h"
#include "rooms/space/map_regions.h"
#include <pcl/indoor/quantile.h>
#include <pcl/indoor/threads.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

namespace pcl::indoor {

namespace {

/** \brief Free voxels of a column between two occupied ones, as high as a person. */
struct FreeRun {
  int low;
  int high;
};

/** \brief What slabs are looked for in: the groups and free runs of each column. */
class SlabColumns {
public:
  SlabColumns(const VoxelBits& occupancy, const StoreyOptions& options)
  : occupancy_(occupancy)
  , shape_(occupancy.shape)
  , clearance_(voxelsIn(options.min_clearance, occupancy.voxel_size, 1))
  , max_height_(1 + voxelsIn(options.max_slab, occupancy.voxel_size))
  , breast_(voxelsIn(breast, occupancy.voxel_size, 1))
  , reach_(voxelsIn(room_size, occupancy.voxel_size, 2))
  {
    first_group_.reserve(occupancy.columns() + 1);
    first_run_.reserve(occupancy.columns() + 1);
    for (int x = 0; x < shape_.nx; ++x)
      for (int y = 0; y < shape_.ny; ++y)
        addColumn(x, y, occupancy.column(x, y));
    beginColumn();
  }

  const std::vector<SlabGroup>&
  groups() const
  {
    return groups_;
  }

  /** \brief Whether the slab goes on at the height of a group in most of the columns
   * around it; walls and what lies outside do not count.
   */
  bool
  isLevel(const SlabGroup& group, int radius, int step) const
  {
    int level = 0, other = 0;
    for (int dx = -radius; dx <= radius; dx += step)
      for (int dy = -radius; dy <= radius; dy += step) {
        const int x = group.x + dx, y = group.y + dy;
        if (x < 0 || y < 0 || x >= shape_.nx || y >= shape_.ny)
          continue;
        const std::size_t column = static_cast<std::size_t>(x) * shape_.ny + y;
        if (goesOn(group, column))
          ++level;
        else if (hasOtherHeight(group, column))
          ++other;
      }
    return level >= other;
  }

private:
  static constexpr double breast = 1.0;    // metres: walls are seen best there
  static constexpr double room_size = 8.0; // metres, as far as walls are looked for

  void
  beginColumn()
  {
    first_group_.push_back(static_cast<std::uint32_t>(groups_.size()));
    first_run_.push_back(static_cast<std::uint32_t>(runs_.size()));
  }

  void
  addColumn(int x, int y, const VoxelBits::Column& column)
  {
    beginColumn();
    SlabGroup group{x, y, -1, -1};
    bool is_lowest = true; // nothing lies below it
    for (int z = 0; z < shape_.nz; ++z) {
      if (!column[z])
        continue;
      if (group.low >= 0 && z - group.high - 1 >= clearance_) {
        runs_.push_back({group.high + 1, z - 1});
        addGroup(group, is_lowest, false);
        is_lowest = false;
        group.low = -1;
      }
      if (group.low < 0)
        group.low = z;
      group.high = z;
    }
    if (group.low >= 0)
      addGroup(group, is_lowest, true);
  }

  /** \brief Where nothing was seen above, or below, walls tell that a storey is there.
   */
  void
  addGroup(const SlabGroup& group, bool is_lowest, bool is_highest)
  {
    if (group.high - group.low < max_height_ &&
        (!is_lowest || isAmongWalls(group.x, group.y, group.low - breast_)) &&
        (!is_highest || isAmongWalls(group.x, group.y, group.high + breast_)))
      groups_.push_back(group);
  }

  /** \brief Whether something stands on at least three of the four sides of a voxel:
   * beside a roof there is but the wall of a higher part. */
  bool
  isAmongWalls(int x, int y, int z) const
  {
    if (z < 0 || z >= shape_.nz)
      return false;
    int sides = 0;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
      for (int k = 1, u = x + dx, v = y + dy;
           k < reach_ && u >= 0 && v >= 0 && u < shape_.nx && v < shape_.ny;
           ++k, u += dx, v += dy)
        if (occupancy_.at(u, v, z)) {
          ++sides;
          break;
        }
    return sides >= 3;
  }

  /** \brief Whether a column has the same floor or the same ceiling, to a voxel. */
  bool
  goesOn(const SlabGroup& group, std::size_t column) const
  {
    return std::any_of(groups_.begin() + first_group_[column],
                       groups_.begin() + first_group_[column + 1],
                       [&](const SlabGroup& other) {
                         return std::abs(other.low - group.low) <= 1 ||
                                std::abs(other.high - group.high) <= 1;
                       });
  }

  /** \brief Whether a column is free where the group is, or has something else there:
   * the tread of a stair, a landing. */
  bool
  hasOtherHeight(const SlabGroup& group, std::size_t column) const
  {
    const auto overlaps = [&](const auto& other) {
      return other.low <= group.high && group.low <= other.high;
    };
    return std::any_of(runs_.begin() + first_run_[column],
                       runs_.begin() + first_run_[column + 1],
                       overlaps) ||
           std::any_of(groups_.begin() + first_group_[column],
                       groups_.begin() + first_group_[column + 1],
                       overlaps);
  }

  const VoxelBits& occupancy_;
  GridShape shape_;
  int clearance_;
  int max_height_;
  int breast_;                             // layers above a floor or below a ceiling
  int reach_;                              // columns
  std::vector<SlabGroup> groups_;          // by column
  std::vector<FreeRun> runs_;              // by column
  std::vector<std::uint32_t> first_group_; // of each column
  std::vector<std::uint32_t> first_run_;   // the same
};

/** \brief The groups that are parts of slabs. */
std::vector<SlabGroup>
levelGroups(const SlabColumns& columns, double voxel_size, int threads)
{
  constexpr int samples = 3; // to either side
  const int step = std::max(1, static_cast<int>(surroundings / samples / voxel_size));
  const auto& groups = columns.groups();
  const auto count = static_cast<std::ptrdiff_t>(groups.size());
  std::vector<std::uint8_t> is_level(groups.size());
#pragma omp parallel for schedule(dynamic, 1024) num_threads(threads)
  for (std::ptrdiff_t g = 0; g < count; ++g)
    is_level[g] = columns.isLevel(groups[g], samples * step, step);
  std::vector<SlabGroup> level;
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (is_level[g])
      level.push_back(groups[g]);
  return level;
}

/** \brief Take the groups at the most frequent height, in half voxels, out of others.
 * \param[in] reach groups so far from it belong to it
 * \param[in] least so many must be at that very height, which those of a ramp are not
 * \return nothing if there are too few
 */
std::vector<SlabGroup>
takeMostFrequent(std::vector<SlabGroup>& groups, int layers, int reach, double least)
{
  std::vector<std::size_t> counts(2 * layers + 1, 0);
  for (const auto& group : groups)
    ++counts[group.low + group.high];
  const auto near = [&](int height) {
    std::size_t sum = 0;
    for (int h = std::max(0, height - 1); h <= std::min(height + 1, 2 * layers); ++h)
      sum += counts[h];
    return sum;
  };
  int best = 0;
  for (int height = 1; height <= 2 * layers; ++height)
    if (near(height) > near(best))
      best = height;
  if (static_cast<double>(near(best)) < least)
    return {};
  std::vector<SlabGroup> taken, kept;
  for (const auto& group : groups)
    (std::abs(group.low + group.high - best) > reach ? kept : taken).push_back(group);
  groups = std::move(kept);
  return taken;
}

/** \brief Drop the groups that do not lie with enough others: galleries. What lies in
 * neighbouring tiles lies together, also across walls. */
void
dropSmallParts(const GridShape& shape,
               int tile,
               double min_groups,
               std::vector<SlabGroup>& groups)
{
  auto tiles = PixelMap<std::uint8_t>::filled(
      (shape.nx - 1) / tile + 1, (shape.ny - 1) / tile + 1, 0);
  std::vector<std::size_t> counts(tiles.size(), 0);
  const auto tileOf = [&](const SlabGroup& group) {
    return tiles.index(group.x / tile, group.y / tile);
  };
  for (const auto& group : groups) {
    tiles.values[tileOf(group)] = 1;
    ++counts[tileOf(group)];
  }
  forEachRegion(tiles, Neighbours::Eight, [&](const auto& part) {
    std::size_t count = 0;
    for (const std::size_t pixel : part)
      count += counts[pixel];
    if (static_cast<double>(count) < min_groups)
      for (const std::size_t pixel : part)
        tiles.values[pixel] = 0;
  });
  const auto is_small = [&](const auto& group) { return !tiles.values[tileOf(group)]; };
  groups.erase(std::remove_if(groups.begin(), groups.end(), is_small), groups.end());
}

void
setHeights(SlabLevel& level)
{
  std::vector<int> lows, highs;
  for (const auto& group : level.groups) {
    lows.push_back(group.low);
    highs.push_back(group.high);
  }
  level.low = median(lows);
  level.high = median(highs);
}

} // namespace

std::vector<SlabLevel>
findSlabLevels(const VoxelBits& occupancy,
               const StoreyOptions& options,
               int threads,
               const std::vector<double>& unseen)
{
  constexpr double level_difference = 1.0; // slabs at one level differ by less, metres
  const double size = occupancy.voxel_size;
  const int tile = voxelsIn(thickest_wall, size, 1);
  auto groups =
      levelGroups(SlabColumns(occupancy, options), size, threadCount(threads));
  const int reach_in_half_voxels = voxelsIn(level_difference, size);
  std::vector<SlabLevel> found;
  const double least = options.min_slab_area / (size * size);
  while (true) {
    SlabLevel level;
    level.groups =
        takeMostFrequent(groups, occupancy.shape.nz, reach_in_half_voxels, 0.5 * least);
    if (level.groups.empty())
      break;
    dropSmallParts(occupancy.shape, tile, least, level.groups);
    if (level.groups.empty())
      continue;
    setHeights(level);
    found.push_back(std::move(level));
  }
  for (const double middle : unseen)
    found.push_back({{}, middle, middle});
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.middle() < b.middle();
  });
  // Wings whose floors differ a little share their storeys.
  std::vector<SlabLevel> levels;
  for (auto& level : found) {
    if (levels.empty() ||
        (level.middle() - levels.back().middle()) * size > level_difference) {
      levels.push_back(std::move(level));
      continue;
    }
    auto& groups_below = levels.back().groups;
    groups_below.insert(groups_below.end(), level.groups.begin(), level.groups.end());
    if (!groups_below.empty())
      setHeights(levels.back());
  }
  return levels;
}

} // namespace pcl::indoor
