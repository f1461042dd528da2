/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "features/harmonics_oracle.h"
#include "features/noise_oracle.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl::indoor {

inline int
binOf(double place, int count)
{
  return std::clamp(static_cast<int>(std::floor(place * count)), 0, count - 1);
}

inline double
combined(double one, double two, SurfaceAngleRule rule)
{
  switch (rule) {
  case SurfaceAngleRule::Maximum:
    return std::max(one, two);
  case SurfaceAngleRule::Minimum:
    return std::min(one, two);
  case SurfaceAngleRule::Mean:
    return (one + two) / 2;
  default:
    return one;
  }
}

/** \brief L of the L (L + 1) / 2 bins of two angles whose order does not count. */
inline int
levelCount(const EPPFBins& bins)
{
  return static_cast<int>(std::lround(std::sqrt(2 * bins.surface_angle + 0.25) - 0.5));
}

/** \brief The voxels per edge of the grid, and 64 at most, of 4 L^2 points. */
inline int
gridSize(const EPPFOptions& options, std::size_t point_count)
{
  if (options.grid_size > 0)
    return options.grid_size;
  const double edge = std::sqrt(static_cast<double>(point_count)) / 2;
  return static_cast<int>(std::round(std::min(std::max(edge, 8.0), 64.0)));
}

/** \brief The bin of f2 from both surface angles. */
inline int
surfaceBin(double beta1, double beta2, const EPPFOptions& options)
{
  const double lowest = options.normal_sides == NormalSides::Ignored ? 0.0 : -1.0;
  if (options.surface_angle_rule != SurfaceAngleRule::Joint) {
    const double beta = combined(beta1, beta2, options.surface_angle_rule);
    return binOf((beta - lowest * pi / 2) / (pi / 2 - lowest * pi / 2),
                 options.bins.surface_angle);
  }
  const int levels = levelCount(options.bins);
  const int one = binOf((std::sin(beta1) - lowest) / (1.0 - lowest), levels);
  const int two = binOf((std::sin(beta2) - lowest) / (1.0 - lowest), levels);
  int bin = 0; // counted out: (0, 0), (1, 0), (1, 1), (2, 0) ...
  for (int high = 0; high <= std::max(one, two); ++high)
    for (int low = 0; low <= high; ++low, ++bin)
      if (high == std::max(one, two) && low == std::min(one, two))
        return bin;
  return -1;
}

/** \brief The points with normals away from their centroid. */
inline std::vector<OrientedPoint>
outward(std::vector<OrientedPoint> points)
{
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (const auto& point : points)
    centroid += point.position.cast<double>() / static_cast<double>(points.size());
  for (auto& point : points)
    if (point.normal.cast<double>().dot(point.position.cast<double>() - centroid) < 0.0)
      point.normal = -point.normal;
  return points;
}

/** \brief The points with normals on the sides that the options want. */
inline std::vector<OrientedPoint>
onSides(const std::vector<OrientedPoint>& given, NormalSides sides)
{
  const auto turned = outward(given);
  if (sides == NormalSides::Outward)
    return turned;
  auto points = given;
  std::size_t inward_count = 0;
  for (std::size_t k = 0; k < points.size(); ++k)
    inward_count += turned[k].normal == points[k].normal ? 0 : 1;
  if (sides == NormalSides::MostlyOutward && 2 * inward_count > points.size())
    for (auto& point : points)
      point.normal = -point.normal;
  return points;
}

/** \brief The sum of pairs brought to 1, or to 1 / 2 beside harmonics. */
inline std::vector<double>
withHarmonics(std::vector<double> pairs,
              const std::vector<OrientedPoint>& surface,
              double evidence,
              double scale,
              const EPPFOptions& options)
{
  const bool has_harmonics =
      options.features.harmonics && options.bins.harmonics.size() > 0;
  const double sum = std::accumulate(pairs.begin(), pairs.end(), 0.0);
  for (auto& value : pairs)
    value *= (has_harmonics ? 0.5 : 1.0) / sum;
  pairs.resize(options.bins.size());
  if (!has_harmonics)
    return pairs;
  const auto harmonics =
      slowHarmonics(surface, 0.5 * (1.0 - evidence), scale, options.bins.harmonics);
  for (std::size_t bin = 0; bin < harmonics.size(); ++bin)
    pairs[options.bins.pairSize() + bin] = harmonics[bin] / 2.0;
  return pairs;
}

/** \brief The cosine of the turn from one normal to another about a line. */
inline double
turnCosine(const Eigen::Vector3d& one,
           const Eigen::Vector3d& two,
           const Eigen::Vector3d& line)
{
  const Eigen::Vector3d a = one - one.dot(line) * line;
  const Eigen::Vector3d b = two - two.dot(line) * line;
  const double lengths = a.norm() * b.norm();
  return lengths > 1e-3 ? a.dot(b) / lengths : 1.0;
}

/** \brief Eq. (5.8) on a grid of flags: at each step of the line's longest axis, the
 * voxel nearest to the line, of two equally near ones the lower. */
class DenseOccupancy {
public:
  DenseOccupancy(const std::vector<OrientedPoint>& points, int size)
  : size_(size)
  , occupied_(static_cast<std::size_t>(size) * size * size)
  {
    Eigen::Array3f lower = points.front().position, upper = lower;
    for (const auto& point : points) {
      lower = lower.min(point.position.array());
      upper = upper.max(point.position.array());
    }
    edge_ = (upper - lower).maxCoeff(); // the cube is around the middle of the box
    corner_ = (lower + upper - edge_) / 2;
    for (const auto& point : points)
      occupied_[index(voxel(point.position))] = true;
  }

  double
  ratio(const Eigen::Vector3f& one, const Eigen::Vector3f& two) const
  {
    const Eigen::Array3i from = voxel(one), step = voxel(two) - from;
    const int steps = step.abs().maxCoeff();
    int count = 0;
    for (int k = 0; k <= steps; ++k) {
      Eigen::Array3i place = from;
      for (int axis = 0; axis < 3 && steps > 0; ++axis) // round(k * step / steps)
        place[axis] +=
            static_cast<int>(std::ceil((2.0 * k * step[axis] - steps) / (2.0 * steps)));
      count += occupied_[index(place)];
    }
    return static_cast<double>(count) / (steps + 1);
  }

private:
  Eigen::Array3i
  voxel(const Eigen::Vector3f& position) const
  {
    const float per_metre = edge_ > 0 ? static_cast<float>(size_) / edge_ : 0.0f;
    Eigen::Array3i voxel;
    for (int axis = 0; axis < 3; ++axis)
      voxel[axis] = std::clamp(
          static_cast<int>(std::floor((position[axis] - corner_[axis]) * per_metre)),
          0,
          size_ - 1);
    return voxel;
  }

  std::size_t
  index(const Eigen::Array3i& voxel) const
  {
    return (static_cast<std::size_t>(voxel.x()) * size_ + voxel.y()) * size_ +
           voxel.z();
  }

  int size_;
  float edge_;
  Eigen::Array3f corner_;
  std::vector<bool> occupied_;
};

/** \brief Every pair of two different points, in both orders. */
inline std::vector<std::pair<std::size_t, std::size_t>>
allPairs(std::size_t count)
{
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t first = 0; first < count; ++first)
    for (std::size_t second = 0; second < count; ++second)
      if (first != second)
        pairs.emplace_back(first, second);
  return pairs;
}

/** \brief The thesis's formulas of every pair of two different points, with real angles
 * and no shortcut: what the histogram of drawn pairs tends to. */
inline std::vector<double>
slowHistogram(const std::vector<OrientedPoint>& given, const EPPFOptions& options)
{
  const auto points = onSides(given, options.normal_sides);
  const auto& bins = options.bins;
  const DenseOccupancy grid(points, gridSize(options, points.size()));
  const double scale = options.scale > 0.0 ? options.scale : slowExtent(points);
  std::vector<double> histogram(bins.pairSize());
  for (const auto& [first, second] : allPairs(points.size())) {
    const Eigen::Vector3d one = points[first].position.cast<double>();
    const Eigen::Vector3d two = points[second].position.cast<double>();
    const Eigen::Vector3d d = (two - one).normalized();
    const Eigen::Vector3d n1 = points[first].normal.cast<double>();
    const Eigen::Vector3d n2 = points[second].normal.cast<double>();
    const auto sides = options.normal_sides;
    const bool has_sides = sides != NormalSides::Ignored;
    const bool are_known = has_sides && sides != NormalSides::Given;
    double cosine = n1.dot(n2);
    if (options.normal_angle_rule == NormalAngleRule::AroundLine)
      cosine = turnCosine(n1, n2, d);
    double beta1 = std::acos(std::clamp(n1.dot(d), -1.0, 1.0)) - pi / 2;
    double beta2 = std::acos(std::clamp(n2.dot(d), -1.0, 1.0)) - pi / 2;
    if (are_known)
      beta2 = -beta2; // towards the first point
    const double lowest = has_sides ? -pi / 2 : 0.0;
    if (!has_sides) {
      beta1 = std::abs(beta1);
      beta2 = std::abs(beta2);
    }
    const auto angle_place = [&](double beta) {
      return (beta - lowest) / (pi / 2 - lowest);
    };
    if (!are_known)
      cosine = std::abs(cosine);
    const double f3 =
        std::acos(std::clamp(cosine, -1.0, 1.0)) / (are_known ? pi : pi / 2);
    const bool both =
        options.surface_angle_rule == SurfaceAngleRule::BothInsteadOfOccupancy;
    const auto& on = options.features;
    const int i1 = on.distance ? binOf((two - one).norm() / scale, bins.distance) : 0;
    const int i2 = on.surface_angle ? surfaceBin(beta1, beta2, options) : 0;
    const int i3 = on.normal_angle ? binOf(f3, bins.normal_angle) : 0;
    const double f4 =
        grid.ratio(points[first].position, points[second].position) + 1e-9;
    const int i4 =
        on.occupancy ? binOf(both ? angle_place(beta2) : f4, bins.occupancy) : 0;
    const double weight = options.weighting
                              ? std::log(static_cast<double>(i1) / bins.distance +
                                         options.weighting_constant)
                              : 1.0;
    histogram[((i1 * bins.surface_angle + i2) * bins.normal_angle + i3) *
                  bins.occupancy +
              i4] += weight;
  }
  return withHarmonics(std::move(histogram), given, 0.0, scale, options);
}

/** \brief The same of an object with noise: sides known, automatic grid; every pair
 * offered to every bin of the soft features. */
inline std::vector<double>
slowNoisyHistogram(const std::vector<OrientedPoint>& given, const EPPFOptions& options)
{
  const auto noise = slowNoise(given);
  const auto object = slowDenoised(given, noise);
  const auto points = onSides(object.points, options.normal_sides);
  const auto& bins = options.bins;
  const DenseOccupancy grid(points, gridSize(options, points.size()));
  const double scale = options.scale > 0.0 ? options.scale : object.extent;
  const bool joint = options.surface_angle_rule == SurfaceAngleRule::Joint;
  const int levels = joint ? levelCount(bins) : 1;
  std::vector<double> histogram(bins.pairSize());
  for (const auto& [first, second] : allPairs(points.size())) {
    const auto& one = points[first];
    const auto& two = points[second];
    const Eigen::Vector3d line =
        two.position.cast<double>() - one.position.cast<double>();
    const double sine1 = -one.normal.cast<double>().dot(line.normalized());
    const double sine2 = two.normal.cast<double>().dot(line.normalized());
    const Eigen::Vector3d n1 = one.normal.cast<double>();
    const Eigen::Vector3d n2 = two.normal.cast<double>();
    const double cosine = options.normal_angle_rule == NormalAngleRule::AroundLine
                              ? turnCosine(n1, n2, line.normalized())
                              : n1.dot(n2);
    const int i3 =
        binOf(std::acos(std::clamp(cosine, -1.0, 1.0)) / pi, bins.normal_angle);
    const int i4 = binOf(grid.ratio(one.position, two.position) + 1e-9, bins.occupancy);
    const int hard2 = joint ? 0
                            : surfaceBin(std::asin(std::clamp(sine1, -1.0, 1.0)),
                                         std::asin(std::clamp(sine2, -1.0, 1.0)),
                                         options);
    for (int i1 = 0; i1 < bins.distance; ++i1)
      for (int a = 0; a < levels; ++a)
        for (int b = 0; b < levels; ++b) {
          const double share =
              softShare(line.norm() / scale * bins.distance,
                        i1,
                        bins.distance,
                        noise.evidence) *
              softShare((sine1 + 1) / 2 * levels, a, levels, noise.evidence) *
              softShare((sine2 + 1) / 2 * levels, b, levels, noise.evidence);
          const int i2 =
              joint ? std::max(a, b) * (std::max(a, b) + 1) / 2 + std::min(a, b)
                    : hard2;
          const double weight =
              (options.weighting ? std::log(static_cast<double>(i1) / bins.distance +
                                            options.weighting_constant)
                                 : 1.0) *
              object.weights[first] * object.weights[second];
          histogram[((i1 * bins.surface_angle + i2) * bins.normal_angle + i3) *
                        bins.occupancy +
                    i4] += weight * share;
        }
  }
  return withHarmonics(std::move(histogram), given, noise.evidence, scale, options);
}

} // namespace pcl::indoor
