/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/eppf_options.h>
#include <pcl/features/oriented_point.h>

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::indoor {

constexpr double pi = 3.14159265358979323846;

/** \brief The share of a place, in bins, that falls into a bin: its own, and within
 * softness / 2 of a border linearly the next one's. */
inline double
softShare(double place, int bin, int count, double softness)
{
  const auto rise = [softness](double x) { // over a border at 0
    return std::clamp(x / softness + 0.5, 0.0, 1.0);
  };
  const double above_lower = bin == 0 ? 1.0 : rise(place - bin);
  const double above_upper = bin == count - 1 ? 0.0 : rise(place - bin - 1);
  return above_lower - above_upper;
}

/** \brief A real spherical harmonic of mean square 1, from the standard library's
 * associated Legendre functions, sine for m < 0. */
inline double
slowHarmonic(int l, int m, const Eigen::Vector3d& direction)
{
  const auto order = static_cast<unsigned int>(std::abs(m));
  const double theta = std::acos(std::clamp(direction.z(), -1.0, 1.0));
  const double phi = std::atan2(direction.y(), direction.x());
  const double value = std::sqrt(4.0 * pi) *
                       std::sph_legendre(static_cast<unsigned int>(l), order, theta);
  if (m == 0)
    return value;
  return std::sqrt(2.0) * value *
         (m > 0 ? std::cos(order * phi) : std::sin(order * phi));
}

/** \brief surfaceHarmonics() around the centre that lies middle_share of the way from
 * the mean to the middle of the extents, with every point offered to every shell. */
inline std::vector<double>
slowHarmonics(const std::vector<OrientedPoint>& points,
              double middle_share,
              double scale,
              const HarmonicBins& bins)
{
  const auto count = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd offsets(3, count);
  for (Eigen::Index k = 0; k < count; ++k)
    offsets.col(k) = points[static_cast<std::size_t>(k)].position.cast<double>();
  offsets.colwise() -= offsets.rowwise().mean().eval();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(offsets, Eigen::ComputeFullU);
  Eigen::MatrixXd places = svd.matrixU().transpose() * offsets;
  places.colwise() -=
      (middle_share * (places.rowwise().minCoeff() + places.rowwise().maxCoeff()) / 2)
          .eval();
  const std::size_t functions = bins.functionCount();
  const auto shell_share = [&](const Eigen::Vector3d& place, int shell, int shells) {
    return softShare(place.norm() / (0.6 * scale) * shells, shell, shells, 1.0);
  };
  std::vector<double> values(bins.size());
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Vector3d place = places.col(k);
    const Eigen::Vector3d normal =
        svd.matrixU().transpose() *
        points[static_cast<std::size_t>(k)].normal.cast<double>();
    for (int shell = 0; shell < bins.shells; ++shell)
      for (int l = 0; l <= bins.degree; ++l)
        for (int m = -l; m <= l; ++m)
          for (int axis = 0; axis < 4; ++axis) {
            const double share = axis < 3 ? normal[axis] * normal[axis] : 1.0;
            values[(4 * shell + axis) * functions + l * l + l + m] +=
                share * shell_share(place, shell, bins.shells) *
                slowHarmonic(l, m, place.normalized()) / static_cast<double>(count);
          }
    for (int near = 0; near < bins.distances; ++near)
      values[4 * bins.shells * functions + near] +=
          shell_share(place, near, bins.distances) / static_cast<double>(count);
  }
  double sum = 0.0;
  for (auto& value : values) {
    value = std::abs(value) + 0.002;
    sum += value;
  }
  for (auto& value : values)
    value /= sum;
  return values;
}

} // namespace pcl::indoor
