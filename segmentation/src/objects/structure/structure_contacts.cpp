/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/structure_contacts.h"

#include "objects/structure/voted_structure.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace {

using pcl::indoor::Adjacency;
using pcl::indoor::same_surface_voxels;
using pcl::indoor::StructurePlane;
using pcl::indoor::SurfaceVoxels;
using pcl::indoor::VoxelClasses;

/** The objects' voxels that have points in each of the surrounding voxels. */
Adjacency
objectsIn(const SurfaceVoxels& surroundings,
          const SurfaceVoxels& voxels,
          const std::vector<std::uint32_t>& plane_of_voxel)
{
  Adjacency objects;
  auto& offsets = objects.offsets;
  offsets.assign(surroundings.size() + 1, 0);
  std::vector<std::uint32_t> last(surroundings.size(), 0); // to have entered it, from 1
  const auto for_each = [&](const auto& enter) {
    std::fill(last.begin(), last.end(), 0);
    for (std::uint32_t v = 0; v < voxels.size(); ++v) {
      if (plane_of_voxel[v] != 0 || voxels.normals[v].isZero())
        continue;
      for (const auto point : voxels.cells.pointsOf(v)) {
        const auto place = surroundings.cells.cell_of_point[point];
        if (last[place] == v + 1)
          continue;
        last[place] = v + 1;
        enter(place, v);
      }
    }
  };
  for_each([&](std::uint32_t place, std::uint32_t) { ++offsets[place + 1]; });
  for (std::size_t place = 0; place < surroundings.size(); ++place)
    offsets[place + 1] += offsets[place];
  objects.targets.resize(offsets.back());
  auto next = offsets;
  for_each([&](std::uint32_t place, std::uint32_t v) {
    objects.targets[next[place]++] = v;
  });
  return objects;
}

/** The objects' voxels in one of the surrounding voxels and those that touch it. */
void
gatherAround(std::uint32_t place,
             const SurfaceVoxels& surroundings,
             const Adjacency& objects,
             std::vector<std::uint32_t>& found)
{
  found.clear();
  const auto add = [&](std::uint32_t cell) {
    found.insert(found.end(), objects.of(cell).begin(), objects.of(cell).end());
  };
  add(place);
  const auto& around = surroundings.neighbors;
  for (const auto other : around.of(place))
    add(other);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

bool
isBuilding(const VoxelClasses& votes, std::size_t point)
{
  return votes.class_count > 0 &&
         votes.buildingShare(point) > pcl::indoor::least_building_share;
}

/** The voxel whose surface a point is nearest to; its own if that is the plane's. */
std::uint32_t
nearestSurface(const Eigen::Vector3f& point,
               const StructurePlane& plane,
               std::uint32_t own,
               const std::vector<std::uint32_t>& around,
               const SurfaceVoxels& voxels,
               double voxel_size)
{
  auto nearest = own;
  double least = std::abs(plane.heightOf(point.cast<double>()));
  for (const auto v : around) {
    const Eigen::Vector3d way = (point - voxels.centroids[v]).cast<double>();
    const double distance = std::abs(voxels.normals[v].cast<double>().dot(way));
    if (distance < least && way.norm() <= same_surface_voxels * voxel_size) {
      least = distance;
      nearest = v;
    }
  }
  return nearest;
}

} // namespace

namespace pcl::indoor {

std::size_t
yieldContacts(const SurfaceVoxels& surroundings,
              const VoxelClasses& votes,
              ObjectScene& scene)
{
  assert(isConsistent(scene, surroundings.cells.cell_of_point.size()));
  auto& voxels = scene.voxels;
  const auto& plane_of_voxel = scene.plane_of_voxel;
  const auto objects = objectsIn(surroundings, voxels, plane_of_voxel);
  std::vector<std::uint32_t> around;
  std::size_t yielded = 0;
  for (std::uint32_t place = 0; place < surroundings.size(); ++place) {
    bool gathered = false;
    const auto& cells = surroundings.cells;
    for (const auto point : cells.pointsOf(place)) {
      auto& voxel = voxels.cells.cell_of_point[point];
      if (plane_of_voxel[voxel] == 0 || isBuilding(votes, point))
        continue;
      if (!gathered)
        gatherAround(place, surroundings, objects, around);
      gathered = true;
      const auto nearest = nearestSurface(scene.points[point],
                                          scene.planes[plane_of_voxel[voxel] - 1],
                                          voxel,
                                          around,
                                          voxels,
                                          scene.voxel_size);
      yielded += nearest != voxel;
      voxel = nearest;
    }
  }
  listPoints(voxels.cells);
  return yielded;
}

} // namespace pcl::indoor
