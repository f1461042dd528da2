/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/object_context.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl {
namespace indoor {

namespace {

constexpr float longest = 4.0f;  // metres; of larger things the size says no more
constexpr float touching = 0.1f; // metres

float
cross(const Eigen::Vector2f& a, const Eigen::Vector2f& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

bool
isBefore(const Eigen::Vector2f& a, const Eigen::Vector2f& b)
{
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

/** \brief Leave out points within the octagon of the farthest ones in eight directions:
 * they are not on the hull. */
void
removeInnerPoints(std::vector<Eigen::Vector2f>& points)
{
  const std::array<Eigen::Vector2f, 8> directions = {Eigen::Vector2f(1, 0),
                                                     Eigen::Vector2f(1, 1),
                                                     Eigen::Vector2f(0, 1),
                                                     Eigen::Vector2f(-1, 1),
                                                     Eigen::Vector2f(-1, 0),
                                                     Eigen::Vector2f(-1, -1),
                                                     Eigen::Vector2f(0, -1),
                                                     Eigen::Vector2f(1, -1)};
  std::array<Eigen::Vector2f, 8> corners;
  std::array<float, 8> farthest;
  farthest.fill(-std::numeric_limits<float>::infinity());
  for (const auto& point : points)
    for (std::size_t k = 0; k < 8; ++k)
      if (const float reach = directions[k].dot(point); reach > farthest[k]) {
        farthest[k] = reach;
        corners[k] = point;
      }
  const auto is_inside = [&corners](const Eigen::Vector2f& point) {
    for (std::size_t k = 0; k < 8; ++k) {
      const Eigen::Vector2f side = corners[(k + 1) % 8] - corners[k];
      if (!side.isZero(0.0f) && cross(side, point - corners[k]) <= 0.0f)
        return false;
    }
    return true;
  };
  points.erase(std::remove_if(points.begin(), points.end(), is_inside), points.end());
}

/** \brief Corners of the convex hull against the clock, without points on its sides
 * (Andrew's monotone chain). */
std::vector<Eigen::Vector2f>
convexHull(std::vector<Eigen::Vector2f> points)
{
  removeInnerPoints(points);
  std::sort(points.begin(), points.end(), isBefore);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3)
    return points;
  std::vector<Eigen::Vector2f> hull;
  const auto add = [&hull](const Eigen::Vector2f& point, std::size_t first) {
    while (hull.size() >= first + 2 &&
           cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0f)
      hull.pop_back();
    hull.push_back(point);
  };
  for (const auto& point : points)
    add(point, 0);
  const std::size_t upper = hull.size() - 1;
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point)
    add(*point, upper);
  hull.pop_back();
  return hull;
}

float
logarithm(float metres)
{
  return std::log1p(metres / 0.1f) / std::log(31.0f);
}

} // namespace

Eigen::Vector2f
smallestRectangle(std::vector<Eigen::Vector2f> points)
{
  const auto hull = convexHull(std::move(points));
  const std::size_t count = hull.size();
  if (count < 3)
    return {count == 2 ? (hull[1] - hull[0]).norm() : 0.0f, 0.0f};
  // One side lies on a side of the hull. The farthest corners to the front, above and
  // behind go around with it.
  std::array<std::size_t, 3> far = {1, 1, 1};
  Eigen::Vector2f smallest(std::numeric_limits<float>::infinity(), 1.0f);
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector2f along = (hull[(k + 1) % count] - hull[k]).normalized();
    const Eigen::Vector2f up(-along.y(), along.x());
    const std::array<Eigen::Vector2f, 3> directions = {along, up, -along};
    std::array<float, 3> reach;
    for (std::size_t d = 0; d < 3; ++d) {
      if (d > 0 && k == 0)
        far[d] = far[d - 1];
      for (std::size_t steps = 0; steps < count; ++steps) {
        const auto& next = hull[(far[d] + 1) % count];
        if (directions[d].dot(next - hull[far[d]]) < 0.0f)
          break;
        far[d] = (far[d] + 1) % count;
      }
      reach[d] = directions[d].dot(hull[far[d]] - hull[k]);
    }
    const Eigen::Vector2f sides(reach[0] + reach[2], reach[1]);
    if (sides.prod() < smallest.prod())
      smallest = sides;
  }
  return {smallest.maxCoeff(), smallest.minCoeff()};
}

std::vector<float>
contextValues(const std::vector<OrientedPoint>& points, const ObjectPlace& place)
{
  std::vector<float> values(context_value_count, 0.0f);
  if (!points.empty()) {
    std::vector<Eigen::Vector2f> footprint;
    footprint.reserve(points.size());
    float lowest = std::numeric_limits<float>::infinity();
    float highest = -lowest;
    double sum = 0.0;
    std::array<std::size_t, 2> facing = {0, 0}; // up or down, sideways
    for (const auto& point : points) {
      const float z = point.position.z();
      footprint.push_back(point.position.head<2>());
      lowest = std::min(lowest, z);
      highest = std::max(highest, z);
      sum += z;
      const float steepness = std::abs(point.normal.z());
      facing[0] += steepness >= 0.8660254f; // cosine of 30 degrees
      facing[1] += steepness <= 0.5f;
    }
    const auto count = static_cast<double>(points.size());
    const float height = highest - lowest;
    const Eigen::Vector2f sides = smallestRectangle(std::move(footprint));
    const std::array<float, 3> size = {height, sides[0], sides[1]};
    for (std::size_t k = 0; k < 3; ++k) {
      values[k] = std::min(size[k], longest);
      values[3 + k] = logarithm(values[k]);
    }
    values[6] = static_cast<float>(static_cast<double>(facing[0]) / count);
    values[7] = static_cast<float>(static_cast<double>(facing[1]) / count);
    if (height > 0.0f)
      values[8] =
          std::clamp(static_cast<float>((sum / count - lowest) / height), 0.0f, 1.0f);
  }
  if (place.is_known) {
    const std::array<float, 3> distances = {
        place.floor_distance, place.ceiling_distance, place.wall_distance};
    for (std::size_t k = 0; k < 3; ++k) {
      values[9 + k] = std::clamp(distances[k], 0.0f, longest);
      values[12 + k] = distances[k] < touching ? 1.0f : 0.0f;
    }
    values[15] = 1.0f;
  }
  return values;
}

} // namespace indoor
} // namespace pcl
