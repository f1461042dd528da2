/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/split/laden_top.h"

#include "objects/table_top.h"

#include <pcl/indoor/ground_frame.h>
#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace {

constexpr float bin_height = 0.01f;         // metres; a top reaches over two bins
constexpr float cell_size = 2 * bin_height; // along the ground
constexpr std::size_t fewest = 200;         // cells: 0.08 m^2, 0.4 x 0.2 m
constexpr float narrowest = 0.3f; // metres; less are ledges, arms and seats' fronts
constexpr float tallest =
    0.5f; // metres above the top; more has a cabinet or a bed's end
constexpr std::ptrdiff_t apart = 3; // bins, so that noise of a top is not beside it
constexpr double sharpness = 1.5; // times what is covered beside; leaves have no level
constexpr float strays = 0.02f;   // share of the points at each end

/** A bin of height above a cell of the ground that holds a point. */
struct FilledBin {
  std::int32_t x = 0, y = 0, bin = 0;

  bool
  operator<(const FilledBin& other) const
  {
    return std::tie(x, y, bin) < std::tie(other.x, other.y, other.bin);
  }

  bool
  operator==(const FilledBin& other) const
  {
    return x == other.x && y == other.y && bin == other.bin;
  }
};

std::int32_t
binOf(float height)
{
  return static_cast<std::int32_t>(std::floor(height / bin_height));
}

std::vector<FilledBin>
filledBins(const std::vector<Eigen::Vector3f>& places)
{
  const auto cell_of = [](float length) {
    return static_cast<std::int32_t>(std::floor(length / cell_size));
  };
  std::vector<FilledBin> filled;
  filled.reserve(places.size());
  for (const auto& place : places)
    filled.push_back({cell_of(place.x()), cell_of(place.y()), binOf(place.z())});
  std::sort(filled.begin(), filled.end());
  filled.erase(std::unique(filled.begin(), filled.end()), filled.end());
  return filled;
}

/** The lower of two bins that cover most cells together, the lowest if several do.
 * \return none if these are too few */
std::optional<std::int32_t>
widestLevel(const std::vector<FilledBin>& filled)
{
  const auto [lowest, highest] = std::minmax_element(
      filled.begin(), filled.end(), [](const FilledBin& a, const FilledBin& b) {
        return a.bin < b.bin;
      });
  const auto first = lowest->bin - 1;
  std::vector<std::size_t> cells(highest->bin - first + 1, 0);
  for (std::size_t i = 0; i < filled.size(); ++i) {
    const auto& here = filled[i];
    ++cells[here.bin - first];
    const bool has_lower = i > 0 && filled[i - 1].x == here.x &&
                           filled[i - 1].y == here.y &&
                           filled[i - 1].bin == here.bin - 1;
    if (!has_lower) // else the cell is counted with the lower bin already
      ++cells[here.bin - 1 - first];
  }
  const auto most = std::max_element(cells.begin(), cells.end()) - cells.begin();
  const auto covered = [&cells](std::ptrdiff_t i) {
    const bool is_there = i >= 0 && i < static_cast<std::ptrdiff_t>(cells.size());
    return static_cast<double>(is_there ? cells[i] : 0);
  };
  const double beside = std::max(covered(most - apart), covered(most + apart));
  if (cells[most] < fewest || covered(most) < sharpness * beside)
    return std::nullopt;
  return first + static_cast<std::int32_t>(most);
}

} // namespace

namespace pcl::indoor {

std::optional<TopLevel>
ladenTop(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& up)
{
  if (points.empty())
    return std::nullopt;
  const Eigen::Matrix3f frame = groundFrame(up).cast<float>();
  std::vector<Eigen::Vector3f> places;
  places.reserve(points.size());
  for (const auto& point : points)
    places.push_back(frame * point);
  const auto level = widestLevel(filledBins(places));
  if (!level)
    return std::nullopt;
  std::vector<float> x, y, above;
  const float lower = static_cast<float>(*level) * bin_height;
  const TopLevel top{lower, lower + 2 * bin_height};
  for (const auto& place : places) {
    const auto bin = binOf(place.z());
    if (bin > *level + 1)
      above.push_back(place.z() - top.upper);
    else if (bin >= *level) {
      x.push_back(place.x());
      y.push_back(place.y());
    }
  }
  const auto fits = [](std::vector<float>& along) {
    const float width = quantile(along, 1 - strays) - quantile(along, strays);
    return width >= narrowest && width <= widest_table;
  };
  if (!fits(x) || !fits(y) || above.empty() || quantile(above, 1 - strays) > tallest)
    return std::nullopt;
  return top;
}

} // namespace pcl::indoor
