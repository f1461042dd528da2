/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/storeys/storeys.h"

#include "rooms/dimensions.h"
#include "rooms/storeys/slab_levels.h"
#include "rooms/storeys/storey_openings.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::indoor {

namespace {

constexpr double height_bin = 0.01; // metres

/** \brief Sums over all rectangles that begin at (0, 0), for sums over any. */
class RectangleSums {
public:
  explicit RectangleSums(const PixelMap<float>& map)
  : nx_(map.nx)
  , ny_(map.ny)
  , sums_((map.nx + 1ul) * (map.ny + 1ul), 0.0)
  {
    for (int x = 0; x < nx_; ++x)
      for (int y = 0; y < ny_; ++y)
        at(x + 1, y + 1) = map.at(x, y) + at(x, y + 1) + at(x + 1, y) - at(x, y);
  }

  /** \brief The sum over a square of pixels around one, as far as it is in the map. */
  double
  around(int x, int y, int radius)
  {
    const int left = std::max(0, x - radius);
    const int right = std::min(nx_, x + radius + 1);
    const int low = std::max(0, y - radius);
    const int high = std::min(ny_, y + radius + 1);
    return at(right, high) - at(left, high) - at(right, low) + at(left, low);
  }

private:
  double&
  at(int x, int y)
  {
    return sums_[static_cast<std::size_t>(x) * (ny_ + 1) + y];
  }

  int nx_;
  int ny_;
  std::vector<double> sums_;
};

void
requireValid(const VoxelBits& occupancy, const StoreyOptions& options)
{
  if (!occupancy.empty() && !(occupancy.voxel_size > 0.0))
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "The voxel size must be positive, not " << occupancy.voxel_size
                                                                << " m.");
  const bool valid = options.min_clearance > 0.0 && options.max_slab >= 0.0 &&
                     options.min_slab_area > 0.0 && options.bridge >= 0.0 &&
                     options.min_opening_area >= 0.0;
  if (!valid)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "A length or area of the storeys is out of range.");
}

/** \brief The border at a level: halfway between the ceiling below and the floor above
 * as they are nearby.
 */
PixelMap<float>
borderOf(const VoxelBits& occupancy,
         const SlabLevel& level,
         const StoreyOptions& options)
{
  const GridShape& shape = occupancy.shape;
  const double size = occupancy.voxel_size;
  if (level.groups.empty()) { // nobody saw whether it is open anywhere
    const double middle = occupancy.origin.z() + (level.middle() + 0.5) * size;
    return PixelMap<float>::filled(shape.nx, shape.ny, static_cast<float>(middle));
  }
  auto votes = PixelMap<float>::filled(shape.nx, shape.ny, 0.0f);
  PixelMap<float> thin = votes;
  PixelMap<float> middles = votes;
  for (const auto& group : level.groups) {
    votes.at(group.x, group.y) = 1.0f;
    if (group.high - group.low > level.high - level.low + 1.0)
      continue; // with furniture or lamps
    thin.at(group.x, group.y) = 1.0f;
    middles.at(group.x, group.y) = static_cast<float>(group.middle());
  }
  const auto open = openColumns(
      occupancy, votes, static_cast<int>(std::lround(level.middle())), options);
  RectangleSums counts(thin);
  RectangleSums sums(middles);
  const int radius = voxelsIn(surroundings, size);
  PixelMap<float> border = votes;
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y) {
      const double count = counts.around(x, y, radius);
      const double middle =
          count > 0.5 ? sums.around(x, y, radius) / count : level.middle();
      border.at(x, y) =
          open.at(x, y)
              ? std::numeric_limits<float>::infinity()
              : static_cast<float>(occupancy.origin.z() + (middle + 0.5) * size);
    }
  return border;
}

/** \brief The most frequent lowest and highest occupied voxel of the columns that are
 * at least so high. */
std::pair<int, int>
outerLevelsOf(const VoxelBits& occupancy, int least_height)
{
  const int nz = occupancy.shape.nz;
  std::vector<int> lowest(nz + 1, 0);
  std::vector<int> highest(nz + 1, 0);
  for (std::size_t pixel = 0; pixel < occupancy.columns(); ++pixel) {
    const auto column = occupancy.column(pixel);
    const int low = column.lowest(0, nz), high = column.highest(0, nz);
    if (low == nz)
      continue;
    if (high - low < least_height)
      continue;
    ++lowest[low];
    ++highest[high];
  }
  const auto mode = [](const std::vector<int>& counts) {
    return static_cast<int>(std::max_element(counts.begin(), counts.end()) -
                            counts.begin());
  };
  return {mode(lowest), mode(highest)};
}

/** \brief Floor and ceiling of all storeys together, in layers. Where most of the floor
 * was not seen, the lowest voxel of most columns is the ceiling: then those tell it
 * that have both, or a wall. */
std::pair<int, int>
outerLevels(const VoxelBits& occupancy, double min_clearance)
{
  const int clearance = voxelsIn(min_clearance, occupancy.voxel_size);
  const auto levels = outerLevelsOf(occupancy, 0);
  if (levels.second - levels.first >= clearance)
    return levels;
  const auto of_high = outerLevelsOf(occupancy, clearance);
  return of_high.second > of_high.first ? of_high : levels; // if there are any
}

/** \brief The middle of the emptiest stretch between the two surfaces of a slab, in
 * bins; counts.size() / 2 if there is one surface only.
 */
double
valley(const std::vector<int>& counts)
{
  // peaks that are closer are one surface
  constexpr int apart = static_cast<int>(crowd / height_bin + 0.5);
  const int size = static_cast<int>(counts.size());
  const int peak =
      static_cast<int>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  // The other surface rises most above the lowest count on the way to it.
  int other = peak;
  int rise = counts[peak] / 10;
  for (const int step : {-1, 1}) {
    int lowest = counts[peak];
    for (int i = peak; i >= 0 && i < size; i += step) {
      lowest = std::min(lowest, counts[i]);
      if (std::abs(i - peak) >= apart && counts[i] - lowest > rise) {
        rise = counts[i] - lowest;
        other = i;
      }
    }
  }
  if (other == peak)
    return 0.5 * size;
  const int begin = std::min(peak, other);
  const int end = std::max(peak, other);
  const int least = *std::min_element(counts.begin() + begin, counts.begin() + end);
  int first = begin;
  while (counts[first] > least + rise / 20)
    ++first;
  int last = end;
  while (counts[last] > least + rise / 20)
    --last;
  return 0.5 * (first + last + 1);
}

} // namespace

int
Storeys::storeyAt(int x, int y, double z) const
{
  for (std::size_t k = borders.size(); k > 0; --k)
    if (z > borders[k - 1].at(x, y))
      return static_cast<int>(k);
  return 0;
}

Storeys
findStoreys(const VoxelBits& occupancy,
            const StoreyOptions& options,
            int threads,
            const std::vector<double>& unseen)
{
  requireValid(occupancy, options);
  Storeys result;
  if (occupancy.empty()) {
    result.heights.emplace_back();
    return result;
  }
  const auto levels = findSlabLevels(occupancy, options, threads, unseen);
  const auto heightOf = [&](double voxel) {
    return occupancy.origin.z() + (voxel + 0.5) * occupancy.voxel_size;
  };
  const auto [lowest, highest] = outerLevels(occupancy, options.min_clearance);
  Storey storey;
  storey.floor = heightOf(lowest);
  for (const SlabLevel& level : levels) {
    storey.ceiling = heightOf(level.low);
    result.heights.push_back(storey);
    storey.floor = heightOf(level.high);
    result.borders.push_back(borderOf(occupancy, level, options));
  }
  storey.ceiling = heightOf(highest);
  result.heights.push_back(storey);
  return result;
}

void
refineBorders(const std::vector<Eigen::Vector3f>& points,
              const OccupancyGrid& grid,
              Storeys& storeys)
{
  if (points.size() != grid.cells.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "The grid was made of " << grid.cells.size()
                                                << " points, not of " << points.size()
                                                << ".");
  const GridShape& shape = grid.grid.shape;
  // A voxel's surface may lie on either side of its middle.
  const auto half = std::max(
      1, static_cast<int>(std::lround(2.0 * grid.grid.voxel_size / height_bin)));
  for (auto& border : storeys.borders) {
    std::vector<int> counts(2 * half, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (grid.cells[i] < 0)
        continue;
      const double from = border.values[grid.cells[i] / shape.nz];
      const double height = (points[i].z() - from) / height_bin;
      if (height >= -half && height < half) // not where the border is infinite
        ++counts[static_cast<int>(std::floor(height)) + half];
    }
    const auto shift = static_cast<float>((valley(counts) - half) * height_bin);
    for (float& value : border.values)
      value += shift;
  }
}

} // namespace pcl::indoor
