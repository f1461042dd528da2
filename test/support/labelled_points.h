/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace pcl::indoor {
namespace test {

/** Points of surfaces with the number of the object that each belongs to, from 1. */
struct LabelledPoints {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> normals; ///< outwards
  std::vector<std::uint32_t> objects;

  /** A rectangle from a corner along two edges, one point per spacing, with noise. */
  void
  addRectangle(const Eigen::Vector3f& corner,
               const Eigen::Vector3f& u,
               const Eigen::Vector3f& v,
               const Eigen::Vector3f& normal,
               std::uint32_t object,
               float spacing,
               float noise,
               std::mt19937& rng)
  {
    const auto steps = [&](const Eigen::Vector3f& edge) {
      return static_cast<int>(edge.norm() / spacing);
    };
    const auto random = [&] { return static_cast<float>(rng() % 2001) / 1000 - 1; };
    for (int i = 0; i <= steps(u); ++i)
      for (int j = 0; j <= steps(v); ++j) {
        const Eigen::Vector3f place =
            corner + u * (static_cast<float>(i) / static_cast<float>(steps(u))) +
            v * (static_cast<float>(j) / static_cast<float>(steps(v)));
        points.push_back(place + normal * (noise * random()));
        normals.push_back(normal);
        objects.push_back(object);
      }
  }

  template <typename Predicate>
  void
  removeIf(const Predicate& predicate)
  {
    LabelledPoints kept;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!predicate(points[i])) {
        kept.points.push_back(points[i]);
        kept.normals.push_back(normals[i]);
        kept.objects.push_back(objects[i]);
      }
    *this = std::move(kept);
  }

  /** \param[in] order indices of points; some may have no normals or objects */
  LabelledPoints
  reordered(const std::vector<std::size_t>& order) const
  {
    LabelledPoints result;
    for (const auto i : order) {
      result.points.push_back(points[i]);
      if (!normals.empty())
        result.normals.push_back(normals[i]);
      if (!objects.empty())
        result.objects.push_back(objects[i]);
    }
    return result;
  }

  void
  turn(const Eigen::Matrix3f& rotation)
  {
    for (auto& point : points)
      point = rotation * point;
    for (auto& normal : normals)
      normal = rotation * normal;
  }

  /** A side of a room, with the noise of a scan. */
  void
  addRoomSide(const Eigen::Vector3f& corner,
              const Eigen::Vector3f& u,
              const Eigen::Vector3f& v,
              const Eigen::Vector3f& normal,
              std::uint32_t object,
              std::mt19937& rng)
  {
    addRectangle(corner, u, v, normal, object, 0.015f, 0.003f, rng);
  }

  /** The top and the four sides of a box. */
  void
  addBox(const Eigen::Vector3f& low,
         const Eigen::Vector3f& size,
         std::uint32_t object,
         float spacing,
         float noise,
         std::mt19937& rng)
  {
    const Eigen::Vector3f x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
    const auto unit = [](int axis, float sign) {
      return Eigen::Vector3f(sign * Eigen::Vector3f::Unit(axis));
    };
    addRectangle(low + z, x, y, unit(2, 1), object, spacing, noise, rng);
    addRectangle(low, x, z, unit(1, -1), object, spacing, noise, rng);
    addRectangle(low + y, x, z, unit(1, 1), object, spacing, noise, rng);
    addRectangle(low, y, z, unit(0, -1), object, spacing, noise, rng);
    addRectangle(low + x, y, z, unit(0, 1), object, spacing, noise, rng);
  }
};

/** A floor (object 1) with two boxes on it (2 and 3), 1.2 m apart. */
inline LabelledPoints
floorWithTwoBoxes(float noise = 0.003f, float spacing = 0.015f)
{
  std::mt19937 rng(7);
  LabelledPoints scene;
  scene.addRectangle(
      {0, 0, 0}, {4, 0, 0}, {0, 2.5f, 0}, {0, 0, 1}, 1, spacing, noise, rng);
  // No scanner sees the floor under the boxes.
  const auto covered = [](const Eigen::Vector3f& p) {
    return (p.x() > 0.5f && p.x() < 1.3f && p.y() > 0.8f && p.y() < 1.5f) ||
           (p.x() > 2.5f && p.x() < 3.2f && p.y() > 0.6f && p.y() < 1.6f);
  };
  scene.removeIf(covered);
  scene.addBox({0.5f, 0.8f, 0}, {0.8f, 0.7f, 0.6f}, 2, spacing, noise, rng);
  scene.addBox({2.5f, 0.6f, 0}, {0.7f, 1.0f, 0.5f}, 3, spacing, noise, rng);
  return scene;
}

/** Labels renamed to 1, 2, ... in the order of their first places; 0 stays. */
inline std::vector<std::uint32_t>
renamed(const std::vector<std::uint32_t>& labels)
{
  std::map<std::uint32_t, std::uint32_t> names{{0, 0}};
  std::vector<std::uint32_t> result;
  for (const auto label : labels) {
    const auto next = static_cast<std::uint32_t>(names.size());
    result.push_back(names.emplace(label, next).first->second);
  }
  return result;
}

/** How many different labels there are. */
inline std::size_t
segmentCount(const std::vector<std::uint32_t>& labels)
{
  return std::set<std::uint32_t>(labels.begin(), labels.end()).size();
}

/** Portable shuffle: std::shuffle gives another order with another library. */
inline std::vector<std::size_t>
shuffledOrder(std::size_t count, std::mt19937& rng)
{
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i)
    order[i] = i;
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[rng() % i]);
  return order;
}

} // namespace test
} // namespace pcl::indoor
