/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "thesis/objects/ransac_planes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace {

using Members = std::vector<std::uint32_t>;
using pcl::indoor::StructurePlane;

constexpr unsigned draws = 1000;         // of three points, per plane
constexpr std::size_t judged_by = 20000; // points that count the draws' support

/** A number below the bound, the same on every machine. */
std::size_t
below(std::size_t bound, std::mt19937& random)
{
  return static_cast<std::size_t>((std::uint64_t{random()} * bound) >> 32);
}

StructurePlane
planeThrough(const Eigen::Vector3d& a,
             const Eigen::Vector3d& b,
             const Eigen::Vector3d& c)
{
  StructurePlane plane;
  plane.normal = (b - a).cross(c - a);
  const double length = plane.normal.norm();
  plane.normal = length > 0 ? Eigen::Vector3d(plane.normal / length)
                            : Eigen::Vector3d(Eigen::Vector3d::Zero());
  plane.offset = plane.normal.dot(a);
  return plane;
}

/** The points of a plane, of some points or of every n-th of them. */
Members
pointsNear(const StructurePlane& plane,
           const std::vector<Eigen::Vector3f>& points,
           const Members& candidates,
           std::size_t stride,
           double distance)
{
  Members near;
  for (std::size_t i = 0; i < candidates.size(); i += stride)
    if (std::abs(plane.heightOf(points[candidates[i]].cast<double>())) <= distance)
      near.push_back(candidates[i]);
  return near;
}

/** The plane of least squares. */
StructurePlane
fitted(const std::vector<Eigen::Vector3f>& points, const Members& members)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto i : members)
    mean += points[i].cast<double>();
  mean /= static_cast<double>(members.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto i : members) {
    const Eigen::Vector3d offset = points[i].cast<double>() - mean;
    scatter += offset * offset.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  StructurePlane plane;
  plane.normal = solver.eigenvectors().col(0);
  plane.offset = plane.normal.dot(mean);
  return plane;
}

/** The plane of the draw with most points. */
StructurePlane
bestPlane(const std::vector<Eigen::Vector3f>& points,
          const Members& candidates,
          double distance,
          std::mt19937& random)
{
  const auto stride = std::max<std::size_t>(1, candidates.size() / judged_by);
  StructurePlane best;
  std::size_t most = 0;
  for (unsigned draw = 0; draw < draws; ++draw) {
    Eigen::Vector3d corners[3];
    for (auto& corner : corners)
      corner = points[candidates[below(candidates.size(), random)]].cast<double>();
    const auto plane = planeThrough(corners[0], corners[1], corners[2]);
    if (plane.normal.isZero(0.0))
      continue;
    const auto count = pointsNear(plane, points, candidates, stride, distance).size();
    if (count > most) {
      most = count;
      best = plane;
    }
  }
  return best;
}

} // namespace

namespace pcl::indoor {

std::vector<StructurePlane>
ransacPlanes(const std::vector<Eigen::Vector3f>& points,
             double distance,
             double share,
             std::vector<std::uint32_t>& plane_of_point)
{
  plane_of_point.assign(points.size(), 0);
  std::vector<StructurePlane> planes;
  Members left(points.size());
  for (std::uint32_t i = 0; i < left.size(); ++i)
    left[i] = i;
  std::mt19937 random(1);
  const double least = share * static_cast<double>(points.size());
  while (left.size() >= 3 && static_cast<double>(left.size()) >= least) {
    auto plane = bestPlane(points, left, distance, random);
    if (plane.normal.isZero(0.0))
      break;
    plane = fitted(points, pointsNear(plane, points, left, 1, distance));
    const auto members = pointsNear(plane, points, left, 1, distance);
    if (members.size() < 3 || static_cast<double>(members.size()) < least)
      break;
    double before = 0;
    for (const auto& point : points)
      before += plane.heightOf(point.cast<double>()) > 0 ? 1 : -1;
    if (before < 0) {
      plane.normal = -plane.normal;
      plane.offset = -plane.offset;
    }
    planes.push_back(plane);
    for (const auto i : members)
      plane_of_point[i] = static_cast<std::uint32_t>(planes.size());
    Members others;
    for (const auto i : left)
      if (plane_of_point[i] == 0)
        others.push_back(i);
    left.swap(others);
  }
  return planes;
}

} // namespace pcl::indoor
