/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/map_clustering.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pcl::indoor {
namespace {

using Point = std::pair<std::int64_t, std::int64_t>;

/** The convex hull of points in ascending order (Andrew's monotone chain). */
std::vector<Point>
convexHull(const std::vector<Point>& points)
{
  std::vector<Point> hull;
  const auto extend = [&hull](const Point& p, std::size_t keep) {
    while (hull.size() > keep + 1) {
      const Point &a = hull[hull.size() - 2], &b = hull.back();
      if ((b.first - a.first) * (p.second - a.second) >
          (b.second - a.second) * (p.first - a.first))
        break;
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Point& p : points)
    extend(p, 0);
  const std::size_t lower = hull.empty() ? 0 : hull.size() - 1;
  for (std::size_t k = points.size(); k-- > 0;)
    extend(points[k], lower);
  return hull;
}

/** The largest distance between two points: it joins two corners of the hull, of which
 * a grid of N x N has O(N^(2/3)).
 */
double
diameter(const std::vector<int>& x, const std::vector<int>& y)
{
  std::vector<Point> points;
  for (std::size_t i = 0; i < x.size(); ++i)
    points.emplace_back(x[i], y[i]);
  const std::vector<Point> hull = convexHull(points);
  std::int64_t largest = 0;
  for (const Point& a : hull)
    for (const Point& b : hull) {
      const std::int64_t dx = a.first - b.first, dy = a.second - b.second;
      largest = std::max(largest, dx * dx + dy * dy);
    }
  return std::sqrt(static_cast<double>(largest));
}

} // namespace

MapDistance::MapDistance(int map_width,
                         int map_height,
                         const std::vector<std::size_t>& pixels,
                         FieldConnectivity connectivity,
                         VisibilityVectors visibility,
                         const thesis::MapDistanceOptions& options)
: map_width_(map_width)
, map_height_(map_height)
, pixels_(pixels)
, connectivity_(std::move(connectivity))
, visibility_(std::move(visibility))
, visibility_weight_(options.visibility_weight)
, field_weight_(options.field_weight)
{
  for (const double value : {options.visibility_weight,
                             options.euclidean_weight,
                             options.field_weight,
                             options.euclidean_scale})
    if (!(value >= 0.0) || !std::isfinite(value))
      PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                          "Bad weight or scale of the distance: " << value << ".");
  const std::size_t map_size = connectivity_.positions().size();
  if (static_cast<std::size_t>(map_width) * static_cast<std::size_t>(map_height) !=
      map_size)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The connectivity is that of another map.");
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (pixels[i] >= map_size || (i > 0 && pixels[i] <= pixels[i - 1]))
      PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                          "Pixel " << pixels[i] << " is out of the map or of order.");
  if (visibility_.count != 0 && visibility_.count != pixels.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        visibility_.count << " visibility vectors for " << pixels.size()
                                          << " pixels.");
  for (const std::size_t pixel : pixels) {
    x_.push_back(static_cast<int>(pixel / static_cast<std::size_t>(map_height)));
    y_.push_back(static_cast<int>(pixel % static_cast<std::size_t>(map_height)));
  }
  const double scale =
      options.euclidean_scale > 0.0 ? options.euclidean_scale : diameter(x_, y_);
  if (scale > 0.0)
    euclidean_factor_ = options.euclidean_weight / scale;
  if (connectivity_.maximum() > 0.0f)
    field_factor_ = 1.0 / connectivity_.maximum();
}

HDBSCANResult
clusterMap(const MapDistance& distance, const HDBSCANOptions& options)
{
  hdbscan_detail::requireValid(options);
  const auto core =
      mapCoreDistances(distance, hdbscan_detail::minSamples(options), options.threads);
  return hdbscanFromSpanningForest(
      distance.size(), mapSpanningTree(distance, core, options.threads), options);
}

std::vector<int>
dbscanMap(const MapDistance& distance, const DBSCANOptions& options)
{
  dbscan_detail::requireValid(options);
  if (distance.size() < options.min_samples)
    return std::vector<int>(distance.size(), -1);
  const auto core = mapCoreDistances(distance, options.min_samples, options.threads);
  return dbscanFromSpanningForest(
      distance.size(), mapSpanningTree(distance, core, options.threads), core, options);
}

} // namespace pcl::indoor
