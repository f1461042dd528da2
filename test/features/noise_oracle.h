/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

/* What eppf_denoising.h says, point by point: every point against every other, in
 * double precision. */

#include <pcl/features/oriented_point.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

namespace pcl::indoor {

inline Eigen::Vector3d
placeOf(const OrientedPoint& point)
{
  return point.position.cast<double>();
}

/** \brief The distances of all pairs, ascending. */
inline std::vector<double>
slowDistances(const std::vector<OrientedPoint>& points)
{
  std::vector<double> distances;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      distances.push_back((placeOf(points[i]) - placeOf(points[j])).norm());
  std::sort(distances.begin(), distances.end());
  return distances;
}

inline double
slowExtent(const std::vector<OrientedPoint>& points)
{
  return slowDistances(points).back();
}

/** \brief The points along a Z curve: by the interleaved bits of their places in a cube
 * of 1024 cells per edge. */
inline std::vector<OrientedPoint>
alongCurve(const std::vector<OrientedPoint>& points)
{
  Eigen::Array3f lower = points.front().position, upper = lower;
  for (const auto& point : points) {
    lower = lower.min(point.position.array());
    upper = upper.max(point.position.array());
  }
  const float scale = 1023.0f / (upper - lower).maxCoeff();
  std::vector<std::tuple<std::uint64_t, float, float, float, std::size_t>> order;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::Array3i cell =
        ((points[k].position.array() - lower) * scale).cast<int>();
    std::uint64_t code = 0;
    for (int bit = 9; bit >= 0; --bit)
      for (int axis = 0; axis < 3; ++axis)
        code = code << 1 | ((cell[axis] >> bit) & 1);
    const auto& p = points[k].position;
    order.emplace_back(code, p.x(), p.y(), p.z(), k);
  }
  std::sort(order.begin(), order.end());
  std::vector<OrientedPoint> sorted;
  for (const auto& entry : order)
    sorted.push_back(points[std::get<4>(entry)]);
  return sorted;
}

/** \brief A plane through weighted places: their mean, and the directions and variances
 * of what is left, the least first. */
struct SlowPlane {
  Eigen::Vector3d mean, normal, variances;

  template <typename Weight>
  SlowPlane(const std::vector<OrientedPoint>& points, const Weight& weightOf)
  {
    double sum = 0;
    mean.setZero();
    for (const auto& point : points) {
      sum += weightOf(placeOf(point));
      mean += weightOf(placeOf(point)) * placeOf(point);
    }
    mean /= sum;
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const auto& point : points) {
      const Eigen::Vector3d d = placeOf(point) - mean;
      scatter += weightOf(placeOf(point)) / sum * d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    normal = solver.eigenvectors().col(0);
    variances = solver.eigenvalues().cwiseMax(0.0);
  }

  double
  thickness() const
  {
    return variances[0] / variances[1];
  }
};

/** \brief The plane of the 16 nearest points of a place. */
inline SlowPlane
nearestPlane(const std::vector<OrientedPoint>& points, const Eigen::Vector3d& place)
{
  std::vector<double> distances;
  for (const auto& point : points)
    distances.push_back((placeOf(point) - place).norm());
  std::sort(distances.begin(), distances.end());
  return {points, [&, reach = distances[15]](const Eigen::Vector3d& other) {
            return (other - place).norm() <= reach ? 1.0 : 0.0;
          }};
}

/** \brief The plane of the points around a place in a window of a width: (1 - t /
 * 16)^16, nearly exp(-t), of t = d^2 / (2 width^2). */
inline SlowPlane
windowPlane(const std::vector<OrientedPoint>& points,
            const Eigen::Vector3d& place,
            double width)
{
  return {points, [&](const Eigen::Vector3d& other) {
            const double t = (other - place).squaredNorm() / (2 * width * width);
            return std::pow(std::max(0.0, 1 - t / 16), 16);
          }};
}

/** \brief The value of each of so many points evenly along the curve, ascending. */
template <typename Value>
std::vector<double>
sortedProbes(const std::vector<OrientedPoint>& points,
             std::size_t count,
             const Value& of)
{
  std::vector<double> values;
  for (std::size_t probe = 0; probe < count; ++probe)
    values.push_back(
        of(placeOf(points[(2 * probe + 1) * points.size() / (2 * count)])));
  std::sort(values.begin(), values.end());
  return values;
}

struct SlowNoise {
  double evidence = 0, deviation = 0;
};

inline double
slowSpacing(const std::vector<OrientedPoint>& points)
{
  return slowExtent(points) * std::sqrt(3 / static_cast<double>(points.size()));
}

inline double
rise(double value, double from, double to)
{
  return std::min(std::max((value - from) / (to - from), 0.0), 1.0);
}

/** \brief measureNoise() of 256 to 4096 points. */
inline SlowNoise
slowNoise(const std::vector<OrientedPoint>& given)
{
  const auto points = alongCurve(given);
  const double spacing = slowSpacing(points), extent = slowExtent(points);
  const auto thickness = [&](const Eigen::Vector3d& place) {
    return nearestPlane(points, place).thickness();
  };
  const auto residual = [&](double width) {
    const double window = width * width;
    const auto squares = sortedProbes(points, 32, [&](const Eigen::Vector3d& place) {
      const double seen = windowPlane(points, place, width).variances[0];
      return seen < 0.999 * window ? 1 / (1 / seen - 1 / window) : 1000 * window;
    });
    return std::sqrt(squares[3]); // one of the flattest tenth
  };
  double width = 1.5 * spacing;
  SlowNoise noise;
  for (noise.deviation = residual(width);
       width < 1.4 * noise.deviation && width < extent;
       noise.deviation = residual(width))
    width *= 1.25;
  noise.evidence = rise(sortedProbes(points, 32, thickness)[1], 0.12, 0.16) *
                   rise(sortedProbes(points, 128, thickness)[12], 0.22, 0.25) *
                   rise(noise.deviation / spacing, 0.45, 0.55);
  return noise.evidence > 0 ? noise : SlowNoise();
}

struct SlowObject {
  std::vector<OrientedPoint> points; ///< in the order that was given
  std::vector<double> weights;
  double extent = 0;
};

/** \brief denoised() of at most 4096 points; the large distance is that of all pairs.
 */
inline SlowObject
slowDenoised(const std::vector<OrientedPoint>& given, const SlowNoise& noise)
{
  SlowObject object;
  object.points = given;
  for (auto& point : object.points) {
    const Eigen::Vector3d place = placeOf(point);
    const auto plane = windowPlane(given, place, 1.2 * noise.deviation);
    point.position =
        (place + noise.evidence * plane.normal.dot(plane.mean - place) * plane.normal)
            .cast<float>();
    object.weights.push_back(1 + noise.evidence *
                                     (std::max(1 - plane.thickness(), 0.02) - 1));
  }
  const auto distances = slowDistances(object.points);
  const double share =
      noise.evidence * rise(noise.deviation / slowSpacing(given), 0.5, 1);
  object.extent = (1 - share) * slowExtent(given) +
                  share * 1.1 * distances[distances.size() * 99 / 100];
  return object;
}

} // namespace pcl::indoor
