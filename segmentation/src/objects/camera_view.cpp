/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/objects/camera_view.h>

#include <pcl/indoor/quantile.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace {

constexpr double least_in_front = 0.99; // share of a camera's points
constexpr double widest_view = 75;      // degrees from the camera's axis
constexpr double middle = 10;           // degrees: what the camera looks at
constexpr float farthest_table = 1.4f;  // metres, half of the points in the middle
constexpr int rounds = 5;               // with each tolerance

/** The direction to which normals near it are most parallel, and those across it most
 * across. */
Eigen::Vector3d
turned(const Eigen::Vector3d& up,
       const std::vector<Eigen::Vector3f>& normals,
       double tolerance)
{
  const double parallel = std::cos(tolerance), across = std::sin(tolerance);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& n : normals) {
    const Eigen::Vector3d normal = n.cast<double>();
    const double cosine = std::abs(normal.dot(up));
    if (cosine > parallel)
      scatter -= normal * normal.transpose();
    else if (cosine < across)
      scatter += normal * normal.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  const Eigen::Vector3d best = solver.eigenvectors().col(0);
  return best.dot(up) < 0 ? Eigen::Vector3d(-best) : best;
}

} // namespace

namespace pcl {
namespace indoor {

Capture
captureOf(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& camera)
{
  std::vector<float> depths;
  std::size_t in_front = 0;
  const auto is_within = [](const Eigen::Vector3f& ray, double degrees) {
    return ray.z() > 0 &&
           ray.head<2>().norm() <= std::tan(degrees * M_PI / 180) * ray.z();
  };
  for (const auto& point : points) {
    const Eigen::Vector3f ray = point - camera;
    in_front += is_within(ray, widest_view);
    if (is_within(ray, middle))
      depths.push_back(ray.z());
  }
  if (points.empty() || static_cast<double>(in_front) <
                            least_in_front * static_cast<double>(points.size()))
    return Capture::Scan;
  const bool is_room = !depths.empty() && median(depths) > farthest_table;
  return is_room ? Capture::RoomView : Capture::TableView;
}

Eigen::Vector3f
upOfView(const std::vector<Eigen::Vector3f>& normals)
{
  Eigen::Vector3d up = -Eigen::Vector3d::UnitY();
  std::vector<Eigen::Vector3f> usable;
  for (const auto& normal : normals)
    if (normal.squaredNorm() > 0.5f)
      usable.push_back(normal);
  if (usable.empty())
    return up.cast<float>();
  for (const double degrees : {45, 15})
    for (int round = 0; round < rounds; ++round)
      up = turned(up, usable, degrees * M_PI / 180);
  return up.normalized().cast<float>();
}

} // namespace indoor
} // namespace pcl
