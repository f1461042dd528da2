/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/scene_making.h"

#include "objects/structure/camera_view.h"
#include "objects/structure/structure_contacts.h"
#include "objects/structure/structure_islands.h"
#include "objects/structure/voted_structure.h"

#include <pcl/features/normal_orientation.h>
#include <pcl/features/unit_normals.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace {

using pcl::indoor::ObjectSegmentationInput;
using pcl::indoor::ObjectSegmentationOptions;
using pcl::indoor::SurfaceVoxels;

constexpr unsigned fewer_votes = 4; // every 4th ray is enough for large planes

/** Voxels whose points have no normals have those that were estimated, turned as their
 * neighbours. */
void
fillGaps(const std::vector<Eigen::Vector3f>& point_normals,
         const std::vector<Eigen::Vector3f>& estimated,
         SurfaceVoxels& voxels)
{
  std::vector<std::uint8_t> is_given(voxels.size(), 0);
  for (std::size_t i = 0; i < point_normals.size(); ++i)
    is_given[voxels.cells.cell_of_point[i]] |=
        pcl::indoor::isUnitNormal(point_normals[i]);
  const auto given = voxels.normals;
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    if (is_given[v])
      continue;
    Eigen::Vector3f around = Eigen::Vector3f::Zero();
    for (const auto other : voxels.neighbors.of(v))
      around += given[other];
    voxels.normals[v] = around.dot(estimated[v]) < 0 ? -estimated[v] : estimated[v];
  }
}

void
findNormals(const ObjectSegmentationInput& input,
            const ObjectSegmentationOptions& options,
            unsigned thinning,
            SurfaceVoxels& voxels)
{
  pcl::indoor::estimateNormals(input.points, voxels, options.threads);
  if (!input.normals.empty()) {
    const auto estimated = std::move(voxels.normals);
    pcl::indoor::averageNormals(input.normals, voxels);
    fillGaps(input.normals, estimated, voxels);
    return;
  }
  pcl::indoor::FreeSpaceOptions free_space;
  free_space.cell_size = 2 * options.voxel_size;
  free_space.threads = options.threads;
  free_space.sample_stride *= thinning;
  pcl::indoor::orientNormals(options.orientation,
                             voxels.centroids,
                             voxels.neighbors,
                             input.viewpoint,
                             free_space,
                             voxels.normals);
}

bool
mayHaveStructure(const ObjectSegmentationInput& input,
                 const ObjectSegmentationOptions& options)
{
  return options.pieces.scale != pcl::indoor::JoiningScale::View &&
         input.capture != pcl::indoor::Capture::TableView;
}

} // namespace

namespace pcl::indoor {

std::vector<std::uint8_t>
ObjectScene::structureFlags() const
{
  std::vector<std::uint8_t> flags;
  flags.reserve(plane_of_voxel.size());
  for (const auto plane : plane_of_voxel)
    flags.push_back(plane != 0);
  return flags;
}

bool
isConsistent(const ObjectScene& scene, std::size_t label_count)
{
  const auto& voxels = scene.voxels;
  const auto count = scene.points.size();
  return voxels.cells.cell_of_point.size() == count && label_count == count &&
         scene.plane_of_voxel.size() == voxels.size() &&
         voxels.normals.size() == voxels.size() && scene.voxel_size > 0 &&
         std::abs(scene.up.norm() - 1) < 1e-3f;
}

std::vector<Eigen::Vector3f>
gridPoints(const ObjectSegmentationInput& input)
{
  const auto steepest = static_cast<float>(std::tan(widest_view * M_PI / 180));
  std::vector<Eigen::Vector3f> grid_points;
  if (input.capture != Capture::TableView)
    return grid_points;
  grid_points.reserve(input.points.size());
  for (const auto& point : input.points) {
    const Eigen::Vector3f ray = point - input.viewpoint.front();
    const float depth =
        std::max({ray.z(), ray.head<2>().norm() / steepest, least_camera_distance});
    grid_points.emplace_back(ray.x() / depth, ray.y() / depth, std::log(depth));
  }
  return grid_points;
}

RawScene
makeRawScene(const ObjectSegmentationInput& input,
             const ObjectSegmentationOptions& options)
{
  RawScene raw;
  raw.up = input.up;
  raw.voxel_size = options.voxel_size;
  raw.voxels = surfaceVoxels(input.points, gridPoints(input), options.voxel_size);
  const bool has_structure = mayHaveStructure(input, options);
  findNormals(input, options, has_structure ? fewer_votes : 1, raw.voxels);
  if (input.capture == Capture::RoomView)
    raw.up = upOfView(raw.voxels.normals);
  if (has_structure)
    raw.planes =
        findRoomStructure(raw.voxels, options.voxel_size, raw.up, input.capture);
  return raw;
}

ObjectScene
makeObjectScene(ObjectSegmentationInput input,
                RawScene raw,
                const VoxelClasses& votes,
                const ObjectSegmentationOptions& options)
{
  ObjectScene scene;
  scene.up = raw.up;
  scene.capture = input.capture;
  scene.voxel_size = options.voxel_size;
  scene.threads = options.threads;
  scene.planes = std::move(raw.planes);
  if (scene.planes.empty()) {
    scene.voxels = std::move(raw.voxels);
    if (options.voxel_size != raw.voxel_size) {
      scene.voxels = surfaceVoxels(input.points, gridPoints(input), options.voxel_size);
      findNormals(input, options, 1, scene.voxels);
    }
    scene.plane_of_voxel.assign(scene.voxels.size(), 0);
    scene.points = std::move(input.points);
    return scene;
  }
  auto plane_of_point =
      pointsOfStructure(input.points, raw.voxels, scene.planes, raw.voxel_size);
  if (votes.class_count > 0)
    yieldToVotes(votes, plane_of_point);
  scene.voxels = separateVoxels(
      input.points, plane_of_point, options.voxel_size, scene.plane_of_voxel);
  findNormals(input, options, 1, scene.voxels);
  scene.points = std::move(input.points);
  const double seed_voxels = options.seed_size / options.voxel_size;
  constexpr double largest = 1e9; // voxels, more than there are
  const auto patch =
      static_cast<std::size_t>(std::min(seed_voxels * seed_voxels, largest));
  returnIslands(patch, options.min_segment_size * patch, scene);
  yieldContacts(raw.voxels, votes, scene);
  return scene;
}

} // namespace pcl::indoor
