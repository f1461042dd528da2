/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/object_disturbance.h"

#include "files/random_numbers.h"
#include "objects/object_files.h"

#include <pcl/common/io.h>
#include <pcl/features/oriented_point.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <unordered_map>

namespace pcl::indoor::tool {
namespace {

float
extentOf(const PointCloud<PointNormal>& cloud)
{
  std::vector<OrientedPoint> points(cloud.size());
  for (std::size_t k = 0; k < cloud.size(); ++k)
    points[k].position = cloud[k].getVector3fMap();
  return objectExtent(points);
}

/** \brief A standard normal value (Box and Muller), the same with every library. */
double
normal(std::mt19937& rng)
{
  const double radius = std::sqrt(-2.0 * std::log(uniform(rng)));
  return radius * std::cos(2.0 * M_PI * uniform(rng));
}

Eigen::Vector3f
randomDirection(std::mt19937& rng)
{
  Eigen::Vector3d direction;
  for (int axis = 0; axis < 3; ++axis)
    direction[axis] = normal(rng);
  return direction.normalized().cast<float>();
}

} // namespace

void
addNoise(PointCloud<PointNormal>& cloud, double percent, std::uint32_t seed)
{
  std::mt19937 rng(seed);
  const double deviation = percent / 100.0 * extentOf(cloud);
  for (auto& point : cloud)
    for (int axis = 0; axis < 3; ++axis)
      point.data[axis] += static_cast<float>(deviation * normal(rng));
}

void
hideFromView(PointCloud<PointNormal>& cloud, double percent, std::uint32_t seed)
{
  if (cloud.empty())
    return;
  std::mt19937 rng(seed);
  const Eigen::Vector3f view = randomDirection(rng);
  const Eigen::Vector3f right = view.unitOrthogonal();
  const Eigen::Vector3f up = view.cross(right);
  const float pixel = 2 * extentOf(cloud) / std::sqrt(static_cast<float>(cloud.size()));
  const auto pixelOf = [&](const Eigen::Vector3f& position) {
    const auto column =
        static_cast<std::int32_t>(std::floor(position.dot(right) / pixel));
    const auto row = static_cast<std::int32_t>(std::floor(position.dot(up) / pixel));
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32 |
           static_cast<std::uint32_t>(row);
  };
  std::unordered_map<std::uint64_t, float> nearest;
  for (const auto& point : cloud) {
    const float depth = point.getVector3fMap().dot(view);
    const auto entry = nearest.emplace(pixelOf(point.getVector3fMap()), depth).first;
    entry->second = std::min(entry->second, depth);
  }
  std::vector<std::pair<float, float>> hiddenness; // behind the nearest, then depth
  for (const auto& point : cloud) {
    const float depth = point.getVector3fMap().dot(view);
    hiddenness.emplace_back(depth - nearest[pixelOf(point.getVector3fMap())], depth);
  }
  Indices order(cloud.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](index_t a, index_t b) {
    return hiddenness[static_cast<std::size_t>(a)] <
           hiddenness[static_cast<std::size_t>(b)];
  });
  const double kept = static_cast<double>(cloud.size()) * (1.0 - percent / 100.0);
  order.resize(static_cast<std::size_t>(std::lround(kept)));
  std::sort(order.begin(), order.end());
  PointCloud<PointNormal> seen;
  copyPointCloud(cloud, order, seen);
  cloud = seen;
}

void
placeBeforeCamera(PointCloud<PointNormal>& cloud, std::uint32_t seed)
{
  if (cloud.empty())
    return;
  std::mt19937 rng(seed);
  const Eigen::Vector3f view = randomDirection(rng);
  const auto roll = static_cast<float>(2.0 * M_PI * uniform(rng));
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(roll, Eigen::Vector3f::UnitZ()).toRotationMatrix() *
      Eigen::Quaternionf::FromTwoVectors(view, Eigen::Vector3f::UnitZ())
          .toRotationMatrix();
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& point : cloud)
    middle += point.getVector3fMap().cast<double>();
  const Eigen::Vector3f center =
      (middle / static_cast<double>(cloud.size())).cast<float>();
  const Eigen::Vector3f place = 3.0f * extentOf(cloud) * Eigen::Vector3f::UnitZ();
  for (auto& point : cloud) {
    point.getVector3fMap() = (turn * (point.getVector3fMap() - center) + place).eval();
    point.getNormalVector3fMap() = (turn * point.getNormalVector3fMap()).eval();
  }
}

int
neighborsUnderNoise(const Disturbance& disturbance,
                    std::size_t point_count,
                    int least_count)
{
  const double radius = disturbance.normal_radius * disturbance.noise_percent / 100.0;
  const double share = std::min(M_PI * radius * radius / 3.0, 1.0);
  return std::max(least_count,
                  static_cast<int>(share * static_cast<double>(point_count)));
}

void
disturb(PointCloud<PointNormal>& cloud,
        const Disturbance& disturbance,
        int neighbor_count,
        std::uint32_t seed)
{
  if (disturbance.hidden_percent > 0.0)
    hideFromView(cloud, disturbance.hidden_percent, 2 * seed);
  if (disturbance.noise_percent > 0.0)
    addNoise(cloud, disturbance.noise_percent, 2 * seed + 1);
  if (disturbance.before_camera)
    placeBeforeCamera(cloud, 2 * seed);
  if (disturbance.keeps_normals)
    return;
  if (disturbance.noise_percent > 0.0 || disturbance.estimates_normals)
    estimateNormals(cloud,
                    neighborsUnderNoise(disturbance, cloud.size(), neighbor_count));
}

} // namespace pcl::indoor::tool
