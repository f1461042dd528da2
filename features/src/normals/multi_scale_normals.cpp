/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/multi_scale_normals.h>

#include "internal/option_check.h"

#include <pcl/indoor/first_in_place.h>
#include <pcl/indoor/neighbor_distance.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/require_valid.h>
#include <pcl/indoor/usable_point.h>
#include <pcl/search/kdtree.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace pcl::indoor {
namespace {

/** The plane of least squares of the points that were added. */
class PlaneSum {
public:
  void
  add(const Eigen::Vector3d& point)
  {
    ++count_;
    sum_ += point;
    products_.selfadjointView<Eigen::Lower>().rankUpdate(point);
  }

  /** Normal and curvature; NaN without a plane. */
  Normal
  plane() const
  {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Normal result(nan, nan, nan, nan);
    if (count_ < 3)
      return result;
    Eigen::Matrix3d covariance = products_ / count_;
    const Eigen::Vector3d mean = sum_ / count_;
    covariance.selfadjointView<Eigen::Lower>().rankUpdate(mean, -1.0);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0.0);
    if (!(values[1] > least_spread * values[2]))
      return result; // a line or one place
    result.getNormalVector3fMap() = solver.eigenvectors().col(0).cast<float>();
    result.curvature = static_cast<float>(values[0] / values.sum());
    return result;
  }

private:
  static constexpr double least_spread = 1e-10; ///< across a line, over that along it

  double count_ = 0;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products_ = Eigen::Matrix3d::Zero();
};

/** Squares of the radii, ascending: from half of the largest to it, each by the same
 * factor. */
std::vector<double>
squaredRadii(double largest, unsigned scales)
{
  std::vector<double> squares;
  for (unsigned k = scales; k-- > 0;) {
    const double share = scales > 1 ? k / (scales - 1.0) : 0.0;
    const double radius = largest * std::pow(0.5, share);
    squares.push_back(radius * radius);
  }
  return squares;
}

} // namespace

std::string
findProblem(const MultiScaleNormalOptions& options)
{
  OptionCheck check;
  check.require(options.radius >= 0.0 && std::isfinite(options.radius),
                "radius must be 0 (automatic) or a positive length",
                options.radius,
                " m");
  check.require(options.scales >= 1 && options.scales <= 16,
                "number of scales must be in 1 ... 16",
                options.scales);
  return check.problem();
}

PointCloud<Normal>
multiScaleNormals(const PointCloud<PointXYZ>& points,
                  const MultiScaleNormalOptions& options)
{
  requireValid(options);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  PointCloud<Normal> normals(points.width, points.height, Normal(nan, nan, nan, nan));
  const auto usable = pcl::make_shared<Indices>();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (isUsablePoint(points[i]))
      usable->push_back(static_cast<index_t>(i));
  const double radius = options.radius > 0.0
                            ? options.radius
                            : 2.0 * neighborhoodRadius(points, options.threads);
  if (usable->empty() || !(radius > 0.0))
    return normals;
  const auto squares = squaredRadii(radius, options.scales);
  search::KdTree<PointXYZ> tree; // neighbours by their distance
  tree.setInputCloud(points.makeShared(), usable);

  struct State {
    Indices neighbors;
    std::vector<float> squared_distances;
  };
  const auto first = firstInPlace(points, *usable);
  const auto count = static_cast<std::ptrdiff_t>(usable->size());
  parallelFor(
      count,
      static_cast<int>(options.threads),
      256,
      [] { return State(); },
      [&](State& state, std::ptrdiff_t i) {
        if (first[i] != i)
          return;
        auto& [neighbors, squared_distances] = state;
        const auto& point = points[(*usable)[i]];
        tree.radiusSearch(point, radius, neighbors, squared_distances);
        const Eigen::Vector3d origin = point.getVector3fMap().cast<double>();
        auto& best = normals[(*usable)[i]];
        PlaneSum sum;
        std::size_t next = 0;
        for (const double square : squares) {
          for (; next < neighbors.size() && squared_distances[next] <= square; ++next)
            sum.add(points[neighbors[next]].getVector3fMap().cast<double>() - origin);
          const auto plane = sum.plane();
          if (!(plane.curvature > best.curvature) && std::isfinite(plane.curvature))
            best = plane; // of equal ones the largest
        }
      });
  for (std::ptrdiff_t i = 0; i < count; ++i)
    normals[(*usable)[i]] = normals[(*usable)[first[i]]];
  return normals;
}

} // namespace pcl::indoor
