/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/sphere_modes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::indoor {

namespace {

constexpr int cells_per_side = 96; // of a face of the cube: about a degree
constexpr int max_seeds = 200;     // bounds the time: the heaviest cells come first

int
cellOf(const Eigen::Vector3d& normal, double& sign)
{
  int face = 0;
  normal.cwiseAbs().maxCoeff(&face);
  sign = normal[face] < 0.0 ? -1.0 : 1.0;
  const auto part = [&](int axis) {
    const double ratio = normal[axis] / normal[face]; // -1 ... 1
    return std::clamp(
        static_cast<int>((ratio + 1.0) * 0.5 * cells_per_side), 0, cells_per_side - 1);
  };
  return (face * cells_per_side + part((face + 1) % 3)) * cells_per_side +
         part((face + 2) % 3);
}

/** \brief The mean direction of what lies around an axis; what is near counts more. */
Eigen::Vector3d
meanAround(const std::vector<WeightedDirection>& histogram,
           const Eigen::Vector3d& axis,
           double radius)
{
  const double cosine = std::cos(radius);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& bin : histogram) {
    const double dot = bin.direction.dot(axis);
    const double nearness = std::abs(dot) - cosine;
    if (nearness > 0.0)
      sum += (dot < 0.0 ? -bin.weight : bin.weight) * nearness * bin.direction;
  }
  return sum.normalized();
}

double
weightAround(const std::vector<WeightedDirection>& histogram,
             const Eigen::Vector3d& axis,
             double cosine)
{
  double weight = 0.0;
  for (const auto& bin : histogram)
    weight += std::abs(bin.direction.dot(axis)) >= cosine ? bin.weight : 0.0;
  return weight;
}

/** \brief Weight in the ring around a cone that has its like on the other side. */
double
symmetricRing(const std::vector<WeightedDirection>& histogram,
              const Eigen::Vector3d& axis,
              double cone)
{
  constexpr int sectors = 8; // of the ring: opposite ones are compared
  std::array<double, sectors> ring{};
  const Eigen::Vector3d u = axis.unitOrthogonal();
  const Eigen::Vector3d v = axis.cross(u);
  const double inner = std::cos(cone);
  const double outer = std::cos(2.0 * cone);
  for (const auto& bin : histogram) {
    const double dot = bin.direction.dot(axis);
    if (std::abs(dot) >= inner || std::abs(dot) < outer)
      continue;
    const double sign = dot < 0.0 ? -1.0 : 1.0;
    const double angle =
        std::atan2(sign * bin.direction.dot(v), sign * bin.direction.dot(u));
    const int sector = static_cast<int>((angle / M_PI + 1.0) * 0.5 * sectors);
    ring[sector % sectors] += bin.weight;
  }
  double symmetric = 0.0;
  for (int s = 0; s < sectors; ++s)
    symmetric += std::min(ring[s], ring[(s + sectors / 2) % sectors]);
  return symmetric;
}

} // namespace

std::vector<WeightedDirection>
sphereHistogram(const std::vector<Eigen::Vector3d>& normals,
                const std::vector<double>& weights)
{
  std::vector<WeightedDirection> cells(3 * cells_per_side * cells_per_side,
                                       {Eigen::Vector3d::Zero(), 0.0});
  double total = 0.0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const double weight = weights.empty() ? 1.0 : weights[i];
    if (!normals[i].allFinite() || weight == 0.0)
      continue;
    double sign = 1.0;
    auto& cell = cells[cellOf(normals[i], sign)];
    cell.direction += sign * weight * normals[i];
    cell.weight += weight;
    total += weight;
  }
  std::vector<WeightedDirection> histogram;
  for (auto& cell : cells)
    if (cell.weight > 0.0)
      histogram.push_back({cell.direction.normalized(), cell.weight / total});
  return histogram;
}

std::vector<WeightedDirection>
sphereModes(const std::vector<WeightedDirection>& histogram,
            double cone,
            double min_share,
            double min_contrast)
{
  std::vector<WeightedDirection> seeds = histogram;
  std::stable_sort(seeds.begin(), seeds.end(), [](const auto& a, const auto& b) {
    return a.weight > b.weight;
  });
  const double cosine = std::cos(cone);
  const auto near = [&](const auto& list, const Eigen::Vector3d& direction) {
    return std::any_of(list.begin(), list.end(), [&](const auto& other) {
      return std::abs(other.direction.dot(direction)) >= cosine;
    });
  };
  std::vector<WeightedDirection> tried;
  std::vector<WeightedDirection> modes;
  for (const auto& seed : seeds) {
    if (tried.size() >= max_seeds)
      break;
    if (near(tried, seed.direction))
      continue;
    tried.push_back(seed);
    if (weightAround(histogram, seed.direction, cosine) < min_share)
      continue; // the way to a mode would be long: it has seeds of its own
    WeightedDirection mode = seed;
    for (int step = 0; step < 200; ++step) { // mean shift
      const Eigen::Vector3d last = mode.direction;
      mode.direction = meanAround(histogram, last, 1.5 * cone);
      if (last.dot(mode.direction) > 1.0 - 1e-9)
        break;
    }
    mode.weight = weightAround(histogram, mode.direction, cosine);
    if (mode.weight < min_share || near(modes, mode.direction) ||
        mode.weight < min_contrast * symmetricRing(histogram, mode.direction, cone))
      continue;
    tried.push_back(mode);
    modes.push_back(mode);
  }
  std::stable_sort(modes.begin(), modes.end(), [](const auto& a, const auto& b) {
    return a.weight > b.weight;
  });
  return modes;
}

} // namespace pcl::indoor
