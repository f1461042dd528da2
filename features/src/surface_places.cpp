/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "place_counter.h"
#include "soft_bin.h"

#include <pcl/features/pair_counting.h>
#include <pcl/features/surface_places.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace pcl {
namespace indoor {

PlaceCounter::PlaceCounter(const PrincipalFrame& frame,
                           double scale,
                           const PlaceBins& bins)
: center_(frame.center.cast<float>())
, axes_(frame.axes.cast<float>())
, counts_{bins.longest, bins.middle, bins.shortest}
, strides_{6u * static_cast<std::uint32_t>(bins.middle * bins.shortest),
           6u * static_cast<std::uint32_t>(bins.shortest),
           6u}
{
  for (int axis = 0; axis < 3; ++axis)
    bins_per_metre_[axis] =
        static_cast<float>(2.0 * counts_[axis] / std::max(scale, 1e-30));
}

inline void
PlaceCounter::count(const OrientedPoint& point, std::uint64_t* counts) const
{
  const Eigen::Vector3f offset = point.position - center_;
  const Eigen::Vector3f place = axes_ * offset;
  const Eigen::Vector3f normal = axes_ * point.normal;
  const float side = point.normal.dot(offset) < 0.0f ? -1.0f : 1.0f;
  std::array<std::uint32_t, 3> direction;
  std::array<float, 3> share; // of each axis
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_inward = side * normal[axis] * place[axis] < 0.0f;
    direction[axis] = 2u * static_cast<std::uint32_t>(axis) + (is_inward ? 1u : 0u);
    share[axis] = 65536.0f * normal[axis] * normal[axis];
  }
  const auto soft = [&](int axis) {
    const float last = static_cast<float>(counts_[axis]);
    const float bin = std::min(std::abs(place[axis]) * bins_per_metre_[axis], last);
    return SoftBin(bin, counts_[axis], 1.0f);
  };
  const SoftBin along[] = {soft(0), soft(1), soft(2)};
  std::array<std::uint32_t, 8> bin; // of each corner
  std::array<std::int32_t, 24> amount;
  for (int corner = 0; corner < 8; ++corner) {
    const int sides[] = {corner & 1, (corner >> 1) & 1, corner >> 2};
    bin[corner] = strides_[0] * along[0].bin[sides[0]] +
                  strides_[1] * along[1].bin[sides[1]] +
                  strides_[2] * along[2].bin[sides[2]];
    const float part =
        along[0].share[sides[0]] * along[1].share[sides[1]] * along[2].share[sides[2]];
    for (int axis = 0; axis < 3; ++axis)
      amount[3 * corner + axis] = static_cast<std::int32_t>(part * share[axis] + 0.5f);
  }
  for (int corner = 0; corner < 8; ++corner)
    for (int axis = 0; axis < 3; ++axis)
      counts[bin[corner] + direction[axis]] +=
          static_cast<std::uint32_t>(amount[3 * corner + axis]);
}

void
PlaceCounter::count(const std::vector<OrientedPoint>& points,
                    std::size_t first,
                    std::size_t last,
                    std::uint64_t* counts) const
{
  for (std::size_t k = first; k < last; ++k)
    count(points[k], counts);
}

PrincipalFrame
principalFrame(const std::vector<OrientedPoint>& points)
{
  assert(!points.empty());
  const Eigen::Vector3d origin = points.front().position.cast<double>();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  Eigen::Vector3d products = Eigen::Vector3d::Zero(); // yz, zx, xy
  for (const auto& point : points) {
    const Eigen::Vector3d offset = point.position.cast<double>() - origin;
    const double x = offset.x(), y = offset.y(), z = offset.z();
    sum += offset;
    squares += Eigen::Vector3d(x * x, y * y, z * z);
    products += Eigen::Vector3d(y * z, z * x, x * y);
  }
  const auto count = static_cast<double>(points.size());
  Eigen::Matrix3d moment;
  moment << squares.x(), products.z(), products.y(), products.z(), squares.y(),
      products.x(), products.y(), products.x(), squares.z();
  moment -= sum * sum.transpose() / count;
  PrincipalFrame frame;
  frame.center = origin + sum / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moment);
  frame.axes = solver.eigenvectors().rowwise().reverse().transpose(); // descending
  return frame;
}

std::vector<double>
surfacePlaces(const std::vector<OrientedPoint>& points,
              double scale,
              const PlaceBins& bins,
              unsigned int number_of_threads)
{
  assert(bins.size() > 0);
  const PlaceCounter counter(principalFrame(points), scale, bins);
  const auto counts = countPairs(points.size(),
                                 bins.size(),
                                 number_of_threads,
                                 [&](std::size_t first, std::size_t last, auto& own) {
                                   counter.count(points, first, last, own.data());
                                 });
  const auto sum = static_cast<double>(
      std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
  std::vector<double> places(counts.size());
  std::transform(counts.begin(), counts.end(), places.begin(), [sum](auto count) {
    return static_cast<double>(count) / sum;
  });
  return places;
}

} // namespace indoor
} // namespace pcl
