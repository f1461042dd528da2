/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/split/flat_objects.h"

#include "objects/graph/segment_members.h"
#include "objects/split/height_map.h"
#include "objects/structure/plane_growing.h"

#include <pcl/indoor/ground_frame.h>
#include <pcl/indoor/quantile.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace {

using pcl::indoor::deviation_per_median;
using pcl::indoor::HeightMap;
using pcl::indoor::normal_cosine;
using pcl::indoor::ObjectScene;
using pcl::indoor::quantile;

constexpr double most_cells = 1 << 22;
constexpr int fit_rounds = 5;
constexpr double max_height = 0.12; // metres; what is higher has sides that part it

/** A plane over the ground: height = slope * place + offset. */
struct Level {
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  double offset = 0;

  double
  above(const Eigen::Vector3d& place) const
  {
    return place.z() - slope.dot(place.head<2>()) - offset;
  }
};

Level
fitted(const std::vector<Eigen::Vector3d>& places)
{
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d products = Eigen::Vector3d::Zero();
  for (const auto& place : places) {
    const Eigen::Vector3d ground(place.x(), place.y(), 1);
    squares += ground * ground.transpose();
    products += place.z() * ground;
  }
  const Eigen::Vector3d solution = squares.ldlt().solve(products);
  Level level;
  level.slope = solution.head<2>();
  level.offset = solution.z();
  return level;
}

/** Plane through most of the places; what lies on it counts less and less. */
Level
fitLevel(const std::vector<Eigen::Vector3d>& places, double least_deviation)
{
  auto kept = places;
  Level level;
  std::vector<double> heights;
  for (int round = 0; round < fit_rounds && kept.size() >= 3; ++round) {
    level = fitted(kept);
    heights.clear();
    for (const auto& place : kept)
      heights.push_back(level.above(place));
    const double middle = quantile(heights, 0.5);
    level.offset += middle;
    heights.clear();
    for (const auto& place : kept)
      heights.push_back(std::abs(level.above(place)));
    const double deviation =
        std::max(deviation_per_median * quantile(heights, 0.5), least_deviation);
    kept.clear();
    for (const auto& place : places)
      if (std::abs(level.above(place)) < 2.5 * deviation)
        kept.push_back(place);
  }
  return level;
}

/** The places at the height where most of them lie, within a voxel and a half. */
std::vector<Eigen::Vector3d>
mostCommonHeight(const std::vector<Eigen::Vector3d>& places, double voxel_size)
{
  const double bin = voxel_size / 2;
  double lowest = places.front().z(), highest = lowest;
  for (const auto& place : places) {
    lowest = std::min(lowest, place.z());
    highest = std::max(highest, place.z());
  }
  const auto bin_of = [&](const Eigen::Vector3d& place) {
    return static_cast<std::size_t>((place.z() - lowest) / bin) + 1;
  };
  std::vector<std::uint32_t> counts(
      static_cast<std::size_t>((highest - lowest) / bin) + 3, 0);
  for (const auto& place : places)
    ++counts[bin_of(place)];
  std::size_t best = 1;
  const auto around = [&](std::size_t b) {
    return counts[b - 1] + counts[b] + counts[b + 1];
  };
  for (std::size_t b = 1; b + 1 < counts.size(); ++b)
    if (around(b) > around(best))
      best = b;
  std::vector<Eigen::Vector3d> chosen;
  for (const auto& place : places)
    if (bin_of(place) + 1 >= best && bin_of(place) <= best + 1)
      chosen.push_back(place);
  return chosen;
}

/** Looks for objects on the segments, one after the other. */
class ObjectFinder {
public:
  explicit ObjectFinder(const ObjectScene& scene)
  : scene_(scene)
  , frame_(pcl::indoor::groundFrame(scene.up))
  {}

  /** \return the objects' points, one list per object */
  std::vector<std::vector<std::uint32_t>>
  objectsOn(const std::vector<std::uint32_t>& members) const
  {
    std::vector<Eigen::Vector3d> level_places;
    for (const auto v : members)
      if (std::abs(scene_.voxels.normals[v].dot(scene_.up)) > normal_cosine)
        level_places.push_back(placeOf(scene_.voxels.centroids[v]));
    if (level_places.size() < pcl::indoor::min_object_surface)
      return {};
    level_places = mostCommonHeight(level_places, scene_.voxel_size);
    if (level_places.size() < pcl::indoor::min_object_surface)
      return {};
    const Level level = fitLevel(level_places, scene_.voxel_size / 30);
    HeightMap map(level_places, scene_.voxel_size);
    if (map.cellCount() > most_cells)
      return {};
    const auto candidates = pointsAbove(members, level, map);
    const auto object_of_cell = map.findObjects();
    std::vector<std::vector<std::uint32_t>> objects(map.objectCount());
    for (const auto& [point, cell] : candidates)
      if (object_of_cell[cell] != 0)
        objects[object_of_cell[cell] - 1].push_back(point);
    return objects;
  }

private:
  Eigen::Vector3d
  placeOf(const Eigen::Vector3f& position) const
  {
    return frame_ * position.cast<double>();
  }

  /** Points on the surface and above it with their cells; their heights go into the
   * map. */
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
  pointsAbove(const std::vector<std::uint32_t>& members,
              const Level& level,
              HeightMap& map) const
  {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    const auto& cells = scene_.voxels.cells;
    for (const auto v : members)
      for (const auto point : cells.pointsOf(v)) {
        const Eigen::Vector3d place = placeOf(scene_.points[point]);
        const double height = level.above(place);
        std::uint32_t cell = 0;
        if (!(height > -scene_.voxel_size / 2) || !map.find(place.head<2>(), cell))
          continue;
        if (height <= max_height)
          map.add(cell, height);
        found.emplace_back(point, cell);
      }
    return found;
  }

  const ObjectScene& scene_;
  Eigen::Matrix3d frame_;
};

} // namespace

namespace pcl::indoor {

std::vector<std::uint32_t>
partFlatObjects(const ObjectScene& scene,
                const std::vector<std::uint32_t>& segment_of_voxel)
{
  assert(isConsistent(scene, scene.points.size()));
  const auto& voxels = scene.voxels;
  assert(segment_of_voxel.size() == voxels.size());
  std::vector<std::uint32_t> segment_of_point(scene.points.size());
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    segment_of_point[i] = segment_of_voxel[voxels.cells.cell_of_point[i]];
  if (voxels.size() == 0)
    return segment_of_point;
  const auto members = membersOfSegments(scene.structureFlags(), segment_of_voxel);
  auto next = static_cast<std::uint32_t>(members.size());
  const ObjectFinder finder(scene);
  for (const auto& segment : members) {
    for (const auto& object : finder.objectsOn(segment)) {
      for (const auto point : object)
        segment_of_point[point] = next;
      ++next;
    }
  }
  return segment_of_point;
}

} // namespace pcl::indoor
