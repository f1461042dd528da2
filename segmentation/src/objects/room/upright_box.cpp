/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/room_objects.h>

#include "internal/cross.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::indoor {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/** The convex hull, counter-clockwise (Andrew's monotone chain). */
Points
convexHull(Points points)
{
  const auto before = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3)
    return points;
  Points hull;
  const auto add = [&hull](const Eigen::Vector2d& point, std::size_t least) {
    while (hull.size() > least && crossOf(hull.back() - hull[hull.size() - 2],
                                          point - hull[hull.size() - 2]) <= 0.0)
      hull.pop_back();
    hull.push_back(point);
  };
  for (const auto& point : points)
    add(point, 1);
  const std::size_t lower = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;)
    add(points[i], lower);
  hull.pop_back(); // the first point again
  return hull;
}

/** The extent of points in a frame that is turned by yaw. */
Eigen::AlignedBox2d
extentOf(const Points& points, double yaw)
{
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(-yaw).toRotationMatrix();
  Eigen::AlignedBox2d box;
  for (const auto& point : points)
    box.extend(turn * point);
  return box;
}

/** The direction of the hull's edge on which the rectangle of the least area lies. */
double
bestYaw(const Points& hull)
{
  double best = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - hull[i];
    const double yaw = std::atan2(edge.y(), edge.x());
    const double area = extentOf(hull, yaw).volume();
    if (area < least * (1.0 - 1e-9)) {
      least = area;
      best = yaw;
    }
  }
  return best;
}

} // namespace

UprightBox
uprightBox(const std::vector<Eigen::Vector3d>& points)
{
  UprightBox box;
  if (points.empty())
    return box;
  Points ground;
  ground.reserve(points.size());
  double low = points.front().z(), high = low;
  for (const auto& point : points) {
    ground.emplace_back(point.head<2>());
    low = std::min(low, point.z());
    high = std::max(high, point.z());
  }
  const auto hull = convexHull(std::move(ground));
  double yaw = bestYaw(hull);
  auto extent = extentOf(hull, yaw);
  if (extent.sizes().x() < extent.sizes().y()) {
    yaw += M_PI_2;
    extent = extentOf(hull, yaw);
  }
  box.center << Eigen::Rotation2Dd(yaw) * extent.center(), 0.5 * (low + high);
  box.size << extent.sizes(), high - low;
  box.yaw = std::fmod(yaw + 2.0 * M_PI, M_PI);
  return box;
}

double
distanceTo(const UprightBox& box, const Eigen::Vector3d& place)
{
  Eigen::Vector3d away = place - box.center;
  away.head<2>() = (Eigen::Rotation2Dd(-box.yaw) * away.head<2>()).eval();
  return (away.cwiseAbs() - 0.5 * box.size).cwiseMax(0.0).norm();
}

} // namespace pcl::indoor
