/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "retrieval/feature_correlation.h"

#include "objects/object_files.h" // for classifierPoints
#include "text/formatted.h"

#include <pcl/features/line_occupancy.h>
#include <pcl/features/pair_sampling.h>

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

constexpr int grid_size = 64; // N_X of Sec. 5.2.1
constexpr std::array<std::array<std::size_t, 2>, 6> both{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

double
arcCosine(double cosine)
{
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

/** Add Eq. (5.2) to (5.8) of the pairs of one object, but for those in one place. */
void
addFeatures(const std::vector<OrientedPoint>& points,
            const EPPFOptions& options,
            FeatureMoments& moments)
{
  if (points.size() < 2)
    return;
  const double scale = options.scale > 0 ? options.scale : objectExtent(points);
  const LineOccupancy occupancy(points, grid_size);
  const PairSampler sampler(points, PairSampling::Uniform, options.seed);
  for (std::uint64_t k = 0; k < options.pair_count; ++k) {
    const auto [first, second] = sampler.pair(k);
    const auto &one = points[first], &two = points[second];
    const Eigen::Vector3d line = (two.position - one.position).cast<double>();
    const double length = line.norm();
    if (!(length > 0))
      continue;
    const Eigen::Vector3d n1 = one.normal.cast<double>(),
                          n2 = two.normal.cast<double>();
    const auto walk = occupancy.lineBetween(occupancy.cell(one.position),
                                            occupancy.cell(two.position));
    moments.add(
        {length / scale,
         std::max(arcCosine(n1.dot(line) / length), arcCosine(n2.dot(line) / length)) -
             M_PI / 2,
         arcCosine(std::abs(n1.dot(n2))),
         static_cast<double>(occupancy.countOccupied(walk)) / (walk.steps + 1)});
  }
}

} // namespace

void
FeatureMoments::add(const PairFeatures& features)
{
  ++count_;
  PairFeatures before{};
  for (std::size_t f = 0; f < 4; ++f) {
    before[f] = features[f] - mean_[f];
    mean_[f] += before[f] / count_;
  }
  for (std::size_t f = 0; f < 4; ++f)
    for (std::size_t g = f; g < 4; ++g)
      products_[f][g] += before[f] * (features[g] - mean_[g]);
}

std::array<double, 6>
FeatureMoments::correlations() const
{
  std::array<double, 6> correlations{};
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [f, g] = both[k];
    const double scale = std::sqrt(products_[f][f]) * std::sqrt(products_[g][g]);
    correlations[k] = scale > 0 ? products_[f][g] / scale : 0;
  }
  return correlations;
}

std::array<double, 6>
featureCorrelation(const std::vector<PointCloud<PointNormal>::Ptr>& objects,
                   const EPPFOptions& options)
{
  FeatureMoments moments;
  for (const auto& object : objects)
    addFeatures(classifierPoints(*object), options, moments);
  return moments.correlations();
}

std::string
correlationText(const std::array<double, 6>& correlations)
{
  double mean = 0;
  for (const double correlation : correlations)
    mean += std::abs(correlation) / 6;
  return formatted(
      "correlation of features, mean |r| %.3f: f1 f2 %.3f, f1 f3 %.3f, f1 f4 "
      "%.3f, f2 f3 %.3f, f2 f4 %.3f, f3 f4 %.3f\n",
      mean,
      correlations[0],
      correlations[1],
      correlations[2],
      correlations[3],
      correlations[4],
      correlations[5]);
}

double
extentOf(const PointCloud<PointNormal>& object)
{
  return objectExtent(classifierPoints(object));
}

} // namespace pcl::indoor::tool
