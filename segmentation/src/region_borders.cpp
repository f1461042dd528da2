/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/disjoint_sets.h>
#include <pcl/segmentation/nearest_sites.h>
#include <pcl/segmentation/region_borders.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl {
namespace indoor {
namespace {

constexpr double passage_height = 1.6; // metres; lower openings let nobody pass

using RegionPair = std::pair<std::int32_t, std::int32_t>;

/** Looks across the border between two pixels. */
class BorderSection {
public:
  BorderSection(const VoxelGrid<std::uint8_t>& occupancy,
                const VerticalRange& storey,
                const PixelMap<int>& ceiling)
  : occupancy_(occupancy)
  , storey_(storey)
  , ceiling_(ceiling)
  , closed_(occupancy.shape.nz)
  {}

  /** Measure how many layers are open on the straight way between two pixels.
   * \return {layers from floor to ceiling, layers that are open} */
  std::pair<int, int>
  measure(int x0, int y0, int x1, int y1)
  {
    const int top = std::max(ceiling_.at(x0, y0), ceiling_.at(x1, y1));
    std::fill(closed_.begin(), closed_.end(), 0);
    const int steps = std::max({std::abs(x1 - x0), std::abs(y1 - y0), 1});
    for (int k = 0; k <= steps; ++k) {
      const int x = x0 + static_cast<int>(std::lround((x1 - x0) * k / double(steps)));
      const int y = y0 + static_cast<int>(std::lround((y1 - y0) * k / double(steps)));
      const std::uint8_t* column = &occupancy_.values[occupancy_.shape.index(x, y, 0)];
      for (int z = storey_.begin; z < top; ++z)
        closed_[z] |= column[z];
    }
    const int bottom = storey_.begin + 1; // above the floor
    if (top <= bottom)
      return {0, 0};
    const int open = static_cast<int>(
        std::count(closed_.begin() + bottom, closed_.begin() + top, 0));
    return {top - bottom, open};
  }

private:
  const VoxelGrid<std::uint8_t>& occupancy_;
  const VerticalRange& storey_;
  const PixelMap<int>& ceiling_;
  std::vector<std::uint8_t> closed_;
};

} // namespace

std::vector<RegionBorder>
regionBorders(const VoxelGrid<std::uint8_t>& occupancy,
              const VerticalRange& storey,
              const PixelMap<int>& ceiling,
              const PixelMap<std::int32_t>& labels,
              const PixelMap<std::int32_t>& free_labels)
{
  PixelMap<std::uint8_t> sites{labels.nx, labels.ny, {}};
  sites.values.resize(sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i)
    sites.values[i] = free_labels.values[i] != 0;
  const NearestSites nearest = nearestSites(sites);

  const double size = occupancy.voxel_size;
  BorderSection section(occupancy, storey, ceiling);
  std::map<RegionPair, RegionBorder> borders;
  const auto look = [&](std::size_t p, std::size_t q) {
    const std::int32_t a = labels.values[p], b = labels.values[q];
    if (a == b || a == 0 || b == 0)
      return;
    const std::int32_t from = nearest.site.values[p], to = nearest.site.values[q];
    if (from < 0 || to < 0)
      return; // nothing is free anywhere
    const int ny = labels.ny;
    const auto [height, open] = section.measure(from / ny, from % ny, to / ny, to % ny);
    RegionBorder& border = borders[std::minmax(a, b)];
    border.border_area += size * size * height;
    border.open_area += size * size * open;
    if (open * size >= passage_height) {
      border.opening_area += size * size * height;
      border.open_width += size;
      border.x += static_cast<double>(p / ny);
      border.y += static_cast<double>(p % ny);
    }
  };
  for (int x = 0; x < labels.nx; ++x)
    for (int y = 0; y < labels.ny; ++y) {
      if (x + 1 < labels.nx)
        look(labels.index(x, y), labels.index(x + 1, y));
      if (y + 1 < labels.ny)
        look(labels.index(x, y), labels.index(x, y + 1));
    }

  std::vector<RegionBorder> result;
  for (auto& [pair, border] : borders) {
    std::tie(border.a, border.b) = pair;
    if (border.open_width > 0) {
      border.x *= size / border.open_width;
      border.y *= size / border.open_width;
    }
    result.push_back(border);
  }
  return result;
}

std::vector<std::int32_t>
mergeOpenRegions(std::vector<RegionBorder> borders,
                 std::vector<double> section,
                 const MergeOptions& options)
{
  std::vector<std::int32_t> label(section.size());
  for (std::size_t i = 0; i < label.size(); ++i)
    label[i] = static_cast<std::int32_t>(i);
  while (true) {
    // The borders of joined regions add up, so shares are looked at anew after a join.
    const auto share = [&](const RegionBorder& border) {
      const bool below_lintel =
          border.open_area < options.open_height * border.opening_area;
      return below_lintel
                 ? 0.0
                 : border.open_area /
                       std::max(border.border_area,
                                std::min(section[border.a], section[border.b]));
    };
    const auto widest = std::max_element(
        borders.begin(), borders.end(), [&](const auto& first, const auto& second) {
          return share(first) < share(second);
        });
    if (widest == borders.end() || !(share(*widest) > options.open_share))
      return label;
    const std::int32_t kept = widest->a, gone = widest->b;
    section[kept] = std::max(section[kept], section[gone]);
    for (auto& each : label)
      if (each == gone)
        each = kept;
    std::map<RegionPair, RegionBorder> joined;
    for (RegionBorder border : borders) {
      const std::int32_t a = border.a == gone ? kept : border.a;
      const std::int32_t b = border.b == gone ? kept : border.b;
      if (a == b)
        continue;
      std::tie(border.a, border.b) = std::minmax(a, b);
      RegionBorder& sum = joined[{border.a, border.b}];
      const double width = sum.open_width + border.open_width;
      if (width > 0) {
        sum.x = (sum.x * sum.open_width + border.x * border.open_width) / width;
        sum.y = (sum.y * sum.open_width + border.y * border.open_width) / width;
      }
      sum.a = border.a;
      sum.b = border.b;
      sum.open_width = width;
      sum.border_area += border.border_area;
      sum.opening_area += border.opening_area;
      sum.open_area += border.open_area;
    }
    borders.clear();
    for (const auto& [pair, border] : joined)
      borders.push_back(border);
  }
}

} // namespace indoor
} // namespace pcl
