/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/filters/scan_outliers.h>

#include <pcl/filters/radius_outlier_removal.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/indoor/neighbor_distance.h>
#include <pcl/indoor/require_valid.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <sstream>

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

/** How many standard deviations the given multiple of the mean lies above it. */
double
deviationsOf(double ratio, const std::vector<float>& values)
{
  double sum = 0, squares = 0;
  for (const auto value : values) {
    sum += value;
    squares += static_cast<double>(value) * value;
  }
  const auto count = static_cast<double>(values.size());
  const double variance = (squares - sum * sum / count) / (count - 1);
  const double most = 1e6; // of values that are all equal
  return variance > 0 ? std::min(most, (ratio - 1) * sum / count / std::sqrt(variance))
                      : most;
}

/** The indices that are kept, of those given. */
pcl::IndicesPtr
withNearNeighbors(const Cloud::ConstPtr& cloud,
                  const pcl::Indices& indices,
                  const pcl::indoor::ScanOutlierOptions& options)
{
  // On a cloud of their own: else what was removed would still be a neighbour.
  const auto rest = pcl::make_shared<Cloud>(*cloud, indices);
  const auto distances =
      pcl::indoor::meanNeighborDistances(pcl::indoor::finitePoints(*rest),
                                         static_cast<unsigned>(options.mean_k),
                                         options.threads);
  pcl::StatisticalOutlierRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(rest);
  removal.setMeanK(options.mean_k);
  removal.setStddevMulThresh(
      std::max(options.deviations, deviationsOf(options.least_ratio, distances)));
  pcl::Indices kept;
  removal.filter(kept);
  const auto result = pcl::make_shared<pcl::Indices>();
  for (const auto i : kept)
    result->push_back(indices[i]);
  return result;
}

} // namespace

namespace pcl {
namespace indoor {

std::string
findProblem(const ScanOutlierOptions& options)
{
  std::ostringstream problem;
  if (!(options.radius >= 0) || !std::isfinite(options.radius))
    problem << "The radius must not be negative, not " << options.radius << " m.";
  else if (options.min_neighbors < 0)
    problem << "The number of neighbours must not be negative, not "
            << options.min_neighbors << ".";
  else if (options.mean_k < 1)
    problem << "At least one neighbour must be looked at, not " << options.mean_k
            << ".";
  else if (!(options.deviations > 0))
    problem << "The number of standard deviations must be positive, not "
            << options.deviations << ".";
  else if (!(options.least_ratio >= 1) || !std::isfinite(options.least_ratio))
    problem << "The ratio to the mean distance must be at least 1, not "
            << options.least_ratio << ".";
  return problem.str();
}

std::vector<std::uint8_t>
scanOutliers(const std::vector<Eigen::Vector3f>& points,
             const ScanOutlierOptions& options)
{
  requireValid(options);
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
    kept = withNearNeighbors(cloud, *kept, options);
  outliers.assign(points.size(), 1);
  for (const auto i : *kept)
    outliers[i] = 0;
  return outliers;
}

} // namespace indoor
} // namespace pcl
