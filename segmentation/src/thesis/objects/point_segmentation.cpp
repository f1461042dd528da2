/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "thesis/objects/point_segmentation.h"

#include "objects/graph/point_recovery.h"
#include "objects/structure/camera_view.h"
#include "objects/voxel_votes.h"
#include "thesis/objects/edge_partition.h"
#include "thesis/objects/point_surface.h"
#include "thesis/objects/ransac_planes.h"
#include "thesis/objects/shape_supervoxels.h"
#include "thesis/objects/upstream_supervoxels.h"

#include <pcl/features/normal_orientation.h>
#include <pcl/filters/non_convex_points.h>
#include <pcl/indoor/neighbor_distance.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace {

using namespace pcl::indoor;

constexpr unsigned side_by_side = 8; // closest points that agree about a surface's side

/** Points with normals and curvatures (Sec. 2.1.5.2), with colours if they have a
 * weight, and planes by RANSAC. */
ObjectScene
makeScene(ObjectSegmentationInput& input,
          const thesis::ObjectOptions& options,
          double radius)
{
  ObjectScene scene;
  scene.up = input.up;
  scene.capture = input.capture;
  scene.voxel_size = options.shared.voxel_size;
  scene.threads = options.shared.threads;
  scene.voxels = pointsAsVoxels(input.points);
  estimatePointNormals(radius, options.shared.threads, scene.voxels);
  if (input.capture == Capture::RoomView)
    scene.up = upOfView(scene.voxels.normals);
  if (!input.normals.empty())
    scene.voxels.normals = std::move(input.normals);
  else {
    FreeSpaceOptions free_space;
    free_space.cell_size = 2 * options.shared.voxel_size;
    free_space.threads = options.shared.threads;
    orientNormals(options.shared.orientation,
                  input.points,
                  nearestNeighbors(input.points, side_by_side, options.shared.threads),
                  input.viewpoint,
                  free_space,
                  scene.voxels.normals);
  }
  if (options.on_points->color_weight > 0) {
    auto& colors = scene.voxels.appearance.colors;
    colors.resize(3, static_cast<Eigen::Index>(input.colors.size()));
    for (std::size_t i = 0; i < input.colors.size(); ++i)
      colors.col(static_cast<Eigen::Index>(i)) = labOfRgb(input.colors[i]);
  }
  scene.plane_of_voxel.assign(input.points.size(), 0);
  if (options.on_points->ransac_share > 0)
    scene.planes = ransacPlanes(input.points,
                                options.shared.voxel_size,
                                options.on_points->ransac_share,
                                scene.plane_of_voxel);
  scene.points = std::move(input.points);
  return scene;
}

/** The non-convex points that are in no plane, Eq. (4.2): planes are no neighbours. */
std::vector<std::uint8_t>
removedOf(const ObjectScene& scene, const thesis::ObjectOptions& options, double radius)
{
  std::vector<std::uint32_t> others;
  std::vector<Eigen::Vector3f> points, normals;
  std::vector<float> curvatures;
  for (std::uint32_t i = 0; i < scene.points.size(); ++i)
    if (scene.plane_of_voxel[i] == 0) {
      others.push_back(i);
      points.push_back(scene.points[i]);
      normals.push_back(scene.voxels.normals[i]);
      curvatures.push_back(scene.voxels.curvatures[i]);
    }
  NonConvexityOptions removal;
  removal.radius = radius;
  removal.curvature_threshold = options.shared.curvature_threshold;
  removal.ratio_threshold = options.shared.ratio_threshold;
  removal.threads = options.shared.threads;
  const auto found = nonConvexPoints(points, normals, curvatures, removal);
  std::vector<std::uint8_t> removed(scene.points.size(), 0);
  for (std::size_t i = 0; i < others.size(); ++i)
    removed[others[i]] = found[i];
  return removed;
}

/** Algorithm 1: the points without a segment take part, the planes do not. */
void
recover(const ObjectScene& scene,
        const thesis::ObjectOptions& options,
        std::vector<std::uint32_t>& segments)
{
  std::vector<std::uint32_t> others;
  std::vector<Eigen::Vector3f> points, normals;
  std::vector<std::uint32_t> labels;
  std::vector<std::uint8_t> open;
  for (std::uint32_t i = 0; i < segments.size(); ++i)
    if (scene.plane_of_voxel[i] == 0) {
      others.push_back(i);
      points.push_back(scene.points[i]);
      normals.push_back(scene.voxels.normals[i]);
      labels.push_back(segments[i]);
      open.push_back(segments[i] == Supervoxels::none);
    }
  recoverLabels(points,
                normals,
                neighborsWithin(points, options.shared.voxel_size, open),
                distanceOf(options),
                labels,
                recovery_rounds);
  for (std::size_t i = 0; i < others.size(); ++i)
    segments[others[i]] = labels[i];
}

/** Number the segments by their first points and say which ones are planes. */
void
finish(DetailedSegmentation& result)
{
  const auto& scene = result.scene;
  auto& segments = result.segment_of_point;
  std::uint32_t highest = 0;
  for (const auto segment : segments)
    highest = segment == Supervoxels::none ? highest : std::max(highest, segment + 1);
  std::vector<std::uint32_t> number(highest + scene.planes.size(), Supervoxels::none);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto plane = scene.plane_of_voxel[i];
    const auto segment = plane != 0 ? highest + plane - 1 : segments[i];
    if (segment == Supervoxels::none)
      continue;
    if (number[segment] == Supervoxels::none) {
      number[segment] = result.segment_count++;
      result.structure_of_segment.push_back(
          plane != 0 ? kindOf(scene.planes[plane - 1], scene.up) : StructureKind::None);
    }
    segments[i] = number[segment];
  }
}

} // namespace

namespace pcl::indoor {

DetailedSegmentation
segmentOnPoints(ObjectSegmentationInput input,
                const thesis::ObjectOptions& options,
                const ProgressCallback& progress)
{
  const auto stops = [&progress](double share, const char* stage) {
    return progress && !progress(share, stage);
  };
  DetailedSegmentation result;
  if (stops(0, "normals and planes"))
    return {};
  double radius = options.on_points->removal_radius > 0
                      ? options.on_points->removal_radius
                      : neighborhoodRadius(input.points, options.shared.threads);
  if (!(radius > 0)) // no two different points: no neighbourhood
    radius = options.shared.voxel_size;
  std::optional<Eigen::Vector3f> camera;
  if (input.capture == Capture::TableView)
    camera = input.viewpoint.front();
  result.scene = makeScene(input, options, radius);
  if (stops(0.4, "removal"))
    return {};
  result.removed = removedOf(result.scene, options, radius);
  auto left_out = result.scene.structureFlags();
  for (std::size_t i = 0; i < left_out.size(); ++i)
    left_out[i] |= result.removed[i];
  if (stops(0.5, "supervoxels"))
    return {};
  const auto partition_points =
      options.on_points->fpfh_weight > 0 ? partitionByShapes : partitionWithUpstream;
  auto partition = partition_points(result.scene.voxels, left_out, camera, options);
  for (const auto label : partition.supervoxels.label_of_voxel)
    result.segment_of_point.push_back(
        label == Supervoxels::none ? label : partition.segment_of_supervoxel[label]);
  result.supervoxels = std::move(partition.supervoxels);
  result.edges = std::move(partition.edges);
  if (stops(0.8, "recovery"))
    return {};
  recover(result.scene, options, result.segment_of_point);
  finish(result);
  const auto& scene = result.scene;
  result.votes = votesFor(scene.points, scene.planes, scene.up, input.voter);
  if (stops(1, "done"))
    return {};
  return result;
}

} // namespace pcl::indoor
