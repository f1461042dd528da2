/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/object_context.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::indoor {

namespace {

constexpr float longest = 4.0f;  // metres; of larger objects the size says no more
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

using Outline = std::vector<Eigen::Vector2f>;

/** \brief Add the corners of the hull between two of it, of points right of them. */
void
addCorners(Outline::iterator first,
           Outline::iterator last,
           const Eigen::Vector2f& from,
           const Eigen::Vector2f& to,
           float tolerance,
           Outline& hull)
{
  const Eigen::Vector2f side = to - from;
  float farthest = tolerance * side.norm();
  auto corner = last;
  for (auto point = first; point != last; ++point)
    if (const float reach = -cross(side, *point - from); reach > farthest) {
      farthest = reach;
      corner = point;
    }
  if (corner == last)
    return;
  const Eigen::Vector2f place = *corner;
  const auto is_right_of = [](const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
    return [a, side = Eigen::Vector2f(b - a)](const Eigen::Vector2f& point) {
      return cross(side, point - a) < 0.0f;
    };
  };
  const auto middle = std::partition(first, last, is_right_of(from, place));
  const auto end = std::partition(middle, last, is_right_of(place, to));
  addCorners(first, middle, from, place, tolerance, hull);
  hull.push_back(place);
  addCorners(middle, end, place, to, tolerance, hull);
}

/** \brief Corners of the convex hull against the clock (Barber et al. 1996), less those
 * that stand out by no more than 1e-5 of its extent. */
Outline
convexHull(Outline points)
{
  if (points.empty())
    return points;
  const auto ends = std::minmax_element(points.begin(), points.end(), isBefore);
  const Eigen::Vector2f left = *ends.first;
  const Eigen::Vector2f right = *ends.second;
  if (left == right)
    return {left};
  float reach = right.x() - left.x();
  for (const auto& point : points)
    reach = std::max(reach, std::abs(point.y() - left.y()));
  const float tolerance = 1e-5f * reach;
  const Eigen::Vector2f side = right - left;
  const auto middle =
      std::partition(points.begin(), points.end(), [&](const Eigen::Vector2f& point) {
        return cross(side, point - left) < 0.0f;
      });
  Outline hull = {left};
  addCorners(points.begin(), middle, left, right, tolerance, hull);
  hull.push_back(right);
  addCorners(middle, points.end(), right, left, tolerance, hull);
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
    values[9] = std::clamp(place.floor_distance, 0.0f, longest);
    values[10] = place.floor_distance < touching ? 1.0f : 0.0f;
    values[11] = 1.0f;
  }
  return values;
}

} // namespace pcl::indoor
