/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/persistent_basins.h"

#include "rooms/space/map_regions.h"

#include <algorithm>
#include <vector>

namespace pcl::indoor {
namespace {

/** Pixels with a positive value, the highest first, equal ones in the map's order. */
std::vector<std::int32_t>
descending(const std::vector<float>& values)
{
  std::vector<std::int32_t> order;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] > 0)
      order.push_back(static_cast<std::int32_t>(i));
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return values[a] > values[b];
  });
  return order;
}

/** The basins while the map is flooded, in the order of their maxima: a basin with a
 * smaller number has the higher maximum and takes in the others. */
class Basins {
public:
  Basins(const PixelMap<float>& field, const BasinOptions& options)
  : field_(field)
  , persistence_(static_cast<float>(options.persistence))
  , door_(static_cast<float>(options.door))
  , door_persistence_(static_cast<float>(options.door_persistence))
  , basin_of_(field.size(), -1)
  {}

  /** Add the next lower pixel: it opens a basin, or joins its highest neighbour and
   * lets that one take in the others behind a wide pass. */
  void
  add(std::int32_t pixel)
  {
    findNeighbours(pixel);
    const float level = field_.values[pixel];
    if (neighbours_.empty()) {
      basin_of_[pixel] = static_cast<std::int32_t>(peak_.size());
      parent_.push_back(basin_of_[pixel]);
      peak_.push_back(level);
      return;
    }
    basin_of_[pixel] = steepest_;
    for (const std::int32_t other : neighbours_)
      if (!isNarrow(level, peak_[other]))
        parent_[other] = neighbours_.front();
  }

  /** How many there were, also those that others have taken in. */
  std::size_t
  count() const
  {
    return peak_.size();
  }

  std::int32_t
  basinOf(std::size_t pixel)
  {
    return basin_of_[pixel] < 0 ? -1 : find(basin_of_[pixel]);
  }

private:
  bool
  isNarrow(float pass, float peak) const
  {
    return pass < persistence_ * peak ||
           (pass <= door_ && pass < door_persistence_ * peak);
  }

  std::int32_t
  find(std::int32_t basin)
  {
    while (parent_[basin] != basin)
      basin = parent_[basin] = parent_[parent_[basin]];
    return basin;
  }

  void
  findNeighbours(std::int32_t pixel)
  {
    neighbours_.clear();
    float highest = 0.0f;
    forEachNeighbour(field_, pixel, Neighbours::Eight, [&](std::size_t other) {
      const std::int32_t basin = basinOf(other);
      if (basin < 0)
        return;
      neighbours_.push_back(basin);
      const float value = field_.values[other];
      if (value > highest || (value == highest && basin < steepest_)) {
        highest = value;
        steepest_ = basin;
      }
    });
    std::sort(neighbours_.begin(), neighbours_.end());
    neighbours_.erase(std::unique(neighbours_.begin(), neighbours_.end()),
                      neighbours_.end());
  }

  const PixelMap<float>& field_;
  float persistence_, door_, door_persistence_;
  std::vector<std::int32_t> basin_of_; // per pixel, -1 = not flooded yet
  std::vector<std::int32_t> parent_;   // per basin
  std::vector<float> peak_;            // per basin
  std::vector<std::int32_t> neighbours_;
  std::int32_t steepest_ = -1; // the basin of the highest neighbour
};

} // namespace

PixelMap<std::int32_t>
persistentBasins(const PixelMap<float>& field, const BasinOptions& options)
{
  Basins basins(field, options);
  for (const std::int32_t pixel : descending(field.values))
    basins.add(pixel);

  auto labels = PixelMap<std::int32_t>::filled(field.nx, field.ny, 0);
  std::vector<std::int32_t> number(basins.count(), 0);
  std::int32_t count = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const std::int32_t basin = basins.basinOf(i);
    if (basin < 0)
      continue;
    if (number[basin] == 0)
      number[basin] = ++count;
    labels.values[i] = number[basin];
  }
  return labels;
}

} // namespace pcl::indoor
