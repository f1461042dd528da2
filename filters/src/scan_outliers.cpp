/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/filters/scan_outliers.h>

#include "internal/option_check.h"

#include <pcl/filters/radius_outlier_removal.h>
#include <pcl/indoor/distinct_points.h>
#include <pcl/indoor/neighbor_distance.h>
#include <pcl/indoor/require_valid.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

pcl::IndicesPtr
withNeighbors(const Cloud::ConstPtr& cloud, double radius, int min_neighbors)
{
  pcl::RadiusOutlierRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(cloud);
  removal.setRadiusSearch(radius);
  removal.setMinNeighborsInRadius(min_neighbors);
  const auto kept = pcl::make_shared<pcl::Indices>();
  removal.filter(*kept);
  return kept;
}

/** The indices that are kept, of those given: where the mean distance to neighbours is
 * not far above that of all, as pcl::StatisticalOutlierRemoval has it. */
pcl::IndicesPtr
withNearNeighbors(const std::vector<Eigen::Vector3f>& points,
                  const pcl::Indices& indices,
                  const pcl::indoor::ScanOutlierOptions& options)
{
  // On their own: else what was removed would still be a neighbour.
  std::vector<Eigen::Vector3f> rest;
  for (const auto i : indices)
    rest.push_back(points[i]);
  const auto distances = pcl::indoor::meanNeighborDistances(
      rest, static_cast<unsigned>(options.mean_k), options.threads);
  double sum = 0, squares = 0;
  for (const double distance : distances) {
    sum += distance;
    squares += distance * distance;
  }
  const auto count = static_cast<double>(distances.size());
  const double mean = sum / count;
  const double variance = std::max(0.0, (squares - sum * mean) / (count - 1));
  const double most = mean + std::max(options.deviations * std::sqrt(variance),
                                      (options.least_ratio - 1) * mean);
  const auto kept = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (distances[i] <= most)
      kept->push_back(indices[i]);
  return kept;
}

} // namespace

namespace pcl::indoor {

std::string
findProblem(const ScanOutlierOptions& options)
{
  OptionCheck check;
  check.require(options.radius >= 0 && std::isfinite(options.radius),
                "radius must not be negative",
                options.radius,
                " m");
  check.require(options.min_neighbors >= 0,
                "number of neighbours must not be negative",
                options.min_neighbors);
  check.require(options.mean_k >= 1,
                "number of neighbours that are looked at must be at least 1",
                options.mean_k);
  check.require(options.deviations > 0,
                "number of standard deviations must be positive",
                options.deviations);
  check.require(options.least_ratio >= 1 && std::isfinite(options.least_ratio),
                "ratio to the mean distance must be at least 1",
                options.least_ratio);
  return check.problem();
}

std::vector<std::uint8_t>
scanOutliers(const std::vector<Eigen::Vector3f>& points,
             const ScanOutlierOptions& options)
{
  requireValid(options);
  if (const auto places = placesOfCopies(points))
    return places->forAll(scanOutliers(places->once(points), options));
  std::vector<std::uint8_t> outliers(points.size(), 0);
  const auto cloud = pcl::make_shared<Cloud>();
  cloud->reserve(points.size());
  for (const auto& point : points)
    cloud->emplace_back(point.x(), point.y(), point.z());
  auto kept = pcl::make_shared<Indices>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    (*kept)[i] = static_cast<index_t>(i);
  const double radius =
      options.radius > 0 ? options.radius : neighborhoodRadius(points, options.threads);
  // Without two different places there is no radius, and nothing to compare.
  if (options.min_neighbors > 0 && radius > 0)
    kept = withNeighbors(cloud, radius, options.min_neighbors);
  if (std::isfinite(options.deviations) &&
      kept->size() > static_cast<std::size_t>(options.mean_k))
    kept = withNearNeighbors(points, *kept, options);
  outliers.assign(points.size(), 1);
  for (const auto i : *kept)
    outliers[i] = 0;
  return outliers;
}

} // namespace pcl::indoor
