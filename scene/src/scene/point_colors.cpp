/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/point_colors.h"

#include "pictures/color.h" // for labelColor, heatColor

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl::indoor::tool {
namespace {

/** PCL's packing: a float whose bytes are blue, green, red. */
float
packed(Color color)
{
  const std::uint32_t bits = static_cast<std::uint32_t>(color.red) << 16 |
                             static_cast<std::uint32_t>(color.green) << 8 |
                             static_cast<std::uint32_t>(color.blue);
  float value = 0.0f;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

std::vector<float>
colorsOfLabels(const std::vector<std::uint32_t>& labels, std::uint32_t other)
{
  constexpr std::uint32_t few = 4096; // labels whose colours are kept
  std::vector<float> palette, colors;
  for (std::uint32_t label = 0; label < few; ++label)
    palette.push_back(packed(labelColor(label == other ? 0 : label)));
  colors.reserve(labels.size());
  for (const auto label : labels)
    colors.push_back(label < few ? palette[label]
                                 : packed(labelColor(label == other ? 0 : label)));
  return colors;
}

/** From dark at the lowest of the points to light at the highest; single points far
 * above or below the others do not count. */
std::vector<float>
colorsOfHeights(const PointCloud<PointXYZ>& points,
                const PointCloud<PointXYZ>& all,
                const Eigen::Vector3f& up)
{
  constexpr double cut_off = 0.01; // share of the points, above and below
  constexpr double darkest = 0.15; // seen before a black background
  std::vector<double> sorted;
  for (const auto& point : all) {
    const auto height = static_cast<double>(up.dot(point.getVector3fMap()));
    if (std::isfinite(height))
      sorted.push_back(height);
  }
  std::sort(sorted.begin(), sorted.end());
  const auto cut =
      static_cast<std::size_t>(cut_off * static_cast<double>(sorted.size()));
  const double lowest = sorted[cut], highest = sorted[sorted.size() - 1 - cut];
  std::vector<float> colors;
  colors.reserve(points.size());
  for (const auto& point : points) {
    const auto height = static_cast<double>(up.dot(point.getVector3fMap()));
    const double share = (height - lowest) / std::max(highest - lowest, 1e-9);
    colors.push_back(
        packed(heatColor(darkest + (1.0 - darkest) * std::clamp(share, 0.0, 1.0))));
  }
  return colors;
}

} // namespace

void
PointColors::apply(CloudFile& file,
                   const std::string& automatic,
                   const Eigen::Vector3f& up,
                   std::uint32_t other,
                   const PointCloud<PointXYZ>* whole) const
{
  const bool has_colors = hasField(file.cloud, "rgb") || hasField(file.cloud, "rgba");
  if (wanted == "none" || (wanted == "auto" && has_colors))
    return;
  const auto& shown = wanted == "auto" ? automatic : wanted;
  const auto colors =
      shown == "height"
          ? colorsOfHeights(*file.points, whole ? *whole : *file.points, up)
          : colorsOfLabels(readLabels(file, shown == "class" ? "category" : shown),
                           other);
  removeField(file.cloud, "rgba");
  appendRealField(file.cloud, "rgb", colors);
}

} // namespace pcl::indoor::tool
