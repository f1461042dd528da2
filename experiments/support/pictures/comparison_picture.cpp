/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/comparison_picture.h"

#include "objects/graph/surface_voxels.h"
#include "pictures/cloud_picture.h"

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/features/normal_orientation.h>
#include <pcl/indoor/point_resolution.h>

#include <algorithm>

namespace pcl::indoor::tool {
namespace {

constexpr int tile_width = 420, tile_height = 340;
constexpr double title_height = 30.0, gap = 10.0;

/** The normal of the surface at each point; zero where the point is not finite. */
std::vector<Eigen::Vector3f>
surfaceNormals(const std::vector<Eigen::Vector3f>& points, bool single_view)
{
  std::vector<Eigen::Vector3f> finite;
  for (const auto& point : points)
    if (point.allFinite())
      finite.push_back(point);
  const double voxel_size = raisedToResolution(finite, single_view ? 0.01 : 0.03);
  auto voxels = surfaceVoxels(finite, {}, voxel_size);
  estimateNormals(finite, voxels, 0);
  FreeSpaceOptions free_space;
  free_space.cell_size = 2 * voxel_size;
  orientNormals(single_view ? NormalOrientation::Viewpoint
                            : NormalOrientation::FreeSpace,
                voxels.centroids,
                voxels.neighbors,
                {Eigen::Vector3f::Zero()},
                free_space,
                voxels.normals);
  std::vector<Eigen::Vector3f> normals;
  std::size_t next = 0;
  for (const auto& point : points)
    normals.push_back(point.allFinite()
                          ? voxels.normals[voxels.cells.cell_of_point[next++]]
                          : Eigen::Vector3f(Eigen::Vector3f::Zero()));
  return normals;
}

} // namespace

SvgDrawing
drawSideBySide(const PointCloud<PointXYZ>& cloud,
               bool single_view,
               const std::vector<LabelledView>& views)
{
  std::vector<Eigen::Vector3f> points;
  for (const auto& point : cloud)
    points.push_back(isFinite(point) ? Eigen::Vector3f(point.getVector3fMap())
                                     : Eigen::Vector3f::Constant(
                                           std::numeric_limits<float>::quiet_NaN()));
  const auto normals = surfaceNormals(points, single_view);
  const auto view =
      single_view ? CloudView::fromCamera(points, normals, tile_width, tile_height)
                  : CloudView::fromAbove(points, normals, tile_width, tile_height);
  SvgDrawing drawing(static_cast<double>(views.size()) * (tile_width + gap) - gap,
                     title_height + tile_height);
  double left = 0.0;
  for (const auto& labelled : views) {
    const auto& truth = views.front().labels;
    auto labels = namedAsTruth(truth, labelled.labels);
    for (std::size_t i = 0; i < labels.size(); ++i)
      labels[i] = truth[i] == 0 ? 0 : labels[i]; // grey: not scored
    drawing.image({left, title_height}, view.draw(labels));
    drawing.text(
        {left + 6.0, 0.5 * title_height}, labelled.title, {Anchor::Start, 18.0});
    left += tile_width + gap;
  }
  return drawing;
}

} // namespace pcl::indoor::tool
