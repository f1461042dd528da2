/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/mesh_sampling.h"

#include "files/random_numbers.h"

#include <pcl/exceptions.h>

#include <Eigen/Geometry> // for cross

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace pcl::indoor::tool {
namespace {

/** \brief A triangle's first corner and the two edges that leave it. */
struct Corner {
  Eigen::Vector3d origin, first, second;
};

Corner
cornerOf(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle)
{
  for (const auto index : triangle)
    if (index >= mesh.vertices.size())
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "a triangle names vertex " + std::to_string(index) + " of " +
                              std::to_string(mesh.vertices.size()));
  const Eigen::Vector3d origin = mesh.vertices[triangle[0]].cast<double>();
  return {origin,
          mesh.vertices[triangle[1]].cast<double>() - origin,
          mesh.vertices[triangle[2]].cast<double>() - origin};
}

/** \brief Evenly over the triangle: the square root spreads the distance from the
 * corner as the triangle widens with it. */
OrientedPoint
drawWithin(const Corner& corner, std::mt19937& rng)
{
  const double distance = std::sqrt(uniform(rng));
  const double side = uniform(rng);
  OrientedPoint point;
  point.position =
      (corner.origin + distance * ((1.0 - side) * corner.first + side * corner.second))
          .cast<float>();
  point.normal = corner.first.cross(corner.second).normalized().cast<float>();
  return point;
}

} // namespace

std::vector<OrientedPoint>
sampleMesh(const Mesh& mesh, std::size_t count, std::uint32_t seed)
{
  std::vector<double> area_until; // of all triangles up to and with this one, doubled
  double area = 0.0;
  for (const auto& triangle : mesh.triangles) {
    const auto corner = cornerOf(mesh, triangle);
    const double own = corner.first.cross(corner.second).norm();
    if (std::isfinite(own))
      area += own;
    area_until.push_back(area);
  }
  if (!(area > 0.0))
    PCL_THROW_EXCEPTION(BadArgumentException, "no triangle has an area");
  std::mt19937 rng(seed);
  std::vector<OrientedPoint> points;
  points.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double place =
        area * (static_cast<double>(k) + uniform(rng)) / static_cast<double>(count);
    auto found = std::upper_bound(area_until.begin(), area_until.end(), place);
    if (found == area_until.end()) // rounded up to the whole area
      found = std::lower_bound(area_until.begin(), area_until.end(), area);
    const auto triangle = static_cast<std::size_t>(found - area_until.begin());
    points.push_back(drawWithin(cornerOf(mesh, mesh.triangles[triangle]), rng));
  }
  return points;
}

} // namespace pcl::indoor::tool
